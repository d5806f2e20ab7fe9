// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/map_file.h"

#include <opencv2/imgcodecs.hpp>

#include <QtTest>

#include "cad2slam/mesh/mesh_builder.h"
#include "support/temporary_folder.h"

using namespace cad2slam;

namespace {

MapMetadata metadataWith(const std::filesystem::path& image) {
  MapMetadata metadata;
  metadata.image = image;
  metadata.metric_from_corner = {{-1.0, 2.0}, 0.0};
  return metadata;
}

/// Occupied on the left, unknown in the middle, free on the right.
cv::Mat threeStripes(int rows = 6) {
  cv::Mat image(rows, 9, CV_8UC1, cv::Scalar(205));
  image.colRange(0, 3).setTo(0);
  image.colRange(6, 9).setTo(254);
  return image;
}

bool hasThreeStripes(const OccupancyGrid& grid) {
  for (int row = 0; row < grid.frame().height(); ++row) {
    for (int column = 0; column < 9; ++column) {
      const CellState expected = column < 3   ? CellState::kOccupied
                                 : column < 6 ? CellState::kUnknown
                                              : CellState::kFree;
      if (grid.at(column, row) != expected) return false;
    }
  }
  return grid.frame().width() == 9;
}

bool samePixels(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

}  // namespace

class MapFileTest : public QObject {
  Q_OBJECT

 private slots:
  void everyFormatIsRead_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"a.png", "a.pgm", "a.bmp", "a.tif", "a.tiff", "a.jpg"}) QTest::newRow(name) << name;
  }
  void everyFormatIsRead() {
    QFETCH(QString, name);
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path(name.toStdString());
    QVERIFY(cv::imwrite(path.string(), threeStripes(), {cv::IMWRITE_JPEG_QUALITY, 100}));
    MapMetadata metadata = metadataWith(path);
    if (name.endsWith("jpg")) metadata.free_threshold = 0.1;  // lossy: 205 is not exact
    const Result<LoadedMap> map = loadMap(metadata);
    QVERIFY2(map, map ? "" : map.error().sentence().c_str());
    QVERIFY(hasThreeStripes(map->grid));
    QVERIFY((map->grid.frame().metricFromPixel({0.0, 6.0}) - Eigen::Vector2d(-1.0, 2.0)).norm() < 1e-12);
    const Result<MapFrame> frame = readMapFrame(metadata);
    QCOMPARE(frame->width(), 9);
    QCOMPARE(frame->height(), 6);
  }

  void picturesRoundTrip_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("type");
    QTest::newRow("grey") << "a.png" << CV_8UC1;
    QTest::newRow("colour") << "a.png" << CV_8UC3;
    QTest::newRow("alpha") << "a.png" << CV_8UC4;
    QTest::newRow("wide grey") << "a.png" << CV_16UC1;
    QTest::newRow("wide colour") << "a.png" << CV_16UC3;
    QTest::newRow("PGM") << "a.pgm" << CV_8UC1;
    QTest::newRow("wide PGM") << "a.PGM" << CV_16UC1;
  }
  void picturesRoundTrip() {
    QFETCH(QString, name);
    QFETCH(int, type);
    const test::TemporaryFolder folder;
    cv::Mat picture(13, 7, type);
    cv::randu(picture, 0, CV_MAT_DEPTH(type) == CV_8U ? 256 : 65536);
    MapMetadata metadata;
    metadata.resolution_m_per_px = 0.0125;
    metadata.metric_from_corner = {{-21.234, 1e-7}, 0.1};
    metadata.negate = true;
    metadata.mode = MapMode::kScale;
    metadata.occupied_threshold = 0.7;
    metadata.free_threshold = 1.0 / 3.0;
    QVERIFY(writeMap(folder.path("map.yaml"), name.toStdString(), picture, metadata).has_value());
    QVERIFY(samePixels(*loadPicture(folder.path(name.toStdString())), picture));
    const Result<MapYaml> yaml = readMapYaml(folder.path("map.yaml"));
    const MapMetadata* read = &yaml->metadata;
    QCOMPARE(read->image, folder.path(name.toStdString()));
    QCOMPARE(read->resolution_m_per_px, metadata.resolution_m_per_px);
    QVERIFY(read->metric_from_corner.translation == metadata.metric_from_corner.translation);
    QCOMPARE(read->free_threshold, metadata.free_threshold);
    QVERIFY(read->negate);
    QVERIFY(read->mode == MapMode::kScale);
    QVERIFY(loadMap(folder.path("map.yaml")).has_value());
    QCOMPARE(folder.names().size(), std::size_t{2});
  }

  void whatCannotBeWrittenIsRefusedAndLeavesNothing() {
    const test::TemporaryFolder folder;
    const cv::Mat grey(2, 2, CV_8UC1, cv::Scalar(0));
    for (const char* name : {"a.jpg", "a", "", "b/a.png", "../a.png", "/tmp/a.png"}) {
      QVERIFY(!writeMap(folder.path("map.yaml"), name, grey, {}));
    }
    QVERIFY(!writeMap(folder.path("map.yaml"), "a.pgm", cv::Mat(2, 2, CV_8UC3, cv::Scalar::all(0)), {}));
    QVERIFY(!writeMap(folder.path("map.yaml"), "a.png", cv::Mat(2, 2, CV_32FC1, cv::Scalar::all(0)), {}));
    QVERIFY(!writeMap(folder.path("map.yaml"), "a.png", cv::Mat(), {}));
    QVERIFY(!writeMap(folder.path() / "none" / "map.yaml", "a.png", grey, {}));
    QVERIFY(folder.names().empty());
  }

  void sixteenBitsSayTheSameAsEight() {
    const test::TemporaryFolder folder;
    cv::Mat wide;
    threeStripes().convertTo(wide, CV_16U, 257.0);
    for (const char* name : {"w.png", "w.pgm", "w.tif"}) {
      QVERIFY(cv::imwrite(folder.path(name).string(), wide));
      QVERIFY(hasThreeStripes(loadMap(metadataWith(folder.path(name)))->grid));
    }
  }

  void theMaximumOfAPgmIsWhite() {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.write("a.pgm", "P5\n3 1\n100\n" + std::string{100, 80, 0});
    const Result<LoadedMap> map = loadMap(metadataWith(path));
    QVERIFY(map->grid.at(0, 0) == CellState::kFree);
    QVERIFY(map->grid.at(1, 0) == CellState::kUnknown);
    QVERIFY(map->grid.at(2, 0) == CellState::kOccupied);
    const cv::Mat picture = *loadPicture(path);
    QCOMPARE(int{picture.at<std::uint8_t>(0, 0)}, 255);
    QCOMPARE(int{picture.at<std::uint8_t>(0, 1)}, 204);
  }

  void orientationInPhotosIsIgnored() {
    // map_server does not turn pictures; a turned raster would not fit its own frame.
    const test::TemporaryFolder folder;
    QVERIFY(cv::imwrite(folder.path("a.jpg").string(), threeStripes()));
    std::string bytes = folder.read("a.jpg");
    const std::string exif(
        "\xff\xe1\x00\x22"
        "Exif\0\0II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0",
        36);
    bytes.insert(2, exif);  // orientation 6: turned by 90 degrees
    const Result<MapFrame> frame = readMapFrame(metadataWith(folder.write("turned.jpg", bytes)));
    QCOMPARE(frame->width(), 9);
    QCOMPARE(loadPicture(folder.path("turned.jpg"))->cols, 9);
  }

  void warningsSayWhatAUserShouldKnow() {
    const test::TemporaryFolder folder;
    QVERIFY(cv::imwrite(folder.path("a.png").string(), threeStripes()));
    folder.write(
        "a.yaml",
        "image: a.png\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n");
    const Result<LoadedMap> trap = loadMap(folder.path("a.yaml"));  // the thresholds many maps came with
    QCOMPARE(trap->warnings.size(), std::size_t{1});
    QVERIFY(trap->warnings[0].find("205") != std::string::npos);
    folder.write(
        "b.yaml",
        "image: a.png\nresolution: 0.05\norigin: [0, 0, 1]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
    const Result<LoadedMap> turned = loadMap(folder.path("b.yaml"));
    QCOMPARE(turned->warnings.size(), std::size_t{1});
    QVERIFY(turned->warnings[0].find("yaw") != std::string::npos);
    QVERIFY(cv::imwrite(folder.path("c.png").string(), cv::Mat(3, 3, CV_8UC3, cv::Scalar(0, 255, 0))));
    const Result<LoadedMap> green = loadMap(metadataWith(folder.path("c.png")));
    QCOMPARE(green->warnings.size(), std::size_t{1});
    QVERIFY(green->warnings[0].rfind("9 pixels", 0) == 0);
  }

  void cutAnywhereItIsAnError_data() { everyFormatIsRead_data(); }
  void cutAnywhereItIsAnError() {
    QFETCH(QString, name);
    const test::TemporaryFolder folder;
    QVERIFY(cv::imwrite(folder.path(name.toStdString()).string(), threeStripes()));
    const std::string whole = folder.read(name.toStdString());
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const std::filesystem::path path = folder.write("cut", whole.substr(0, length));
      const Result<LoadedMap> map = loadMap(metadataWith(path));
      // A TIFF may end in a tag that no pixel depends on.
      if (map && name.contains(".tif") && hasThreeStripes(map->grid)) continue;
      QVERIFY2(!map, std::to_string(length).c_str());
      QVERIFY(map.error().code == ErrorCode::kMalformed);
      QCOMPARE(map.error().where, path.string());
      QVERIFY(!loadPicture(path));
    }
  }

  void missingFilesAndFolders() {
    const test::TemporaryFolder folder;
    QVERIFY(loadMap(folder.path("none.yaml")).error().code == ErrorCode::kNotFound);
    QVERIFY(loadMap(metadataWith(folder.path("none.png"))).error().code == ErrorCode::kNotFound);
    QVERIFY(loadMap(metadataWith(folder.path())).error().code == ErrorCode::kUnreadable);
    QVERIFY(loadPicture("/dev/zero").error().code == ErrorCode::kUnreadable);
    QVERIFY(readMapFrame(metadataWith(folder.path("none.png"))).error().code == ErrorCode::kNotFound);
    folder.write(
        "map.yaml",
        "image: none.png\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n");
    QCOMPARE(loadMap(folder.path("map.yaml")).error().where, folder.path("none.png").string());
  }

  void theAuthorsBlueprintsGiveTheirMeshes_data() {
    QTest::addColumn<QString>("site");
    QTest::addColumn<int>("cell_px");
    QTest::addColumn<int>("nodes");
    QTest::addColumn<int>("edges");
    QTest::newRow("demo") << "demo" << 10 << 1442 << 2715;
    QTest::newRow("diag") << "diag" << 25 << 2534 << 4724;
    QTest::newRow("eiii-0") << "eiii-0" << 25 << 715 << 1183;
  }
  void theAuthorsBlueprintsGiveTheirMeshes() {
    QFETCH(QString, site);
    QFETCH(int, cell_px);
    QFETCH(int, nodes);
    QFETCH(int, edges);
    const std::filesystem::path yaml =
        std::filesystem::path(CAD2SLAM_SHARED_DATA) / site.toStdString() / "blueprint.yaml";
    if (!std::filesystem::exists(yaml)) QSKIP("the paper's data are not here");
    for (const MapSemantics semantics : {MapSemantics::kJazzy, MapSemantics::kHumble}) {
      const Result<LoadedMap> map = loadMap(yaml, {semantics});
      QVERIFY2(map, map ? "" : map.error().sentence().c_str());
      const Result<Mesh> mesh = buildMesh(map->grid, cell_px * map->metadata.resolution_m_per_px);
      QCOMPARE(mesh->nodeCount(), static_cast<std::size_t>(nodes));
      QCOMPARE(mesh->edges().size(), static_cast<std::size_t>(edges));
    }
  }
};

QTEST_APPLESS_MAIN(MapFileTest)
#include "map_file_test.moc"

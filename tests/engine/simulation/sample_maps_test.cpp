// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/true_warp_file.h"

#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>
#include <fstream>

using namespace cad2slam;
namespace fs = std::filesystem;

namespace {

const fs::path kSites = CAD2SLAM_SAMPLE_MAPS;

void overwrite(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string slurp(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

class SampleMapsTest : public QObject {
  Q_OBJECT
 private slots:
  void siteIsComplete_data();
  void siteIsComplete();
  void truthSurvivesWritingAndReading();
  void brokenTruthFiles_data();
  void brokenTruthFiles();
};

void SampleMapsTest::siteIsComplete_data() {
  QTest::addColumn<QString>("site");
  QTest::addColumn<QString>("number");
  for (const char* site : {"office", "corridor", "warehouse"}) {
    for (const char* number : {"1", "2"}) QTest::addRow("%s %s", site, number) << site << number;
  }
}

void SampleMapsTest::siteIsComplete() {
  QFETCH(QString, site);
  QFETCH(QString, number);
  const fs::path folder = kSites / site.toStdString();
  const Result<LoadedMap> blueprint = loadMap(folder / "blueprint.yaml");
  QVERIFY2(blueprint, blueprint ? "" : blueprint.error().sentence().c_str());
  const Result<LoadedMap> slam = loadMap(folder / ("slam_" + number.toStdString() + ".yaml"));
  QVERIFY2(slam, slam ? "" : slam.error().sentence().c_str());
  const Result<AnchorImport> anchors = readAnchorsCsv(folder / ("anchors_" + number.toStdString() + ".csv"));
  QVERIFY2(anchors, anchors ? "" : anchors.error().sentence().c_str());
  const Result<TrueWarp> truth = readTrueWarp(folder / ("truth_" + number.toStdString() + ".yaml"));
  QVERIFY2(truth, truth ? "" : truth.error().sentence().c_str());
  QCOMPARE(anchors->anchors.size(), std::size_t{30});
  QVERIFY(anchors->rejected.empty());

  int known = 0;
  for (const Anchor& anchor : anchors->anchors) {
    QVERIFY(slam->grid.frame().contains(anchor.in_slam));
    const auto pose = truth->slamFromBlueprint({anchor.in_blueprint, 0.0});
    if (!pose) continue;  // a click a pixel inside the wall can lie beyond the last sample
    ++known;
    QVERIFY((pose->translation - anchor.in_slam).norm() < 0.45);
  }
  QVERIFY(known >= 25);

  // Every free pixel has a truth, and where the truth puts it the robot saw free space, unless a door was shut.
  const MapFrame& frame = blueprint->grid.frame();
  int free_pixels = 0;
  int seen_free = 0;
  for (int row = 0; row < frame.height(); row += 5) {
    for (int column = 0; column < frame.width(); column += 5) {
      if (blueprint->grid.at(column, row) != CellState::kFree) continue;
      const auto pose = truth->slamFromBlueprint({frame.metricFromPixel({column + 0.5, row + 0.5}), 0.0});
      QVERIFY(pose.has_value());
      ++free_pixels;
      seen_free += slam->grid.at(pose->translation) == CellState::kFree ? 1 : 0;
    }
  }
  QVERIFY(seen_free > 0.6 * free_pixels);
}

void SampleMapsTest::truthSurvivesWritingAndReading() {
  const QTemporaryDir folder;
  const Result<TrueWarp> truth = readTrueWarp(kSites / "office" / "truth_1.yaml");
  QVERIFY(truth);
  const fs::path copy = fs::path(folder.path().toStdString()) / "copy.yaml";
  QVERIFY(writeTrueWarp(copy, *truth));
  const Result<TrueWarp> again = readTrueWarp(copy);
  QVERIFY(again);
  QCOMPARE(again->layout().first, truth->layout().first);
  QCOMPARE(again->layout().step_m, truth->layout().step_m);
  QCOMPARE(slurp(fs::path(copy).replace_extension(".npy")), slurp(kSites / "office" / "truth_1.npy"));
}

void SampleMapsTest::brokenTruthFiles_data() {
  QTest::addColumn<QByteArray>("yaml");
  QTest::addColumn<QByteArray>("grid");
  const QByteArray good_yaml = "grid: t.npy\norigin: [0, 0]\nstep: 0.5\n";
  const QByteArray head = QByteArray("\x93NUMPY\x01\x00", 8);
  const auto npy = [&](const QByteArray& header, int floats) {
    return head + QByteArray(1, static_cast<char>(header.size())) + QByteArray(1, 0) + header +
           QByteArray(4 * floats, 0);
  };
  const QByteArray good = npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2, 3), }\n", 12);
  QTest::newRow("not yaml") << QByteArray("grid: [") << good;
  QTest::newRow("no grid") << QByteArray("origin: [0, 0]\nstep: 1\n") << good;
  QTest::newRow("a list") << QByteArray("[1, 2]") << good;
  QTest::newRow("no step") << QByteArray("grid: t.npy\norigin: [0, 0]\n") << good;
  QTest::newRow("origin of one") << QByteArray("grid: t.npy\norigin: [0]\nstep: 1\n") << good;
  QTest::newRow("step in words") << QByteArray("grid: t.npy\norigin: [0, 0]\nstep: half\n") << good;
  QTest::newRow("negative step") << QByteArray("grid: t.npy\norigin: [0, 0]\nstep: -1\n") << good;
  QTest::newRow("missing grid file") << QByteArray("grid: other.npy\norigin: [0, 0]\nstep: 1\n") << good;
  QTest::newRow("empty grid") << good_yaml << QByteArray();
  QTest::newRow("other magic") << good_yaml << QByteArray("PK\x03\x04 something else");
  QTest::newRow("ends in the header") << good_yaml << good.left(30);
  QTest::newRow("one float short") << good_yaml << good.left(good.size() - 4);
  QTest::newRow("one byte more") << good_yaml << good + "x";
  QTest::newRow("lying shape")
      << good_yaml << npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2000000000, 2000000000, 3), }\n", 12);
  QTest::newRow("negative shape") << good_yaml
                                  << npy("{'descr': '<f4', 'fortran_order': False, 'shape': (-2, -2, 3), }\n", 0);
  QTest::newRow("two layers") << good_yaml
                              << npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2, 2), }\n", 8);
  QTest::newRow("doubles") << good_yaml << npy("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 3), }\n", 24);
  QTest::newRow("columns first") << good_yaml
                                 << npy("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 2, 3), }\n", 12);
  QTest::newRow("no shape") << good_yaml << npy("{'descr': '<f4', 'fortran_order': False }\n", 12);
}

void SampleMapsTest::brokenTruthFiles() {
  QFETCH(QByteArray, yaml);
  QFETCH(QByteArray, grid);
  const QTemporaryDir folder;
  const fs::path root = folder.path().toStdString();
  overwrite(root / "t.yaml", yaml.toStdString());
  overwrite(root / "t.npy", grid.toStdString());
  const Result<TrueWarp> truth = readTrueWarp(root / "t.yaml");
  QVERIFY(!truth);
  QVERIFY(!truth.error().message.empty());
}

QTEST_APPLESS_MAIN(SampleMapsTest)
#include "sample_maps_test.moc"

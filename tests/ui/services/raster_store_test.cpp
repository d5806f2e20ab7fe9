// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/raster_store.h"

#include <QtTest>

#include <chrono>
#include <filesystem>
#include <system_error>
#include <vector>

#include "support/temporary_folder.h"
#include "ui/document/project_commands.h"

using namespace cad2slam;

class RasterStoreTest : public QObject {
  Q_OBJECT

  static bool writeImage(const std::filesystem::path& path, int width, int grey) {
    return writePicture(path, cv::Mat(30, width, CV_8UC1, cv::Scalar(grey))).has_value();
  }
  /// As a robot or a draughtsman would: other bytes at another time.
  static bool replaceImage(const std::filesystem::path& path, int width, int grey) {
    std::error_code error;
    const auto before = std::filesystem::last_write_time(path, error);
    const bool written = writeImage(path, width, grey);
    std::filesystem::last_write_time(path, before + std::chrono::seconds(2), error);
    return written && !error;
  }

 private slots:
  void anImageChosenAnewIsReadAnew() {
    ProjectDocument document;
    RasterStore store(document);
    const test::TemporaryFolder folder;
    ProjectRaster raster;
    raster.metadata.image = folder.path("plan.png");
    QVERIFY(writeImage(raster.metadata.image, 40, 254));
    edit::setBlueprint(document, raster);
    QTRY_VERIFY_WITH_TIMEOUT(store.grid(Side::kBlueprint), 60'000);
    const std::string first = document.project().blueprint.image_sha256;
    QCOMPARE(first.size(), std::size_t{64});
    // Of the same size at the same time: only the choice itself tells.
    std::error_code error;
    const auto time = std::filesystem::last_write_time(raster.metadata.image, error);
    for (const int grey : {100, 50}) {
      QVERIFY(writeImage(raster.metadata.image, 50, grey));
      std::filesystem::last_write_time(raster.metadata.image, time, error);
      edit::setBlueprint(document, raster);
      QTRY_VERIFY_WITH_TIMEOUT(store.grid(Side::kBlueprint) && !store.isLoading(), 60'000);
      QCOMPARE(store.frame(Side::kBlueprint)->width(), 50);
      QCOMPARE(store.imageHash(Side::kBlueprint), document.project().blueprint.image_sha256);
      QCOMPARE(document.project().blueprint.image_sha256.size(), std::size_t{64});
      QVERIFY(document.project().blueprint.image_sha256 != first);
      QVERIFY(!store.isImageChanged(Side::kBlueprint));
    }
  }

  void aReplacedImageIsSeenAtTheNextStep() {
    ProjectDocument document;
    RasterStore store(document);
    const test::TemporaryFolder folder;
    ProjectRaster raster;
    raster.metadata.image = folder.path("plan.png");
    QVERIFY(writeImage(raster.metadata.image, 40, 254));
    edit::setBlueprint(document, raster);
    QTRY_VERIFY_WITH_TIMEOUT(store.grid(Side::kBlueprint), 60'000);
    QVERIFY(replaceImage(raster.metadata.image, 60, 254));
    QSignalSpy problems(&store, &RasterStore::problem);
    edit::rescaleBlueprint(document, 2.0);
    QTRY_COMPARE_WITH_TIMEOUT(problems.size(), 1, 60'000);
    QCOMPARE(store.frame(Side::kBlueprint)->width(), 60);
    QVERIFY(store.isImageChanged(Side::kBlueprint));
    // The next steps neither read it again nor tell it again.
    edit::rescaleBlueprint(document, 0.5);
    QVERIFY(!store.isLoading() && store.isImageChanged(Side::kBlueprint));
  }

  void anAcceptedImageIsNoChangedOne() {
    const test::TemporaryFolder folder;
    ProjectRaster raster;
    raster.metadata.image = folder.path("plan.png");
    QVERIFY(writeImage(raster.metadata.image, 40, 254));
    raster.image_bytes = 1;
    raster.image_sha256 = std::string(64, 'a');
    ProjectDocument document;
    RasterStore store(document);
    QSignalSpy problems(&store, &RasterStore::problem);
    QSignalSpy over(&store, &RasterStore::problemsOver);
    edit::setBlueprint(document, raster);
    QTRY_COMPARE_WITH_TIMEOUT(problems.size(), 1, 60'000);
    QVERIFY(store.isImageChanged(Side::kBlueprint));
    over.clear();
    const auto found = problems.first().at(0).value<RasterProblem>();
    raster.image_bytes = found.found_bytes;
    raster.image_sha256 = found.found_sha256;
    edit::setBlueprint(document, raster);
    QVERIFY(!store.isImageChanged(Side::kBlueprint));
    QVERIFY(!store.isLoading());
    QCOMPARE(over.size(), 1);
    document.undoStack().undo();
    QTRY_COMPARE_WITH_TIMEOUT(problems.size(), 2, 60'000);
    QVERIFY(store.isImageChanged(Side::kBlueprint));
  }

  void aChangedImageIsToldUnderTheNewNameOfItsMap() {
    const test::TemporaryFolder folder;
    ProjectRaster raster;
    raster.metadata.image = folder.path("slam.png");
    QVERIFY(writeImage(raster.metadata.image, 40, 254));
    raster.image_bytes = 1;
    raster.image_sha256 = std::string(64, 'a');
    ProjectDocument document;
    RasterStore store(document);
    QSignalSpy problems(&store, &RasterStore::problem);
    edit::addSlamMap(document, "robot 1", raster);
    QTRY_COMPARE_WITH_TIMEOUT(problems.size(), 1, 60'000);
    QVERIFY(edit::renameSlamMap(document, "robot 1", "cleaner"));
    QTRY_COMPARE_WITH_TIMEOUT(problems.size(), 2, 60'000);
    QCOMPARE(problems.last().at(0).value<RasterProblem>().map, std::string("cleaner"));
  }

  void aFileThatIsGoneStaysShown() {
    ProjectDocument document;
    RasterStore store(document);
    const test::TemporaryFolder folder;
    ProjectRaster raster;
    raster.metadata.image = folder.path("plan.png");
    QVERIFY(writeImage(raster.metadata.image, 40, 254));
    edit::setBlueprint(document, raster);
    QTRY_VERIFY_WITH_TIMEOUT(store.grid(Side::kBlueprint), 60'000);
    QVERIFY(std::filesystem::remove(raster.metadata.image));
    edit::rescaleBlueprint(document, 2.0);
    QVERIFY(store.frame(Side::kBlueprint).has_value());
  }

  void aLargeBlueprintIsShownBeforeItsCellsAreKnown() {
    ProjectDocument document;
    RasterStore store(document);
    struct Seen {
      bool frame;
      bool grid;
      bool new_picture;
    };
    std::vector<Seen> seen;
    connect(&store, &RasterStore::changed, this, [&](Side side, bool new_picture) {
      if (side != Side::kBlueprint) return;
      seen.push_back({store.frame(side).has_value(), store.grid(side) != nullptr, new_picture});
    });
    const test::TemporaryFolder folder;
    ProjectRaster raster;
    raster.metadata.image = folder.path("large.png");
    QVERIFY(writePicture(raster.metadata.image, cv::Mat(4100, 4100, CV_8UC1, cv::Scalar(254))).has_value());
    edit::setBlueprint(document, raster);
    QTRY_VERIFY_WITH_TIMEOUT(store.grid(Side::kBlueprint) && !store.isLoading(), 60'000);
    QCOMPARE(seen.size(), std::size_t{3});
    QVERIFY(!seen[0].frame && seen[0].new_picture);
    QVERIFY(seen[1].frame && !seen[1].grid && seen[1].new_picture);
    QVERIFY(seen[2].frame && seen[2].grid && !seen[2].new_picture);  // a view that was moved meanwhile stays
    QCOMPARE(store.grid(Side::kBlueprint)->frame().width(), store.frame(Side::kBlueprint)->width());

    // Another scale before everything is there ends up in the frame of both.
    document.undoStack().undo();
    edit::setBlueprint(document, raster);
    QTRY_VERIFY_WITH_TIMEOUT(store.frame(Side::kBlueprint), 60'000);
    ProjectRaster rescaled = document.project().blueprint;
    rescaled.metadata.resolution_m_per_px *= 2.0;
    edit::setBlueprint(document, rescaled);
    QTRY_VERIFY_WITH_TIMEOUT(store.grid(Side::kBlueprint) && !store.isLoading(), 60'000);
    QCOMPARE(store.frame(Side::kBlueprint)->resolution(), rescaled.metadata.resolution_m_per_px);
    QCOMPARE(store.grid(Side::kBlueprint)->frame().resolution(), rescaled.metadata.resolution_m_per_px);
  }
};

QTEST_MAIN(RasterStoreTest)
#include "raster_store_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/raster_store.h"

#include <QtTest>

#include <vector>

#include "support/temporary_folder.h"
#include "ui/document/project_commands.h"

using namespace cad2slam;

class RasterStoreTest : public QObject {
  Q_OBJECT

 private slots:
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

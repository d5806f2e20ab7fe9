// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/true_warp_file.h"

#include <QtTest>

#include <filesystem>

using namespace cad2slam;
namespace fs = std::filesystem;

namespace {

const fs::path kSites = CAD2SLAM_SAMPLE_MAPS;

}  // namespace

class SampleMapsTest : public QObject {
  Q_OBJECT
 private slots:
  void siteIsComplete_data();
  void siteIsComplete();
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

QTEST_APPLESS_MAIN(SampleMapsTest)
#include "sample_maps_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/blueprint_map.h"

#include "cad2slam/io/map_file.h"
#include "ui/convert.h"
#include "ui/support/flat_projector.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace cad2slam;

class BlueprintMapTest : public QObject {
  Q_OBJECT

 private:
  /// A hall of 10 m x 8 m with a block in it.
  [[nodiscard]] static OccupancyGrid hall() {
    cv::Mat states(80, 100, CV_8UC1, cv::Scalar(static_cast<int>(CellState::kFree)));
    states(cv::Rect(30, 20, 20, 10)).setTo(static_cast<int>(CellState::kOccupied));
    return {*MapFrame::create(0.1, 100, 80, Pose2{}), states};
  }
  const QTemporaryDir folder_;
  const Eigen::Vector2d shift_{2.0, 1.0};
  const Projector projector_ = test::flatProjector(10, 8, 1.0, Similarity2{1.0, 0.0, shift_});
  const MapFrame slam_ = *MapFrame::create(0.05, 300, 240, Pose2{{-0.5, -0.5}, 0.0});

 private slots:
  void aPlaceOfTheBlueprintIsWhereTheRobotSeesIt() {
    const std::filesystem::path yaml = toPath(folder_.filePath(QStringLiteral("map.yaml")));
    QVERIFY(writeBlueprintMap(yaml, projector_, hall(), slam_, [] { return false; }));
    const LoadedMap read = loadMap(yaml).value();
    QCOMPARE(read.metadata.image, imageOfBlueprintMap(yaml));
    QCOMPARE(read.grid.frame().resolution(), slam_.resolution());
    QCOMPARE(read.grid.frame().width(), slam_.width());
    QCOMPARE(read.grid.frame().metricFromCorner().translation, slam_.metricFromCorner().translation);
    const OccupancyGrid blueprint = hall();
    for (double x = 0.55; x < 9.5; x += 0.5)
      for (double y = 0.55; y < 7.5; y += 0.5)
        QVERIFY(read.grid.at(Eigen::Vector2d(x, y) + shift_) == blueprint.at(Eigen::Vector2d(x, y)));
    QVERIFY(read.grid.at(Eigen::Vector2d(-0.4, -0.4)) == CellState::kUnknown);  // no blueprint there
  }

  void whatIsStoppedLeavesNoFile() {
    const QString yaml = folder_.filePath(QStringLiteral("stopped.yaml"));
    const Result<void> written = writeBlueprintMap(toPath(yaml), projector_, hall(), slam_, [] { return true; });
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::kCancelled);
    QVERIFY(!QFile::exists(yaml));
    QVERIFY(!QFile::exists(folder_.filePath(QStringLiteral("stopped.png"))));
  }
};

QTEST_GUILESS_MAIN(BlueprintMapTest)
#include "blueprint_map_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/grid_sampling.h"

#include <QtTest>

#include "support/bent_hall.h"

namespace cad2slam {

using Eigen::Vector2d;

class GridSamplingTest : public QObject {
  Q_OBJECT
 private slots:
  void samplesAreTheProjectors_data();
  void samplesAreTheProjectors();
  void everyPlaceCanBeInterpolated();
  void aFinerGridDeviatesLess();
  void wrongStepsAreRefused();
};

void GridSamplingTest::samplesAreTheProjectors_data() {
  QTest::addColumn<bool>("forward");
  QTest::newRow("to SLAM") << true;
  QTest::newRow("to the blueprint") << false;
}

void GridSamplingTest::samplesAreTheProjectors() {
  QFETCH(bool, forward);
  const Projector projector = test::bentHall();
  const PoseGrid grid = *sampleGrid(projector, forward ? WarpDirection::kToSlam : WarpDirection::kToBlueprint, 0.7);
  QCOMPARE(grid.images.size(), grid.rows * grid.columns);
  int inside = 0;
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const Vector2d place = grid.first + 0.7 * Vector2d(static_cast<double>(column), static_cast<double>(row));
      const Projection exact = forward ? projector.slamFromBlueprint({place, 0.0}, OutsidePolicy::kError)
                                       : projector.blueprintFromSlam({place, 0.0}, OutsidePolicy::kError);
      if (!exact.ok()) continue;
      ++inside;
      QVERIFY((grid.at(row, column).translation - exact.pose.translation).norm() < 1e-9);
      QVERIFY(std::abs(grid.at(row, column).heading - exact.pose.heading) < 1e-9);
    }
  }
  QVERIFY(inside > 300);
  // Far away there is nothing, not a guess.
  QVERIFY(!grid.at(0, 0).isFinite());
}

void GridSamplingTest::everyPlaceCanBeInterpolated() {
  const Projector projector = test::bentHall();
  const PoseGrid grid = *sampleGrid(projector, WarpDirection::kToSlam, 0.5);
  for (double x = 0.01; x < 20.0; x += 0.37) {
    for (double y = 0.01; y < 10.0; y += 0.41) {
      const Vector2d at = (Vector2d(x, y) - grid.first) / grid.step_m;
      const auto column = static_cast<std::size_t>(at.x());
      const auto row = static_cast<std::size_t>(at.y());
      const double u = at.x() - static_cast<double>(column);
      const double v = at.y() - static_cast<double>(row);
      const Vector2d between =
          (1 - u) * (1 - v) * grid.at(row, column).translation + u * (1 - v) * grid.at(row, column + 1).translation +
          (1 - u) * v * grid.at(row + 1, column).translation + u * v * grid.at(row + 1, column + 1).translation;
      const Vector2d exact = projector.slamFromBlueprint({{x, y}, 0.0}).pose.translation;
      QVERIFY((between - exact).norm() < 1.5 * grid.max_deviation_m);
    }
  }
}

void GridSamplingTest::aFinerGridDeviatesLess() {
  const Projector projector = test::bentHall();
  const double coarse = sampleGrid(projector, WarpDirection::kToSlam, 0.8)->max_deviation_m;
  const double fine = sampleGrid(projector, WarpDirection::kToSlam, 0.2)->max_deviation_m;
  QVERIFY(coarse > 4.0 * fine && fine > 0.0);
}

void GridSamplingTest::wrongStepsAreRefused() {
  const Projector projector = test::bentHall();
  for (const double step : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e-4, 1e-300, 40.0, 1e300}) {
    QVERIFY(!sampleGrid(projector, WarpDirection::kToSlam, step));
  }
}

}  // namespace cad2slam

QTEST_APPLESS_MAIN(cad2slam::GridSamplingTest)
#include "grid_sampling_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/speed_benchmark.h"

#include <QtTest>

#include "evaluation_site.h"

using namespace cad2slam;

class SpeedBenchmarkTest : public QObject {
  Q_OBJECT
 private slots:
  /// Whether everything is measured; how fast it is is no business of a test.
  void everythingIsMeasured() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::bentWarp(), 10);
    SpeedOptions options;
    options.cell_size_m = 1.5;
    options.repetitions = 2;
    options.poses = 20;
    options.batch_poses = 500;
    const Result<SpeedReport> report = measureSpeed(made.site.building.blueprint, made.site.anchors, options);
    QVERIFY(report);
    QCOMPARE(report->nodes, made.mesh->nodeCount());
    QCOMPARE(report->edges, made.mesh->edges().size());
    QCOMPARE(report->anchors, std::size_t{10});
    QCOMPARE(report->construction_ms.count, std::size_t{2});
    QCOMPARE(report->optimisation_ms.count, std::size_t{2});
    QCOMPARE(report->projection_us.count, std::size_t{20});
    QVERIFY(report->inverse_us.count > 15);
    for (const double value : {report->optimisation_ms.mean, report->projection_us.mean, report->inverse_us.mean,
                               report->batch_projections_per_s, report->batch_inverses_per_s, report->projector_bytes,
                               report->peak_memory_bytes}) {
      QVERIFY(value > 0.0);
    }
  }

  void refusals() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 10);
    QVERIFY(!measureSpeed(made.site.building.blueprint, {}, {}));
    SpeedOptions nothing;
    nothing.repetitions = 0;
    QVERIFY(!measureSpeed(made.site.building.blueprint, made.site.anchors, nothing));
  }
};

QTEST_APPLESS_MAIN(SpeedBenchmarkTest)
#include "speed_benchmark_test.moc"

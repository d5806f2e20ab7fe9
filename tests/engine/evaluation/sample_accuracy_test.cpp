// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <filesystem>

#include "cad2slam/evaluation/truth_error.h"
#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/true_warp_file.h"
#include "cad2slam/mesh/mesh_builder.h"

/// The error that counts: the distance to the true warp, all over the free space of the sample sites.
namespace cad2slam {
namespace {

struct MeanErrors {
  double similarity_m = 0.0;
  double spline_m = 0.0;
  double stretch_m = 0.0;
};

Result<MeanErrors> errorsOf(const std::filesystem::path& folder, const std::string& number) {
  const Result<LoadedMap> blueprint = loadMap(folder / "blueprint.yaml");
  if (!blueprint) return failAs(blueprint);
  const Result<AnchorImport> anchors = readAnchors(folder / ("anchors_" + number + ".csv"));
  if (!anchors) return failAs(anchors);
  const Result<TrueWarp> truth = readTrueWarp(folder / ("truth_" + number + ".yaml"));
  if (!truth) return failAs(truth);
  const Result<Mesh> mesh = buildMesh(blueprint->grid, std::nullopt);
  if (!mesh) return failAs(mesh);
  EvaluationOptions options;
  options.methods = {AlignmentMethod::kSimilarity, AlignmentMethod::kThinPlateSpline, AlignmentMethod::kStretch};
  const Result<TruthErrors> errors =
      evaluateTruth(std::make_shared<const Mesh>(*mesh), anchors->anchors, blueprint->grid, *truth, options);
  if (!errors) return failAs(errors);
  return MeanErrors{errors->methods[0].statistics.mean, errors->methods[1].statistics.mean,
                    errors->methods[2].statistics.mean};
}

}  // namespace

class SampleAccuracyTest : public QObject {
  Q_OBJECT
 private slots:
  void isFarBetterThanASimilarity_data();
  void isFarBetterThanASimilarity();
  void isNoWorseThanASpline();

 private:
  int maps_ = 0;
  int no_worse_than_spline_ = 0;
};

void SampleAccuracyTest::isFarBetterThanASimilarity_data() {
  QTest::addColumn<QString>("site");
  QTest::addColumn<QString>("number");
  for (const char* site : {"office", "corridor", "warehouse"}) {
    for (const char* number : {"1", "2"}) QTest::addRow("%s %s", site, number) << site << number;
  }
}

void SampleAccuracyTest::isFarBetterThanASimilarity() {
  QFETCH(QString, site);
  QFETCH(QString, number);
  const std::filesystem::path folder = std::filesystem::path(CAD2SLAM_SAMPLE_MAPS) / site.toStdString();
  const Result<MeanErrors> errors = errorsOf(folder, number.toStdString());
  QVERIFY2(errors, errors ? "" : errors.error().sentence().c_str());
  qInfo("similarity %.3f m, thin-plate spline %.3f m, stretch %.3f m", errors->similarity_m, errors->spline_m,
        errors->stretch_m);
  ++maps_;
  no_worse_than_spline_ += errors->stretch_m <= errors->spline_m ? 1 : 0;
  QVERIFY(errors->stretch_m <= 0.25 * errors->similarity_m);
}

/// Counted by the test before. The aim is five of six: the splines win in the warehouse, on the first map by 4 %.
void SampleAccuracyTest::isNoWorseThanASpline() {
  if (maps_ < 6) QSKIP("only some of the maps were looked at");
  QVERIFY2(no_worse_than_spline_ >= 4, qPrintable(QString("on %1 of 6 maps").arg(no_worse_than_spline_)));
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::SampleAccuracyTest)
#include "sample_accuracy_test.moc"

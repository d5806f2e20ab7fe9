// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include "cli/cli_runner.h"

using namespace cad2slam::testing;

namespace {

/// `evaluate PART` on the office with coarse cells, quick to solve many times.
QStringList onOffice(const QString& part, const QStringList& more = {}) {
  return QStringList{"evaluate",    part,
                     "--blueprint", siteFile("office", "blueprint.yaml"),
                     "--slam",      siteFile("office", "slam_1.yaml"),
                     "--anchors",   siteFile("office", "anchors_1.csv"),
                     "--cell-size", "2.5"} +
         more;
}

}  // namespace

class EvaluateCommandTest : public QObject {
  Q_OBJECT
 private slots:
  void looGivesEveryMethod();
  void curveGivesEverySize();
  void truthKnowsTheError();
  void scansCountAllBeams();
  void speedGivesTimes();
  void randomSitesAreSummarised();
  void allIsOneSelfContainedPage();
  void weightsCanBeChanged();
  void badInput_data();
  void badInput();
  void badUsage_data();
  void badUsage();
};

void EvaluateCommandTest::looGivesEveryMethod() {
  const QTemporaryDir folder;
  const QString csv = folder.filePath("loo.csv");
  const CliRun run = runCli(onOffice("loo", {"--json", "--csv", csv}));
  QCOMPARE(run.exit_code, 0);
  const QJsonObject methods = run.json()["methods"].toObject();
  for (const char* name : {"similarity", "affine", "thin_plate_spline", "rigid", "stretch"}) {
    const QJsonObject method = methods[name].toObject();
    QVERIFY2(method["mean"].toDouble() > 0.0, name);
    QVERIFY(method["median"].toDouble() <= method["p90"].toDouble());
    QVERIFY(method["p90"].toDouble() <= method["max"].toDouble());
  }
  QVERIFY(methods["stretch"].toObject()["mean"].toDouble() < methods["similarity"].toObject()["mean"].toDouble());
  QFile table(csv);
  QVERIFY(table.open(QIODevice::ReadOnly));
  const QByteArrayList lines = table.readAll().trimmed().split('\n');
  QCOMPARE(lines.size(), 1 + methods.size());
  for (const QByteArray& line : lines) QVERIFY(line.count(',') >= 5);

  const CliRun text = runCli(onOffice("loo"));
  QVERIFY(text.out.contains("thin-plate spline"));
}

void EvaluateCommandTest::curveGivesEverySize() {
  const QStringList arguments = onOffice("curve", {"--sizes", "4,8", "--draws", "2", "--seed", "5", "--json"});
  const CliRun run = runCli(arguments);
  QCOMPARE(run.exit_code, 0);
  const QJsonObject sizes = run.json()["sizes"].toObject();
  QCOMPARE(sizes.keys(), (QStringList{"4", "8"}));
  QCOMPARE(sizes["4"].toObject()["methods"].toObject()["similarity"].toObject()["count"].toInt(), 2 * 26);
  const QJsonObject again = runCli(arguments).json()["sizes"].toObject();
  QCOMPARE(again["8"].toObject()["methods"].toObject()["affine"],
           sizes["8"].toObject()["methods"].toObject()["affine"]);
}

void EvaluateCommandTest::truthKnowsTheError() {
  const CliRun run = runCli(onOffice("truth", {"--truth", siteFile("office", "truth_1.yaml"), "--json"}));
  QCOMPARE(run.exit_code, 0);
  const QJsonObject methods = run.json()["methods"].toObject();
  QVERIFY(methods["stretch"].toObject()["mean"].toDouble() < 0.5 * methods["similarity"].toObject()["mean"].toDouble());
  QVERIFY(run.json()["places"].toInt() > 1000);
}

void EvaluateCommandTest::scansCountAllBeams() {
  const CliRun run = runCli(onOffice("scans", {"--random-paths", "1", "--step", "1", "--json"}));
  QCOMPARE(run.exit_code, 0);
  const QJsonArray thresholds = run.json()["thresholds"].toArray();
  QCOMPARE(thresholds.size(), 4);
  double outliers = 360.0;
  for (const QJsonValue& threshold : thresholds) {
    QVERIFY(threshold["outliers"].toDouble() + run.json()["beams_without_hit"].toDouble() <= 360.0 + 1e-9);
    QVERIFY(threshold["outliers"].toDouble() <= outliers);
    QVERIFY(threshold["mean_m"].toDouble() <= threshold["threshold_m"].toDouble());
    outliers = threshold["outliers"].toDouble();
  }
}

void EvaluateCommandTest::speedGivesTimes() {
  const CliRun run = runCli(onOffice("speed", {"--repetitions", "1", "--json"}));
  QCOMPARE(run.exit_code, 0);
  for (const char* name : {"construction_ms", "optimisation_ms", "projection_us", "inverse_us"}) {
    QVERIFY2(run.json()[name].toObject()["mean"].toDouble() > 0.0, name);
  }
  QVERIFY(run.json()["batch_projections_per_s"].toDouble() > 0.0);
}

void EvaluateCommandTest::randomSitesAreSummarised() {
  const QTemporaryDir folder;
  const QString csv = folder.filePath("sites.csv");
  const CliRun run =
      runCli({"evaluate", "sites", "--count", "2", "--seed", "7", "--cell-size", "2", "--json", "--csv", csv});
  QCOMPARE(run.exit_code, 0);
  QVERIFY(run.json()["methods"].toObject()["stretch"].toObject()["geometric_mean_m"].toDouble() > 0.0);
  QFile table(csv);
  QVERIFY(table.open(QIODevice::ReadOnly));
  QCOMPARE(table.readAll().trimmed().split('\n').size(), 3);
}

void EvaluateCommandTest::allIsOneSelfContainedPage() {
  const QTemporaryDir folder;
  const QString output = folder.filePath("report");
  const CliRun run =
      runCli(onOffice("all", {"-o", output, "--draws", "1", "--truth", siteFile("office", "truth_1.yaml")}));
  QVERIFY2(run.exit_code == 0, qPrintable(run.err));
  QCOMPARE(QDir(output).entryList(QDir::Files), (QStringList{"report.html", "report.json"}));
  QFile page(output + "/report.html");
  QVERIFY(page.open(QIODevice::ReadOnly));
  const QByteArray html = page.readAll();
  QVERIFY(html.startsWith("<!DOCTYPE html>") && html.trimmed().endsWith("</html>"));
  QVERIFY(!html.contains("http://") && !html.contains("https://") && !html.contains("<script"));
  QVERIFY(html.count("data:image/png;base64,") >= 4);
  for (const char* part : {"Leave-one-out", "How many anchors", "True error", "Scans along paths", "Speed", "<svg"}) {
    QVERIFY2(html.contains(part), part);
  }
  QFile json(output + "/report.json");
  QVERIFY(json.open(QIODevice::ReadOnly));
  const QJsonObject parts = QJsonDocument::fromJson(json.readAll()).object();
  for (const char* part : {"loo", "curve", "truth", "scans", "speed"}) QVERIFY2(parts.contains(part), part);
}

void EvaluateCommandTest::weightsCanBeChanged() {
  const QStringList truth = {"--truth", siteFile("office", "truth_1.yaml"), "--json"};
  const auto stretch = [&](const QStringList& more) {
    return runCli(onOffice("truth", truth + more))
        .json()["methods"]
        .toObject()["stretch"]
        .toObject()["mean"]
        .toDouble();
  };
  QVERIFY(stretch({"--set", "lambda_stretch=1000"}) != stretch({}));
}

void EvaluateCommandTest::badInput_data() {
  QTest::addColumn<QString>("part");
  QTest::addColumn<QStringList>("more");
  QTest::addColumn<QByteArray>("anchors");
  QTest::addColumn<QByteArray>("paths");
  QTest::addColumn<QString>("words");
  const QByteArray header = "id,blueprint_x,blueprint_y,slam_x,slam_y\n";
  const QByteArray three = header + "1,0,0,0,0\n2,10,0,10,0\n3,0,10,0,10\n";
  QTest::newRow("no anchors") << "loo" << QStringList{} << header << QByteArray() << "at least 3";
  QTest::newRow("one anchor") << "loo" << QStringList{} << header + "1,2,3,4,5\n" << QByteArray() << "at least 3";
  QTest::newRow("one anchor, curve") << "curve" << QStringList{} << header + "1,2,3,4,5\n"
                                     << QByteArray() << "at least 3";
  QTest::newRow("no truth file") << "truth" << QStringList{"--truth", "/nowhere/truth.yaml"} << three << QByteArray()
                                 << "/nowhere/truth.yaml";
  QTest::newRow("truth of another kind") << "truth" << QStringList{"--truth", siteFile("office", "slam_1.yaml")}
                                         << three << QByteArray() << "grid";
  QTest::newRow("path starts outside") << "scans" << QStringList{} << three << QByteArray("1e4,0,0,0\n")
                                       << "path 1: The start";
  QTest::newRow("path starts in a wall") << "scans" << QStringList{} << three << QByteArray("-8.3,5,10,10\n")
                                         << "inside a wall";
  QTest::newRow("path of three numbers") << "scans" << QStringList{} << three << QByteArray("1,2,3\n")
                                         << "four numbers";
  QTest::newRow("unknown weight") << "loo" << QStringList{"--set", "lambda_q=1"} << three << QByteArray() << "lambda_q";
  QTest::newRow("weight in words") << "loo" << QStringList{"--set", "lambda_x=big"} << three << QByteArray() << "big";
  QTest::newRow("no cell size") << "loo" << QStringList{"--cell-size", "-1"} << three << QByteArray() << "--cell-size";
}

void EvaluateCommandTest::badInput() {
  QFETCH(QString, part);
  QFETCH(QStringList, more);
  QFETCH(QByteArray, anchors);
  QFETCH(QByteArray, paths);
  QFETCH(QString, words);
  const QTemporaryDir folder;
  QVERIFY(overwrite(folder.filePath("anchors.csv"), anchors));
  if (!paths.isEmpty()) {
    QVERIFY(overwrite(folder.filePath("paths.csv"), paths));
    more += {"--paths", folder.filePath("paths.csv")};
  }
  const CliRun run =
      runCli(QStringList{"evaluate", part, "--blueprint", siteFile("office", "blueprint.yaml"), "--slam",
                         siteFile("office", "slam_1.yaml"), "--anchors", folder.filePath("anchors.csv")} +
             more);
  QCOMPARE(run.exit_code, 1);
  QVERIFY2(run.sentence().contains(words), qPrintable(run.err));
  QVERIFY(run.out.isEmpty());
}

void EvaluateCommandTest::badUsage_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::newRow("no part") << QStringList{"evaluate"};
  QTest::newRow("unknown part") << QStringList{"evaluate", "beauty"};
  QTest::newRow("nothing to evaluate") << QStringList{"evaluate", "loo"};
  QTest::newRow("half a site") << QStringList{"evaluate", "loo", "--blueprint", "b.yaml"};
  QTest::newRow("no output folder") << QStringList{"evaluate", "all", "x.c2sproj"};
  QTest::newRow("no truth") << QStringList{"evaluate", "truth", "x.c2sproj"};
}

void EvaluateCommandTest::badUsage() {
  QFETCH(QStringList, arguments);
  QCOMPARE(runCli(arguments).exit_code, 2);
}

QTEST_GUILESS_MAIN(EvaluateCommandTest)
#include "evaluate_command_test.moc"

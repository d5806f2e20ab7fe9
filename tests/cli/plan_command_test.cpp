// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

#include "cli/cli_runner.h"

using namespace cad2slam::testing;

class PlanCommandTest : public QObject {
  Q_OBJECT
 private slots:
  void posesFromStartToGoal();
  void projectorAddsTheSlamMap();
  void badInput_data();
  void badInput();
};

void PlanCommandTest::posesFromStartToGoal() {
  const CliRun run = runCli({"plan", siteFile("office", "blueprint.yaml"), "--start=-7.5,4.0", "--goal=30.0,4.0"});
  QVERIFY2(run.exit_code == 0, qPrintable(run.err));
  const QStringList lines = run.out.trimmed().split('\n');
  QVERIFY(lines.size() > 300);
  for (const QString& line : lines) QCOMPARE(line.count(','), 2);
  QVERIFY(lines.first().startsWith("-7.5"));
  QVERIFY(lines.last().startsWith("30.0"));
}

void PlanCommandTest::projectorAddsTheSlamMap() {
  const QTemporaryDir folder;
  const QString projector = folder.filePath("p.c2s");
  const CliRun solved =
      runCli({"solve", "--blueprint", siteFile("office", "blueprint.yaml"), "--slam", siteFile("office", "slam_1.yaml"),
              "--anchors", siteFile("office", "anchors_1.csv"), "--cell-size", "2", "-o", projector});
  QVERIFY2(solved.exit_code == 0, qPrintable(solved.err));
  const CliRun run = runCli({"plan", siteFile("office", "blueprint.yaml"), "--start=-7.5,4.0", "--goal=30.0,4.0",
                             "--projector", projector, "--json"});
  QVERIFY2(run.exit_code == 0, qPrintable(run.err));
  const QJsonArray blueprint = run.json()["blueprint"].toArray();
  const QJsonArray slam = run.json()["slam"].toArray();
  QCOMPARE(slam.size(), blueprint.size());
  double length = 0.0;
  for (qsizetype i = 1; i < slam.size(); ++i) {
    length += std::hypot(slam[i][0].toDouble() - slam[i - 1][0].toDouble(),
                         slam[i][1].toDouble() - slam[i - 1][1].toDouble());
  }
  QVERIFY(std::abs(length / run.json()["length_m"].toDouble() - 1.0) < 0.1);
}

void PlanCommandTest::badInput_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<int>("exit_code");
  QTest::addColumn<QString>("words");
  const QString map = siteFile("office", "blueprint.yaml");
  QTest::newRow("missing map") << QStringList{"/nowhere/map.yaml", "--start=0,0", "--goal=1,1"} << 1 << "/nowhere";
  QTest::newRow("start outside") << QStringList{map, "--start=1e6,0", "--goal=0,13"} << 1 << "outside";
  QTest::newRow("start in a wall") << QStringList{map, "--start=-8.3,5", "--goal=0,13"} << 1 << "inside a wall";
  QTest::newRow("not a projector") << QStringList{map, "--start=-7.5,4.0", "--goal=0,4.0", "--projector", map} << 1
                                   << "blueprint.yaml";
  QTest::newRow("no goal") << QStringList{map, "--start=0,0"} << 2 << "";
  QTest::newRow("one number") << QStringList{map, "--start=0", "--goal=1,1"} << 2 << "";
}

void PlanCommandTest::badInput() {
  QFETCH(QStringList, arguments);
  QFETCH(int, exit_code);
  QFETCH(QString, words);
  const CliRun run = runCli(QStringList{"plan"} + arguments);
  QCOMPARE(run.exit_code, exit_code);
  if (exit_code == 1) QVERIFY2(run.sentence().contains(words), qPrintable(run.err));
  QVERIFY(exit_code == 1 || !run.err.isEmpty());
}

QTEST_GUILESS_MAIN(PlanCommandTest)
#include "plan_command_test.moc"

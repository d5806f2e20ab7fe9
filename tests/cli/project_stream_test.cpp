// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <array>
#include <cmath>

#include "cli/cli_runner.h"

/// `project` answers while its input still comes, and its memory does not grow with it.
namespace cad2slam {

using testing::CliRun;
using testing::OfficeFolder;

class ProjectStreamTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void memoryDoesNotGrow();
  void filesAreNotSwallowed();
  void endlessLinesAreRefused();
  void fullOutputIsAnError();
  void closedOutputEndsTheRun();
  void answersAreInputAgain();
  void onlyAnswersMayBeNan_data();
  void onlyAnswersMayBeNan();

 private:
  OfficeFolder office_;
};

namespace {

/// Most memory a running process ever used [kB].
long peakMemory_kB(qint64 process) {
  for (const QByteArray& line : testing::bytesOf(QString("/proc/%1/status").arg(process)).split('\n')) {
    if (line.startsWith("VmHWM:")) return line.mid(6).trimmed().split(' ')[0].toLong();
  }
  return 0;
}

}  // namespace

void ProjectStreamTest::initTestCase() {
  const CliRun run = office_.run(OfficeFolder::solveArguments({"-o", "office.c2s"}));
  QVERIFY2(run.exit_code == 0, qPrintable(run.err));
}

void ProjectStreamTest::memoryDoesNotGrow() {
  constexpr qsizetype kLines = 20'000;
  constexpr int kRounds = 15;
  const QByteArray block = QByteArray("-5.0123,0.4567,0.5\n").repeated(kLines);
  QProcess process;
  testing::prepare(process, office_.path());
  process.start(CAD2SLAM_CLI, {"project", "office.c2s", "--to", "slam"});
  QVERIFY(process.waitForStarted());
  qsizetype answered = 0;
  long after_first_kB = 0;
  for (int round = 1; round <= kRounds; ++round) {
    process.write(block);
    // All but what still waits in the buffer of the output has to come before any more is sent.
    const qsizetype expected = round * kLines - 3000;
    while (answered < expected && process.waitForReadyRead(60'000))
      answered += process.readAllStandardOutput().count('\n');
    QVERIFY(answered >= expected);
    if (round == 1) after_first_kB = peakMemory_kB(process.processId());
  }
  const long at_last_kB = peakMemory_kB(process.processId());
  QVERIFY(after_first_kB > 0);
  QVERIFY2(at_last_kB - after_first_kB < 1024,
           qPrintable(QString("%1 kB, at last %2 kB").arg(after_first_kB).arg(at_last_kB)));
  process.closeWriteChannel();
  QVERIFY(process.waitForFinished(60'000));
  answered += process.readAllStandardOutput().count('\n');
  QCOMPARE(answered, kRounds * kLines);
  QCOMPARE(process.exitCode(), 0);
}

void ProjectStreamTest::filesAreNotSwallowed() {
  // A file larger than all the memory that a run may use, in which only the first line is a pose.
  QFile file(office_.file("huge.csv"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  QCOMPARE(file.write("-5,0\n"), qint64{5});
  QVERIFY(file.resize(qint64{5} << 30));  // zeros that take no room on the disk
  file.close();
  const CliRun run = office_.run({"project", "office.c2s", "huge.csv", "--to", "slam"});
  QCOMPARE(run.exit_code, 1);
  QCOMPARE(run.lines().size(), 1);
  QVERIFY(run.err.contains("huge.csv:2"));
  file.remove();
}

void ProjectStreamTest::endlessLinesAreRefused() {
  const CliRun run = office_.run({"project", "office.c2s", "--to", "slam"}, QByteArray(1 << 20, ' ') + "1,2\n");
  QCOMPARE(run.exit_code, 1);
  QVERIFY(run.err.contains("standard input:1"));
}

void ProjectStreamTest::fullOutputIsAnError() {
  if (!QFile::exists("/dev/full")) QSKIP("this system has no /dev/full");
  const QByteArray poses = QByteArray("-5,0\n").repeated(10'000);
  for (const QStringList& arguments : {QStringList{"project", "office.c2s", "--to", "slam"},
                                       {"info", "office.c2s"},
                                       {"info", "office.c2s", "--json"},
                                       OfficeFolder::solveArguments({"-o", "x.c2s"}),
                                       OfficeFolder::solveArguments({"-o", "x.c2s", "--json"})}) {
    const CliRun run = office_.run(arguments, poses, {{}, "/dev/full"});
    QVERIFY2(run.exit_code == 1, qPrintable(arguments.join(' ')));
    QCOMPARE(run.errors(), QStringList{"cad2slam-cli: the output could not be written"});
  }
}

void ProjectStreamTest::closedOutputEndsTheRun() {
  // As in `cad2slam-cli project ... | head -1`.
  QProcess process;
  testing::prepare(process, office_.path());
  process.start(CAD2SLAM_CLI, {"project", "office.c2s", "--to", "slam"});
  QVERIFY(process.waitForStarted());
  process.closeReadChannel(QProcess::StandardOutput);
  process.write(QByteArray("-5,0\n").repeated(100'000));
  process.closeWriteChannel();
  QVERIFY(process.waitForFinished(60'000));
}

void ProjectStreamTest::answersAreInputAgain() {
  // As in `cad2slam-cli project ... --to slam | cad2slam-cli project ... --to blueprint`.
  const QByteArray poses = "x,y,theta\n# two rooms\n-5.0123,0.4567,0.5\n\n900,900,0\n-6.25,1.5,-3\n-4.75;0.25\n";
  const CliRun there = office_.run({"project", "office.c2s", "--to", "slam"}, poses);
  QCOMPARE(there.exit_code, 1);  // one of them lies outside
  QCOMPARE(there.lines().at(0), QString("x,y,theta,status"));
  QCOMPARE(there.lines().at(3), QString("nan,nan,nan,outside"));
  const CliRun back = office_.run({"project", "office.c2s", "--to", "blueprint"}, there.out.toUtf8());
  QCOMPARE(back.exit_code, 1);
  QVERIFY2(back.sentence().contains("1 of 4 poses"), qPrintable(back.err));
  QCOMPARE(back.out.count('\n'), poses.count('\n'));
  QCOMPARE(back.lines().size(), 6);
  QCOMPARE(back.lines().at(0), QString("x,y,theta,status"));
  QCOMPARE(back.lines().at(1), QString("# two rooms"));
  QCOMPARE(back.lines().at(3), QString("nan,nan,nan,invalid"));
  const QList<std::array<double, 3>> expected = {{-5.0123, 0.4567, 0.5}, {-6.25, 1.5, -3.0}, {-4.75, 0.25, 0.0}};
  const QList<int> rows = {2, 4, 5};
  for (int k = 0; k < 3; ++k) {
    const QStringList fields = back.lines().at(rows[k]).split(',');
    QCOMPARE(fields.at(3), QString("inside"));
    for (int axis = 0; axis < 3; ++axis) {
      const double off = fields.at(axis).toDouble() - expected[k][static_cast<std::size_t>(axis)];
      QVERIFY2(std::abs(off) < 1e-6, qPrintable(back.lines().at(rows[k])));
    }
  }
  // And so on, as often as one likes: a pose without an answer never gets one by itself.
  const CliRun again = office_.run({"project", "office.c2s", "--to", "slam", "--outside", "rigid"}, back.out.toUtf8());
  QCOMPARE(again.lines().at(3), QString("nan,nan,nan,invalid"));
  QCOMPARE(again.exit_code, 1);
}

void ProjectStreamTest::onlyAnswersMayBeNan_data() {
  QTest::addColumn<QByteArray>("line");
  QTest::newRow("nan without status") << QByteArray("nan,nan,nan");
  QTest::newRow("nan place") << QByteArray("1,nan");
  QTest::newRow("infinite place") << QByteArray("inf,1,0");
  QTest::newRow("status after two numbers") << QByteArray("1,2,inside");
  QTest::newRow("number as status") << QByteArray("1,2,3,4");
  QTest::newRow("two statuses") << QByteArray("1,2,3,inside,inside");
  QTest::newRow("status of other letters") << QByteArray("1,2,3,<b>");
}

void ProjectStreamTest::onlyAnswersMayBeNan() {
  QFETCH(QByteArray, line);
  const CliRun run = office_.run({"project", "office.c2s", "--to", "slam"}, "-5,0\n" + line + '\n');
  QCOMPARE(run.exit_code, 1);
  QCOMPARE(run.lines().size(), 1);
  QVERIFY2(run.sentence().contains("standard input:2"), qPrintable(run.err));
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::ProjectStreamTest)
#include "project_stream_test.moc"

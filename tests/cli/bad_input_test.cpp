// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtEndian>
#include <QtTest>

#include "cli/cli_runner.h"

/// Files that are missing, cut, empty, huge or lying, and disks that are full: one clear sentence that names the file,
/// exit code 1, nothing written.
namespace cad2slam {

using testing::CliRun;
using testing::OfficeFolder;

class BadInputTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void everyFileOfEveryCommand_data();
  void everyFileOfEveryCommand();
  void lyingContent_data();
  void lyingContent();
  void anchorsThatDetermineNothing_data();
  void anchorsThatDetermineNothing();
  void outputsThatCannotBeWritten_data();
  void outputsThatCannotBeWritten();
  void fullDiskKeepsTheOldFile_data();
  void fullDiskKeepsTheOldFile();

 private:
  QByteArray projector_;  // of the unspoilt office
};

namespace {

const QStringList kSolve = OfficeFolder::solveArguments({"-o", "out.c2s"});
const QStringList kSolveProject{"solve", "p.c2sproj", "-o", "out.c2s"};
const QStringList kInfo{"info", "office.c2s"};
const QStringList kProject{"project", "office.c2s", "poses.csv", "--to", "slam"};
const QStringList kWarp{"warp", "office.c2s", "blueprint.yaml", "--to", "slam", "-o", "out.yaml"};
const QStringList kPreview{"preview", "office.c2s",  "--blueprint", "blueprint.yaml",
                           "--slam",  "slam_1.yaml", "-o",          "out.png"};
const QStringList kConvert{"convert", "anchors", "anchors_1.csv", "-o", "out.csv"};

/// Spoils one file of the folder.
bool spoil(const QString& path, const QString& how) {
  const QByteArray bytes = testing::bytesOf(path);
  QFile::remove(path);
  if (how == "missing") return true;
  if (how == "a folder") return QDir().mkdir(path);
  if (how == "empty") return testing::overwrite(path, {});
  if (how == "cut") return testing::overwrite(path, bytes.left(bytes.size() / 2));
  if (how == "noise") {
    QByteArray noise;
    for (quint32 k = 1; k < 4000; ++k) noise += static_cast<char>((k * 2654435761U) >> 24);
    return testing::overwrite(path, noise);
  }
  if (how == "huge") {  // zeros that take no room on the disk, more than a run may have memory
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.resize(qint64{5} << 30);
  }
  return false;
}

/// One sentence that names the file, and no other file than before.
void verifyRefused(const CliRun& run, const QString& named, const QStringList& before, const OfficeFolder& office) {
  QVERIFY2(run.exit_code == 1, qPrintable(QString::number(run.exit_code) + " " + run.err));
  QVERIFY2(run.errors().size() == 1, qPrintable(run.err));
  QVERIFY2(run.errors()[0].startsWith("cad2slam-cli: "), qPrintable(run.err));
  QVERIFY2(run.errors()[0].contains(named), qPrintable(run.err));
  QVERIFY2(run.errors()[0].size() < 400, qPrintable(run.err));
  QVERIFY(!run.errors()[0].endsWith('.'));
  QCOMPARE(office.names(), before);
}

}  // namespace

void BadInputTest::initTestCase() {
  const OfficeFolder office;
  const CliRun run = office.run(kSolve);
  QVERIFY2(run.exit_code == 0, qPrintable(run.err));
  projector_ = testing::bytesOf(office.file("out.c2s"));
  QVERIFY(!projector_.isEmpty());
}

void BadInputTest::everyFileOfEveryCommand_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("how");
  const struct {
    const char* name;
    QStringList arguments;
    QStringList files;
  } commands[] = {
      {"solve", kSolve, {"blueprint.yaml", "blueprint.png", "slam_1.yaml", "slam_1.png", "anchors_1.csv"}},
      {"solve project", kSolveProject, {"p.c2sproj"}},
      {"info", kInfo, {"office.c2s"}},
      {"project", kProject, {"office.c2s", "poses.csv"}},
      {"warp", kWarp, {"office.c2s", "blueprint.yaml", "blueprint.png"}},
      {"preview", kPreview, {"office.c2s", "blueprint.png", "slam_1.yaml", "slam_1.png"}},
      {"convert", kConvert, {"anchors_1.csv"}},
  };
  for (const auto& command : commands) {
    for (const QString& file : command.files) {
      for (const char* how : {"missing", "a folder", "empty", "cut", "noise", "huge"}) {
        const QString row = QString("%1, %2 %3").arg(QString(command.name), file, QString(how));
        // These are no mistakes: half of a list is a list, no pose needs no answer, and of a SLAM map solve wants only
        // the size.
        if (file.endsWith(".csv") && QString(how) == "cut") continue;
        if (file == "poses.csv" && QString(how) == "empty") continue;
        if (row == "solve, slam_1.png cut") continue;
        QTest::newRow(qPrintable(row)) << command.arguments << file << QString(how);
      }
    }
  }
}

void BadInputTest::everyFileOfEveryCommand() {
  QFETCH(QStringList, arguments);
  QFETCH(QString, file);
  QFETCH(QString, how);
  const OfficeFolder office;
  QVERIFY(testing::overwrite(office.file("office.c2s"), projector_));
  QVERIFY(testing::overwrite(office.file("poses.csv"), "-5,0\n"));
  QVERIFY(testing::overwrite(office.file("p.c2sproj"), "{\"format\": \"cad2slam-project\"}"));
  QVERIFY(spoil(office.file(file), how));
  const QStringList before = office.names();
  verifyRefused(office.run(arguments), file, before, office);
}

void BadInputTest::lyingContent_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QString>("file");
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<QString>("named");
  const auto yaml = [](const char* line) {
    return QByteArray(
               "image: blueprint.png\norigin: [-10, -5, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
               "free_thresh: 0.196\n") +
           line + '\n';
  };
  QTest::newRow("resolution 0") << kSolve << "blueprint.yaml" << yaml("resolution: 0") << "blueprint.yaml";
  QTest::newRow("resolution nan") << kSolve << "blueprint.yaml" << yaml("resolution: .nan") << "blueprint.yaml";
  QTest::newRow("resolution in words") << kSolve << "blueprint.yaml" << yaml("resolution: fine") << "blueprint.yaml";
  QTest::newRow("no resolution") << kSolve << "blueprint.yaml" << yaml("") << "blueprint.yaml";
  QTest::newRow("image that is none") << kSolve << "blueprint.yaml"
                                      << yaml("resolution: 0.025").replace("blueprint.png", "anchors_1.csv")
                                      << "anchors_1.csv";
  QTest::newRow("nested YAML") << kSolve << "blueprint.yaml" << QByteArray(200'000, '[') << "blueprint.yaml";
  QTest::newRow("YAML of aliases") << kSolve << "blueprint.yaml"
                                   << QByteArray("a: &a [x,x,x,x]\nb: &b [*a,*a,*a,*a]\nc: [*b,*b,*b,*b]\n")
                                   << "blueprint.yaml";

  // A picture that claims more pixels than it has.
  QByteArray png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x75\x30\0\0\x75\x30\x08\0\0\0\0\xb2\x86\x4a\x58", 33);
  QTest::newRow("PNG of a header") << kSolve << "blueprint.png" << png << "blueprint.png";
  QTest::newRow("PGM of a header") << kSolve << "blueprint.png" << QByteArray("P5\n30000 30000\n255\nxxxx")
                                   << "blueprint.png";
  QTest::newRow("PGM beyond all limits") << kSolve << "blueprint.png" << QByteArray("P5\n2000000000 2000000000\n255\n")
                                         << "blueprint.png";

  QTest::newRow("nested project") << kSolveProject << "p.c2sproj" << QByteArray(500'000, '[') << "p.c2sproj";
  QTest::newRow("project of another version")
      << kSolveProject << "p.c2sproj" << QByteArray("{\"format\": \"cad2slam-project\", \"version\": 99}")
      << "p.c2sproj";

  for (const QStringList& arguments : {kInfo, kProject, kWarp, kPreview}) {
    const QByteArray command = arguments[0].toUtf8();
    QByteArray bytes = projector_;
    bytes[bytes.size() - 100] = static_cast<char>(bytes[bytes.size() - 100] ^ 1);
    QTest::newRow((command + ", one bit turned").constData()) << arguments << "office.c2s" << bytes << "office.c2s";
    bytes = projector_;
    qToLittleEndian(quint64{1} << 62, bytes.data());
    QTest::newRow((command + ", endless header").constData()) << arguments << "office.c2s" << bytes << "office.c2s";
    QTest::newRow((command + ", one byte more").constData())
        << arguments << "office.c2s" << projector_ + 'x' << "office.c2s";
  }
}

void BadInputTest::lyingContent() {
  QFETCH(QStringList, arguments);
  QFETCH(QString, file);
  QFETCH(QByteArray, content);
  QFETCH(QString, named);
  const OfficeFolder office;
  QVERIFY(testing::overwrite(office.file("office.c2s"), projector_));
  QVERIFY(testing::overwrite(office.file("poses.csv"), "-5,0\n"));
  QVERIFY(testing::overwrite(office.file(file), content));
  const QStringList before = office.names();
  verifyRefused(office.run(arguments), named, before, office);
}

void BadInputTest::anchorsThatDetermineNothing_data() {
  QTest::addColumn<QByteArray>("anchors");
  QTest::addColumn<QString>("named");
  QTest::newRow("none") << QByteArray("id,blueprint_x,blueprint_y,slam_x,slam_y\n") << "anchor";
  QTest::newRow("all disabled") << QByteArray("id,blueprint_x,blueprint_y,slam_x,slam_y,enabled\n1,0,0,0,0,0\n")
                                << "anchor";
  QTest::newRow("contradiction") << QByteArray("1,0,0,0,0\n2,5,5,5,5\n7,0,0,0,3\n") << "anchors 1 and 7";
  QTest::newRow("far outside") << QByteArray("1,0,0,0,0\n2,5,5,5,5\n3,5000,0,0,3\n") << "anchor 3";
}

void BadInputTest::anchorsThatDetermineNothing() {
  QFETCH(QByteArray, anchors);
  QFETCH(QString, named);
  const OfficeFolder office;
  QVERIFY(testing::overwrite(office.file("anchors_1.csv"), anchors));
  const QStringList before = office.names();
  verifyRefused(office.run(kSolve), named, before, office);
}

void BadInputTest::outputsThatCannotBeWritten_data() {
  QTest::addColumn<QStringList>("arguments");
  for (const QStringList& arguments : {kSolve, kWarp, kPreview, kConvert}) {
    QTest::newRow(qPrintable(arguments[0])) << arguments;
  }
}

void BadInputTest::outputsThatCannotBeWritten() {
  QFETCH(QStringList, arguments);
  const OfficeFolder office;
  QVERIFY(testing::overwrite(office.file("office.c2s"), projector_));
  const QString suffix = arguments.last().mid(3);
  QVERIFY(QDir(office.path()).mkdir("folder" + suffix));
  const QStringList before = office.names();
  QStringList outputs{"nowhere/out" + suffix, "folder" + suffix};
  if (suffix == ".c2s" || suffix == ".csv") outputs << "/dev/full";  // the others write a second file beside it
  for (const QString& output : outputs) {
    QStringList changed = arguments;
    changed.last() = output;
    verifyRefused(office.run(changed), QFileInfo(output).path() == "nowhere" ? "nowhere/out" : output, before, office);
  }
}

void BadInputTest::fullDiskKeepsTheOldFile_data() {
  outputsThatCannotBeWritten_data();
}

void BadInputTest::fullDiskKeepsTheOldFile() {
  QFETCH(QStringList, arguments);
  const OfficeFolder office;
  QVERIFY(testing::overwrite(office.file("office.c2s"), projector_));
  QVERIFY(testing::overwrite(office.file(arguments.last()), "the old file"));
  const QStringList before = office.names();
  constexpr rlim_t kFewBytes = 100;
  const CliRun run = office.run(arguments, {}, {kFewBytes, {}});
  verifyRefused(run, "out", before, office);
  QCOMPARE(testing::bytesOf(office.file(arguments.last())), QByteArray("the old file"));
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::BadInputTest)
#include "bad_input_test.moc"

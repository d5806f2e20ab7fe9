// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QJsonArray>
#include <QRegularExpression>
#include <QtTest>

#include <cmath>

#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/project_file.h"
#include "cad2slam/io/projector_file.h"
#include "cli/cli_runner.h"

/// cad2slam-cli from anchors to projected poses and pictures, as a script calls it.
namespace cad2slam {

using testing::CliRun;
using testing::OfficeFolder;

class MainJobTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void usage_data();
  void usage();
  void helpAndVersion();
  void choicesAreWords();
  void inputsAreNotOverwritten();
  void solveReports();
  void solveTellsWhatTheMapsSay();
  void jsonHasAllKeys();
  void optionsReachTheProjector();
  void solveTakesAProject();
  void infoDescribesTheFile();
  void posesGoThereAndBack();
  void oneLineOutForEachLineIn();
  void numbersHaveNineDecimals();
  void outsideIsSaid();
  void linesThatAreNoPosesAreNamed();
  void warpWritesAMap_data();
  void warpWritesAMap();
  void previewWritesAPicture();
  void convertReadsBothKinds();
  void reproducibleFilesAreIdentical();

 private:
  OfficeFolder office_;
};

void MainJobTest::initTestCase() {
  const CliRun run = office_.run(OfficeFolder::solveArguments({"-o", "office.c2s"}));
  QVERIFY2(run.exit_code == 0, qPrintable(run.err));
}

void MainJobTest::usage_data() {
  QTest::addColumn<QString>("arguments");
  for (const char* arguments :
       {"", "fly", "solve", "solve -o x.c2s", "solve --blueprint blueprint.yaml -o x.c2s", "solve p.c2sproj",
        "solve p.c2sproj --blueprint blueprint.yaml --slam slam_1.yaml --anchors anchors_1.csv -o x.c2s",
        "solve p.c2sproj -o x.c2s --model soft", "project office.c2s", "project office.c2s --to moon",
        "project --to slam", "project office.c2s --to slam --outside maybe", "info", "info office.c2s --yaml",
        "warp office.c2s --to slam", "warp office.c2s blueprint.yaml --to slam -o x.yaml --resolution -1",
        "preview office.c2s -o x.png", "convert", "convert anchors anchors_1.csv"}) {
    QTest::newRow(*arguments == '\0' ? "nothing" : arguments) << QString(arguments);
  }
}

void MainJobTest::usage() {
  QFETCH(QString, arguments);
  const QStringList before = office_.names();
  const CliRun run = office_.run(arguments.split(' ', Qt::SkipEmptyParts));
  QCOMPARE(run.exit_code, 2);
  QVERIFY(run.out.isEmpty());
  QVERIFY(!run.err.isEmpty());
  QCOMPARE(office_.names(), before);
}

void MainJobTest::helpAndVersion() {
  const CliRun help = office_.run({"--help"});
  QCOMPARE(help.exit_code, 0);
  for (const char* command : {"solve", "project", "info", "warp", "preview", "convert"}) {
    QVERIFY(help.out.contains(command));
    const CliRun details = office_.run({command, "--help"});
    QCOMPARE(details.exit_code, 0);
    QVERIFY(details.out.contains("Usage"));
  }
  const CliRun version = office_.run({"--version"});
  QCOMPARE(version.exit_code, 0);
  QVERIFY(QRegularExpression("^cad2slam-cli \\d+\\.\\d+\\.\\d+\n$").match(version.out).hasMatch());
}

void MainJobTest::choicesAreWords() {
  for (const char* command : {"solve", "project", "warp", "export features", "export grid", "export keepout"}) {
    const CliRun help = office_.run(QString(command).split(' ') << "--help");
    QVERIFY2(!help.out.contains("->") && !help.out.contains("ENUM") && !help.out.contains("BOOLEAN"), command);
  }
  const CliRun wrong = office_.run({"warp", "office.c2s", "blueprint.yaml", "-o", "warped.yaml", "--to", "moon"});
  QCOMPARE(wrong.exit_code, 2);
  QVERIFY2(wrong.err.contains("--to: moon not in {slam,blueprint}"), qPrintable(wrong.err));
  // What stands behind a word is no word.
  QCOMPARE(office_.run({"warp", "office.c2s", "blueprint.yaml", "-o", "warped.yaml", "--to", "1"}).exit_code, 2);
}

void MainJobTest::inputsAreNotOverwritten() {
  const auto contentOf = [this](const QString& name) {
    QFile file(office_.file(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  };
  const QStringList before = office_.names();
  const QByteArray projector = contentOf("office.c2s");
  const QByteArray plan = contentOf("blueprint.yaml");
  for (const QStringList& arguments : {QStringList{"export", "g2o", "office.c2s", "-o", "office.c2s"},
                                       {"export", "tinshift", "office.c2s", "--output", "./office.c2s"},
                                       {"warp", "office.c2s", "blueprint.yaml", "--to", "slam", "-o", "blueprint.yaml"},
                                       {"export", "grid", "office.c2s", "--to", "slam", "-o", "grid.json"}}) {
    const CliRun run = office_.run(arguments);
    QCOMPARE(run.exit_code, 1);
    QVERIFY2(run.sentence().contains(arguments.last()), qPrintable(run.err));
  }
  QCOMPARE(office_.names(), before);
  QCOMPARE(contentOf("office.c2s"), projector);
  QCOMPARE(contentOf("blueprint.yaml"), plan);
}

void MainJobTest::solveReports() {
  const CliRun run = office_.run(OfficeFolder::solveArguments({"-o", "again.c2s"}));
  QCOMPARE(run.exit_code, 0);
  QVERIFY(run.errors().isEmpty());
  for (const char* part : {"30 of 30 anchors", "scale", "rotation", "rms", "worst anchors", "written: again.c2s"}) {
    QVERIFY2(run.out.contains(part), part);
  }
  QVERIFY(QFile::exists(office_.file("again.c2s")));
}

void MainJobTest::solveTellsWhatTheMapsSay() {
  QFile usual(office_.file("slam_1.yaml"));
  QVERIFY(usual.open(QIODevice::ReadOnly));
  QByteArray text = usual.readAll();
  const qsizetype yaw = text.lastIndexOf(',', text.indexOf(']'));
  text.replace(yaw, text.indexOf(']') - yaw, ", .nan");
  QFile odd(office_.file("odd.yaml"));
  QVERIFY(odd.open(QIODevice::WriteOnly) && odd.write(text) == text.size());
  odd.close();
  QStringList arguments = OfficeFolder::solveArguments({"-o", "odd.c2s"});
  arguments.replaceInStrings("slam_1.yaml", "odd.yaml");
  const CliRun run = office_.run(arguments);
  QVERIFY2(run.err.contains("odd.yaml: The yaw of origin is not a number and was read as 0."), qPrintable(run.err));
}

void MainJobTest::jsonHasAllKeys() {
  const CliRun run = office_.run(OfficeFolder::solveArguments({"-o", "json.c2s", "--json"}));
  QCOMPARE(run.exit_code, 0);
  const QJsonObject report = run.json();
  for (const char* key : {"nodes", "edges", "anchors_used", "model", "scale", "rotation_rad", "cost", "iterations",
                          "converged", "seconds", "anchors", "warnings"}) {
    QVERIFY2(report.contains(key), key);
  }
  for (const char* key : {"load", "mesh", "solve", "write"}) {
    QVERIFY2(report["seconds"].toObject()[key].isDouble(), key);
  }
  QCOMPARE(report["anchors_used"].toInt(), 30);
  QCOMPARE(report["model"].toString(), QString("stretch"));
  QVERIFY(report["converged"].toBool());
  QVERIFY(std::abs(report["scale"].toDouble() - 1.0) < 0.1);
  const QJsonArray anchors = report["anchors"].toArray();
  QCOMPARE(anchors.size(), 30);
  for (int k = 0; k < anchors.size(); ++k) {
    const QJsonObject anchor = anchors[k].toObject();
    QCOMPARE(anchor["id"].toInt(), k + 1);
    QVERIFY(anchor["residual_m"].toDouble(-1.0) >= 0.0);
    QVERIFY(anchor["leave_one_out_m"].toDouble(-1.0) >= 0.0);
  }
  const ProjectorData data = *readProjectorFile(office_.file("json.c2s").toStdString());
  QCOMPARE(static_cast<std::size_t>(report["nodes"].toInt()), data.node_tile.size());
  QCOMPARE(static_cast<std::size_t>(report["edges"].toInt()), data.edges.size());
}

void MainJobTest::optionsReachTheProjector() {
  const CliRun run = office_.run(
      OfficeFolder::solveArguments({"-o", "options.c2s", "--model", "rigid", "--scale", "1.01", "--weights", "paper",
                                    "--radius", "5", "--outside", "rigid", "--backend", "ceres", "--json"}));
  QCOMPARE(run.exit_code, 0);
  QCOMPARE(run.json()["scale"].toDouble(), 1.01);
  const ProjectorInfo info = readProjectorFile(office_.file("options.c2s").toStdString())->info;
  QCOMPARE(info.model, std::string("rigid"));
  QCOMPARE(info.scale, 1.01);
  QCOMPARE(info.radius_m, 5.0);
  QCOMPARE(info.lattice.cell_size, 2.0);
  QVERIFY(info.weights == BlendWeights::kPaper && info.outside == OutsidePolicy::kRigid);
  for (const QStringList& bad : {QStringList{"--scale", "big"},
                                 {"--scale", "-1"},
                                 {"--scale", "nan"},
                                 {"--cell-size", "0"},
                                 {"--cell-size", "1e-9"}}) {
    const CliRun refused = office_.run(OfficeFolder::solveArguments(QStringList{"-o", "bad.c2s"} + bad));
    QVERIFY(refused.exit_code == 1 || refused.exit_code == 2);
    QVERIFY(!QFile::exists(office_.file("bad.c2s")));
  }
}

void MainJobTest::solveTakesAProject() {
  Project project;
  project.name = "office";
  const std::filesystem::path folder = office_.path().toStdString();
  project.blueprint = *describeRaster(readMapYaml(folder / "blueprint.yaml")->metadata);
  const AnchorList anchors = readAnchors(folder / "anchors_1.csv")->anchors;
  const ProjectRaster slam = *describeRaster(readMapYaml(folder / "slam_1.yaml")->metadata);
  project.slam_maps = {{"forklift", slam, anchors, {}}, {"cleaner", slam, {anchors.begin(), anchors.begin() + 9}, {}}};
  project.cell_size_m = 2.0;
  QVERIFY(writeProject(folder / "office.c2sproj", project).has_value());

  const CliRun both = office_.run({"solve", "office.c2sproj", "-o", "none.c2s"});
  QCOMPARE(both.exit_code, 1);
  QVERIFY(both.err.contains("forklift") && both.err.contains("cleaner") && both.err.contains("--map"));
  const CliRun unknown = office_.run({"solve", "office.c2sproj", "--map", "drone", "-o", "none.c2s"});
  QCOMPARE(unknown.exit_code, 1);
  QVERIFY(unknown.err.contains("drone") && unknown.err.contains("forklift"));
  QVERIFY(!QFile::exists(office_.file("none.c2s")));

  const CliRun cleaner = office_.run({"solve", "office.c2sproj", "--map", "cleaner", "-o", "cleaner.c2s", "--json"});
  QVERIFY2(cleaner.exit_code == 0, qPrintable(cleaner.err));
  QCOMPARE(cleaner.json()["anchors_used"].toInt(), 9);
  const ProjectorInfo info = readProjectorFile(office_.file("cleaner.c2s").toStdString())->info;
  QCOMPARE(info.slam.name, std::string("cleaner"));
  QCOMPARE(info.project, std::string("office.c2sproj"));
}

void MainJobTest::infoDescribesTheFile() {
  const CliRun text = office_.run({"info", "office.c2s"});
  QCOMPARE(text.exit_code, 0);
  for (const char* part : {"blueprint", "SLAM map", "stretch", "nodes", "anchors", "all reproduced"}) {
    QVERIFY2(text.out.contains(part), part);
  }
  const CliRun json = office_.run({"info", "office.c2s", "--json"});
  QCOMPARE(json.exit_code, 0);
  const QJsonObject report = json.json();
  for (const char* key : {"model", "scale", "weights", "outside", "cell_size_m", "nodes", "edges", "anchors",
                          "check_poses", "blueprint", "slam", "quality", "creator", "created"}) {
    QVERIFY2(report.contains(key), key);
  }
  QCOMPARE(report["blueprint"].toObject()["name"].toString(), QString("blueprint"));
  QCOMPARE(report["blueprint"].toObject()["image_sha256"].toString().size(), 64);
  QCOMPARE(report["quality"].toObject()["anchors_used"].toInt(), 30);
}

void MainJobTest::posesGoThereAndBack() {
  // The anchors of the file itself, with headings all around.
  const ProjectorData data = *readProjectorFile(office_.file("office.c2s").toStdString());
  QByteArray poses;
  for (std::size_t k = 0; k < data.check_poses.size(); ++k) {
    const Pose2& pose = data.check_poses[k].in_blueprint;
    poses += QByteArray::number(pose.translation.x(), 'f', 9) + ',' + QByteArray::number(pose.translation.y(), 'f', 9) +
             ',' + QByteArray::number(pose.heading, 'f', 9) + '\n';
  }
  const CliRun there = office_.run({"project", "office.c2s", "--to", "slam"}, poses);
  QCOMPARE(there.exit_code, 0);
  QCOMPARE(static_cast<std::size_t>(there.lines().size()), data.check_poses.size());
  QByteArray slam_poses;
  for (const QString& line : there.lines()) {
    QVERIFY(line.endsWith(",inside"));
    slam_poses += line.section(',', 0, 2).toUtf8() + '\n';
  }
  QVERIFY(testing::overwrite(office_.file("poses.csv"), slam_poses));
  const CliRun back = office_.run({"project", "office.c2s", "poses.csv", "--to", "blueprint"});
  QCOMPARE(back.exit_code, 0);
  for (qsizetype k = 0; k < back.lines().size(); ++k) {
    const QStringList found = back.lines()[k].split(',');
    const Pose2& start = data.check_poses[static_cast<std::size_t>(k)].in_blueprint;
    QVERIFY(std::abs(found[0].toDouble() - start.translation.x()) < 1e-6);
    QVERIFY(std::abs(found[1].toDouble() - start.translation.y()) < 1e-6);
    QVERIFY(std::abs(wrapAngle(found[2].toDouble() - start.heading)) < 1e-6);
  }
}

void MainJobTest::oneLineOutForEachLineIn() {
  const QByteArray input = "x,y,theta\n# a comment\n-5,0\n\n-5;0;1.5\r\n  -5\t0  +1.5\n-5 0 -7\n-5,0,0";
  const CliRun run = office_.run({"project", "office.c2s", "-", "--to", "slam"}, input);
  QVERIFY2(run.exit_code == 0, qPrintable(run.err));
  const QStringList lines = run.out.split('\n');
  QCOMPARE(lines.size(), 9);  // eight and the end of the last
  QCOMPARE(lines[0], QString("x,y,theta,status"));
  QCOMPARE(lines[1], QString("# a comment"));
  QVERIFY(lines[3].isEmpty());
  QCOMPARE(lines[2], lines[7]);  // a heading left out is 0
  QCOMPARE(lines[4], lines[5]);
  for (const int k : {2, 4, 5, 6, 7}) QCOMPARE(lines[k].count(','), 3);
}

void MainJobTest::numbersHaveNineDecimals() {
  const CliRun run = office_.run({"project", "office.c2s", "--to", "slam"}, "-5,0,1\n");
  QVERIFY(QRegularExpression("^-?\\d+\\.\\d{9},-?\\d+\\.\\d{9},-?\\d\\.\\d{9},inside\n$").match(run.out).hasMatch());
}

void MainJobTest::outsideIsSaid() {
  const QByteArray input = "-5,0\n500,500\n-5,0\n";
  const CliRun run = office_.run({"project", "office.c2s", "--to", "slam"}, input);
  QCOMPARE(run.exit_code, 1);
  QCOMPARE(run.lines().size(), 3);
  QCOMPARE(run.lines()[1], QString("nan,nan,nan,outside"));
  QVERIFY(run.lines()[2].endsWith(",inside"));
  QCOMPARE(run.errors().size(), 1);
  QVERIFY(run.err.contains("1 of 3") && run.err.contains("line 2"));
  const CliRun rigid = office_.run({"project", "office.c2s", "--to", "slam", "--outside", "rigid"}, input);
  QCOMPARE(rigid.exit_code, 0);
  QVERIFY(rigid.lines()[1].endsWith(",extrapolated"));
}

void MainJobTest::linesThatAreNoPosesAreNamed() {
  for (const QByteArray& line :
       {QByteArray("1"), QByteArray("1,2,3,4"), QByteArray("one,two"), QByteArray("1,nan"), QByteArray("inf,1"),
        QByteArray("1,2e999"), QByteArray("0x10,1"), QByteArray("1,2,3\0", 6), QByteArray(10000, '1')}) {
    const CliRun run = office_.run({"project", "office.c2s", "--to", "slam"}, "-5,0\n" + line + "\n-5,0\n");
    QCOMPARE(run.exit_code, 1);
    QCOMPARE(run.errors().size(), 1);
    QVERIFY(run.err.contains("standard input:2"));
    QCOMPARE(run.lines().size(), 1);  // what came before is answered
  }
}

void MainJobTest::warpWritesAMap_data() {
  QTest::addColumn<QString>("target");
  QTest::addColumn<QString>("image");
  QTest::newRow("to SLAM") << "slam"
                           << "blueprint.yaml";
  QTest::newRow("to blueprint") << "blueprint"
                                << "slam_1.yaml";
}

void MainJobTest::warpWritesAMap() {
  QFETCH(QString, target);
  QFETCH(QString, image);
  const QString output = target + "_warped.yaml";
  const CliRun run = office_.run({"warp", "office.c2s", image, "--to", target, "-o", output});
  QVERIFY2(run.exit_code == 0, qPrintable(run.err));
  const Result<LoadedMap> warped = loadMap(office_.file(output).toStdString());
  QVERIFY(warped.has_value());
  const LoadedMap like = *loadMap(office_.file(target == "slam" ? "slam_1.yaml" : "blueprint.yaml").toStdString());
  QCOMPARE(warped->grid.frame().width(), like.grid.frame().width());
  QCOMPARE(warped->grid.frame().height(), like.grid.frame().height());
  QVERIFY(warped->grid.frame().metricFromCorner().translation == like.grid.frame().metricFromCorner().translation);
  // Both maps now lie on each other: where one is free the other mostly is too.
  int free = 0;
  int both = 0;
  for (int row = 0; row < like.grid.frame().height(); row += 4) {
    for (int column = 0; column < like.grid.frame().width(); column += 4) {
      if (warped->grid.at(column, row) != CellState::kFree) continue;
      ++free;
      both += like.grid.at(column, row) == CellState::kFree ? 1 : 0;
    }
  }
  QVERIFY(free > 1000);
  QVERIFY2(both > 0.6 * free, qPrintable(QString("%1 of %2").arg(both).arg(free)));
  const CliRun coarse =
      office_.run({"warp", "office.c2s", image, "--to", target, "-o", "coarse.yaml", "--resolution", "0.2"});
  QCOMPARE(coarse.exit_code, 0);
  QCOMPARE(loadMap(office_.file("coarse.yaml").toStdString())->grid.frame().resolution(), 0.2);
}

void MainJobTest::previewWritesAPicture() {
  const CliRun run = office_.run(
      {"preview", "office.c2s", "--blueprint", "blueprint.yaml", "--slam", "slam_1.yaml", "-o", "preview.png"});
  QVERIFY2(run.exit_code == 0, qPrintable(run.err));
  const Result<cv::Mat> picture = loadPicture(office_.file("preview.png").toStdString());
  QVERIFY(picture.has_value());
  QCOMPARE(picture->channels(), 3);
  const LoadedMap slam = *loadMap(office_.file("slam_1.yaml").toStdString());
  QCOMPARE(picture->cols, slam.grid.frame().width());
}

void MainJobTest::convertReadsBothKinds() {
  QVERIFY(testing::overwrite(office_.file("a.data"),
                             "\"CorrespondenceAnchor\" : {\n  \"_cad_point\" : [ 1.5, -2.25 ],\n"
                             "  \"_slam_point\" : [ 3, -4e-1 ]\n }\n\n"
                             "\"CorrespondenceAnchor\" : { \"_cad_point\" : [ 5, 6 ], \"_slam_point\" : [ 7, 8 ] }\n"));
  const CliRun run = office_.run({"convert", "anchors", "a.data", "-o", "a.csv"});
  QVERIFY2(run.exit_code == 0, qPrintable(run.err));
  const AnchorList anchors = readAnchorsCsv(office_.file("a.csv").toStdString())->anchors;
  QCOMPARE(anchors.size(), std::size_t{2});
  QVERIFY(anchors[0].in_blueprint == Eigen::Vector2d(1.5, -2.25));
  QVERIFY(anchors[0].in_slam == Eigen::Vector2d(3.0, -0.4));
  // Our own CSV comes out as it went in.
  QCOMPARE(office_.run({"convert", "anchors", "a.csv", "-o", "b.csv"}).exit_code, 0);
  QCOMPARE(testing::bytesOf(office_.file("b.csv")), testing::bytesOf(office_.file("a.csv")));
  // Lines that cannot be read are named and skipped.
  QVERIFY(testing::overwrite(office_.file("c.csv"), "1,2,3,4,5\n2,x,3,4,5\n3,4,5,6,7\n"));
  const CliRun partly = office_.run({"convert", "anchors", "c.csv", "-o", "d.csv"});
  QCOMPARE(partly.exit_code, 0);
  QVERIFY(partly.err.contains("c.csv:2"));
  QCOMPARE(readAnchorsCsv(office_.file("d.csv").toStdString())->anchors.size(), std::size_t{2});
}

void MainJobTest::reproducibleFilesAreIdentical() {
  for (const char* name : {"first.c2s", "second.c2s"}) {
    QCOMPARE(office_.run(OfficeFolder::solveArguments({"-o", name, "--reproducible"})).exit_code, 0);
  }
  const QByteArray first = testing::bytesOf(office_.file("first.c2s"));
  QVERIFY(!first.isEmpty());
  QVERIFY(first == testing::bytesOf(office_.file("second.c2s")));
  QVERIFY(readProjectorFile(office_.file("first.c2s").toStdString())->info.created.empty());
  QVERIFY(!readProjectorFile(office_.file("office.c2s").toStdString())->info.created.empty());
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::MainJobTest)
#include "main_job_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/true_warp_file.h"

#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>
#include <fstream>

using namespace cad2slam;
namespace fs = std::filesystem;

namespace {

const fs::path kSites = CAD2SLAM_SAMPLE_MAPS;

void overwrite(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string slurp(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

class TrueWarpFileTest : public QObject {
  Q_OBJECT
 private slots:
  void truthSurvivesWritingAndReading();
  void brokenTruthFiles_data();
  void brokenTruthFiles();
};

void TrueWarpFileTest::truthSurvivesWritingAndReading() {
  const QTemporaryDir folder;
  const Result<TrueWarp> truth = readTrueWarp(kSites / "office" / "truth_1.yaml");
  QVERIFY(truth);
  const fs::path copy = fs::path(folder.path().toStdString()) / "copy.yaml";
  QVERIFY(writeTrueWarp(copy, *truth));
  const Result<TrueWarp> again = readTrueWarp(copy);
  QVERIFY(again);
  QCOMPARE(again->layout().first, truth->layout().first);
  QCOMPARE(again->layout().step_m, truth->layout().step_m);
  QCOMPARE(slurp(fs::path(copy).replace_extension(".npy")), slurp(kSites / "office" / "truth_1.npy"));
}

void TrueWarpFileTest::brokenTruthFiles_data() {
  QTest::addColumn<QByteArray>("yaml");
  QTest::addColumn<QByteArray>("grid");
  const QByteArray good_yaml = "grid: t.npy\norigin: [0, 0]\nstep: 0.5\n";
  const QByteArray head = QByteArray("\x93NUMPY\x01\x00", 8);
  const auto npy = [&](const QByteArray& header, int floats) {
    return head + QByteArray(1, static_cast<char>(header.size())) + QByteArray(1, 0) + header +
           QByteArray(4 * floats, 0);
  };
  const QByteArray good = npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2, 3), }\n", 12);
  QTest::newRow("not yaml") << QByteArray("grid: [") << good;
  QTest::newRow("aliases") << QByteArray("grid: t.npy\norigin: &o [0, 0]\nstep: 0.5\nmore: [*o, *o]\n") << good;
  QTest::newRow("deep lists") << "grid: t.npy\norigin: " + QByteArray(60'000, '[') << good;
  QTest::newRow("no grid") << QByteArray("origin: [0, 0]\nstep: 1\n") << good;
  QTest::newRow("a list") << QByteArray("[1, 2]") << good;
  QTest::newRow("no step") << QByteArray("grid: t.npy\norigin: [0, 0]\n") << good;
  QTest::newRow("origin of one") << QByteArray("grid: t.npy\norigin: [0]\nstep: 1\n") << good;
  QTest::newRow("step in words") << QByteArray("grid: t.npy\norigin: [0, 0]\nstep: half\n") << good;
  QTest::newRow("negative step") << QByteArray("grid: t.npy\norigin: [0, 0]\nstep: -1\n") << good;
  QTest::newRow("missing grid file") << QByteArray("grid: other.npy\norigin: [0, 0]\nstep: 1\n") << good;
  QTest::newRow("empty grid") << good_yaml << QByteArray();
  QTest::newRow("other magic") << good_yaml << QByteArray("PK\x03\x04 something else");
  QTest::newRow("ends in the header") << good_yaml << good.left(30);
  QTest::newRow("one float short") << good_yaml << good.left(good.size() - 4);
  QTest::newRow("one byte more") << good_yaml << good + "x";
  QTest::newRow("lying shape")
      << good_yaml << npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2000000000, 2000000000, 3), }\n", 12);
  QTest::newRow("negative shape") << good_yaml
                                  << npy("{'descr': '<f4', 'fortran_order': False, 'shape': (-2, -2, 3), }\n", 0);
  QTest::newRow("two layers") << good_yaml
                              << npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2, 2), }\n", 8);
  QTest::newRow("doubles") << good_yaml << npy("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 3), }\n", 24);
  QTest::newRow("columns first") << good_yaml
                                 << npy("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 2, 3), }\n", 12);
  QTest::newRow("no shape") << good_yaml << npy("{'descr': '<f4', 'fortran_order': False }\n", 12);
}

void TrueWarpFileTest::brokenTruthFiles() {
  QFETCH(QByteArray, yaml);
  QFETCH(QByteArray, grid);
  const QTemporaryDir folder;
  const fs::path root = folder.path().toStdString();
  overwrite(root / "t.yaml", yaml.toStdString());
  overwrite(root / "t.npy", grid.toStdString());
  const Result<TrueWarp> truth = readTrueWarp(root / "t.yaml");
  QVERIFY(!truth);
  QVERIFY(!truth.error().message.empty());
}

QTEST_APPLESS_MAIN(TrueWarpFileTest)
#include "true_warp_file_test.moc"

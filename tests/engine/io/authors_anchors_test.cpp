// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include "cad2slam/io/anchors_csv.h"
#include "support/temporary_folder.h"

using namespace cad2slam;

namespace {

const std::string kTwo =
    "\"CorrespondenceAnchor\" : { \n  \"_cad_point\" : [ 2.5, -1.75 ], \n  \"_slam_point\" : [ 0.5, 3 ]\n }\n\n"
    "\"CorrespondenceAnchor\" : { \"_slam_point\" : [6,7], \"_cad_point\":[4 , 5e0] }\n";

}  // namespace

class AuthorsAnchorsTest : public QObject {
  Q_OBJECT

 private slots:
  void objectsBecomeAnchorsInOrder() {
    const Result<AnchorImport> import = parseAuthorsAnchors(kTwo, "a.data");
    QVERIFY(import.has_value());
    QVERIFY(import->rejected.empty());
    const AnchorList expected{{1, {2.5, -1.75}, {0.5, 3.0}, true, "", ""}, {2, {4.0, 5.0}, {6.0, 7.0}, true, "", ""}};
    QVERIFY(import->anchors == expected);
  }

  void contentDecidesTheFormat() {
    const test::TemporaryFolder folder;
    QCOMPARE(readAnchors(folder.write("a.csv", kTwo))->anchors.size(), std::size_t{2});
    QCOMPARE(readAuthorsAnchors(folder.path("a.csv"))->anchors.size(), std::size_t{2});
    QVERIFY(!readAuthorsAnchors(folder.path("none.data")));
  }

  void badObjectsAreNamedAndTheOthersKept_data() {
    QTest::addColumn<QByteArray>("object");
    QTest::addColumn<int>("line");
    QTest::newRow("NaN") << QByteArray("{\"_cad_point\" : [ nan, 1 ], \"_slam_point\" : [ 0, 0 ]}") << 1;
    QTest::newRow("far") << QByteArray("{\"_cad_point\" : [ 1e308, 1 ], \"_slam_point\" : [ 0, 0 ]}") << 1;
    QTest::newRow("one number") << QByteArray("{\n\"_cad_point\" : [ 1 ],\n \"_slam_point\" : [ 0, 0 ]}") << 2;
    QTest::newRow("no SLAM point") << QByteArray("{\"_cad_point\" : [ 1, 2 ]\n}") << 2;
    QTest::newRow("twice") << QByteArray("{\"_cad_point\" : [ 1, 2 ],\n\"_cad_point\" : [ 1, 2 ]}") << 2;
    QTest::newRow("other key") << QByteArray("{ \"_id\" : 3 }") << 1;
    QTest::newRow("no object") << QByteArray("7") << 1;
  }
  void badObjectsAreNamedAndTheOthersKept() {
    QFETCH(QByteArray, object);
    QFETCH(int, line);
    const std::string text = "\"CorrespondenceAnchor\" : " + object.toStdString() + "\n" + kTwo;
    const Result<AnchorImport> import = parseAuthorsAnchors(text, "a.data");
    QVERIFY(import.has_value());
    QCOMPARE(import->anchors.size(), std::size_t{2});
    QCOMPARE(import->anchors[0].id, AnchorId{2});  // the rejected one keeps its number
    QCOMPARE(import->rejected.size(), std::size_t{1});
    QCOMPARE(import->rejected[0].line, static_cast<std::size_t>(line));
    QVERIFY(!import->rejected[0].reason.empty());
  }

  void cutAnywhereNothingIsInvented() {
    const AnchorList all = parseAuthorsAnchors(kTwo, "a.data")->anchors;
    for (std::size_t length = 0; length < kTwo.size(); ++length) {
      const Result<AnchorImport> import = parseAuthorsAnchors(std::string_view(kTwo).substr(0, length), "a.data");
      if (!import) continue;
      for (const Anchor& anchor : import->anchors) QVERIFY(std::find(all.begin(), all.end(), anchor) != all.end());
    }
  }

  void refusesWhatHoldsNoAnchors() {
    for (const char* text : {"", "hello", "\"CorrespondenceAnchor\""}) {
      const Result<AnchorImport> import = parseAuthorsAnchors(text, "a.data");
      QVERIFY(!import);
      QVERIFY(import.error().where.rfind("a.data", 0) == 0);
    }
  }

  void theAuthorsFilesAgreeWithTheirCsv_data() {
    QTest::addColumn<QString>("site");
    for (const char* site : {"demo", "demo_2", "demo_3", "diag", "eiii-0"}) QTest::newRow(site) << site;
  }
  void theAuthorsFilesAgreeWithTheirCsv() {
    QFETCH(QString, site);
    const std::filesystem::path folder = std::filesystem::path(CAD2SLAM_SHARED_DATA) / site.toStdString();
    if (!std::filesystem::exists(folder)) QSKIP("the paper's data are not here");
    const Result<AnchorImport> data = readAnchors(folder / "correspondences.data");
    const Result<AnchorImport> csv = readAnchors(folder / "anchors.csv");
    QVERIFY(data.has_value() && csv.has_value());
    QVERIFY(data->rejected.empty() && csv->rejected.empty());
    QCOMPARE(data->anchors.size(), csv->anchors.size());
    for (std::size_t k = 0; k < csv->anchors.size(); ++k) {  // the CSV has seven digits
      QCOMPARE(data->anchors[k].id, csv->anchors[k].id);
      QVERIFY((data->anchors[k].in_blueprint - csv->anchors[k].in_blueprint).norm() < 1e-5);
      QVERIFY((data->anchors[k].in_slam - csv->anchors[k].in_slam).norm() < 1e-5);
    }
  }
};

QTEST_APPLESS_MAIN(AuthorsAnchorsTest)
#include "authors_anchors_test.moc"

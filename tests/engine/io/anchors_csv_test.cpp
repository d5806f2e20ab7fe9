// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/anchors_csv.h"

#include <QtTest>

#include <cstring>
#include <limits>
#include <random>

#include "support/temporary_folder.h"

using namespace cad2slam;

namespace {

const AnchorList kThree{
    {1, {2.5, -1.75}, {0.5, 3.0}, true, "door", ""},
    {2, {4.0, 5.0}, {6.0, 7.0}, false, "", ""},
    {7, {-1e-3, 0.0}, {1e4, 2.0}, true, "", ""},
};

std::string randomText(std::mt19937& random) {
  static const std::vector<std::string> kPieces{"a", "Z",  " ",    "\t",   ",",        ";", "\"",           "\"\"",
                                                "#", "\n", "\r",   "\r\n", "\xc3\xbc", "'", "\xe2\x82\xac", "1.5",
                                                "-", "=",  "\x01", "|"};
  std::string text;
  const int pieces = std::uniform_int_distribution<int>(0, 8)(random);
  for (int k = 0; k < pieces; ++k) text += kPieces[random() % kPieces.size()];
  return text;
}

}  // namespace

class AnchorsCsvTest : public QObject {
  Q_OBJECT

 private slots:
  void manyWaysToWriteTheSame_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("header") << QByteArray(
        "id,blueprint_x,blueprint_y,slam_x,slam_y,enabled,name,note\n"
        "1,2.5,-1.75,0.5,3,1,door,\n2,4,5,6,7,0,,\n7,-0.001,0,10000,2,1,,\n");
    QTest::newRow("no header") << QByteArray("1,2.5,-1.75,0.5,3,1,door\n2,4,5,6,7,0\n7,-0.001,0,10000,2\n");
    QTest::newRow("no last line end") << QByteArray("1,2.5,-1.75,0.5,3,yes,door\n2,4,5,6,7,no\n7,-1e-3,0,1e4,2");
    QTest::newRow("BOM, CRLF, capitals") << QByteArray(
        "\xef\xbb\xbfID,Blueprint_X,BLUEPRINT_Y,slam_x,slam_y,Enabled,Name\r\n"
        "1,2.5,-1.75,0.5,3,TRUE,door\r\n2,4,5,6,7,False,\r\n7,-0.001,0,10000,2,,\r\n");
    QTest::newRow("other order, unknown column") << QByteArray(
        "name;slam_x;slam_y;floor;id;blueprint_x;blueprint_y;enabled\n"
        "door;0.5;3;EG;1;2.5;-1.75;1\n;6;7;EG;2;4;5;0\n;10000;2;EG;7;-0.001;0;1\n");
    QTest::newRow("semicolons and decimal commas")
        << QByteArray("1;2,5;-1,75;0,5;3;1;door\n2;4;5;6;7;0\n7;-0,001;0,0;10000;2,000\n");
    QTest::newRow("tabs") << QByteArray("1\t2,5\t-1.75\t0.5\t3\t1\tdoor\n2\t4\t5\t6\t7\t0\n7\t-.001\t0\t1e4\t2\n");
    QTest::newRow("spaces and decimal commas")
        << QByteArray("  1 2,5  -1,75 0,5 3 1 door\n2 4 5 6 7 0\n7 -0,001 0 10000 2\n");
    QTest::newRow("comments and blank lines") << QByteArray(
        "# made by hand\n\n1, 2.5, -1.75, 0.5, 3, on, door\n\t\n  # more\n2, 4, 5, 6, 7, off # later\n"
        "7, -0.001, 0, 10000, +2 # far, away\n\n");
    QTest::newRow("quoted") << QByteArray(
        "\"id\",\"blueprint_x\",\"blueprint_y\",\"slam_x\",\"slam_y\",\"enabled\",\"name\"\n"
        "\"1\",\"2.5\",\"-1.75\",\"0.5\",\"3\",\"1\",\"door\"\n"
        "\"2\",\"4\",\"5\",\"6\",\"7\",\"0\",\n\"7\",\"-0.001\",\"0\",\"10000\",\"2\",,\n");
  }
  void manyWaysToWriteTheSame() {
    QFETCH(QByteArray, text);
    const Result<AnchorImport> import = parseAnchorsCsv(text.toStdString(), "a.csv");
    QVERIFY2(import, import ? "" : import.error().sentence().c_str());
    QVERIFY(import->rejected.empty());
    QVERIFY(import->anchors == kThree);
  }

  void whatIsWrittenIsRead() {
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
      AnchorList anchors;
      for (int k = 0; k < 20; ++k) {
        double numbers[4];
        for (double& number : numbers) {
          do {
            const std::uint64_t bits = (static_cast<std::uint64_t>(random()) << 32) | random();
            std::memcpy(&number, &bits, sizeof number);
          } while (!(std::abs(number) <= kLargestCoordinate));
        }
        anchors.push_back({static_cast<AnchorId>(random()) * 1000 + k,
                           {numbers[0], numbers[1]},
                           {numbers[2], numbers[3]},
                           random() % 2 == 0,
                           randomText(random),
                           randomText(random)});
      }
      const std::string text = formatAnchorsCsv(anchors);
      const Result<AnchorImport> import = parseAnchorsCsv(text, "a.csv");
      QVERIFY(import.has_value());
      QVERIFY(import->rejected.empty());
      QVERIFY(import->anchors == anchors);
      QCOMPARE(formatAnchorsCsv(import->anchors), text);
    }
  }

  void filesRoundTrip() {
    const test::TemporaryFolder folder;
    QVERIFY(writeAnchorsCsv(folder.path("a.csv"), kThree).has_value());
    QVERIFY(readAnchorsCsv(folder.path("a.csv"))->anchors == kThree);
    QVERIFY(readAnchors(folder.path("a.csv"))->anchors == kThree);
    QVERIFY(writeAnchorsCsv(folder.path("none.csv"), {}).has_value());
    QVERIFY(readAnchorsCsv(folder.path("none.csv"))->anchors.empty());  // a header alone is an empty list
  }

  void badLinesAreNamedAndTheOthersKept_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QString>("reason");
    QTest::newRow("too few") << QByteArray("9,1,2,3") << "has 4 of at least 5 fields";
    QTest::newRow("word") << QByteArray("9,1,two,3,4") << "blueprint_y 'two' is not a finite number";
    QTest::newRow("nan") << QByteArray("9,1,2,nan,4") << "slam_x 'nan' is not a finite number";
    QTest::newRow("infinite") << QByteArray("9,1,2,3,inf") << "slam_y 'inf' is not a finite number";
    QTest::newRow("too large") << QByteArray("9,1e999,2,3,4") << "blueprint_x '1e999' is not a finite number";
    QTest::newRow("far") << QByteArray("9,1,2,3,-1e308") << "slam_y '-1e308' is too large for a coordinate";
    QTest::newRow("empty") << QByteArray("9,1,,3,4") << "blueprint_y '' is not a finite number";
    QTest::newRow("fraction id") << QByteArray("9.5,1,2,3,4") << "the id '9.5' is not a whole number";
    QTest::newRow("negative id") << QByteArray("-100,1,2,3,4") << "the id '-100' is not from 0 to 9007199254740992";
    QTest::newRow("large id") << QByteArray("9223372036854775807,1,2,3,4")
                              << "the id '9223372036854775807' is not from 0 to 9007199254740992";
    QTest::newRow("same id") << QByteArray("1,1,2,3,4") << "the id 1 already stands in line 1";
    QTest::newRow("switch") << QByteArray("9,1,2,3,4,perhaps") << "enabled is 'perhaps', not 1 or 0";
    QTest::newRow("open quote") << QByteArray("9,1,2,3,4,1,\"door") << "has a quote that is never closed";
    QTest::newRow("zero byte") << QByteArray("9,1,2,3,\0", 9) << "slam_y '?' is not a finite number";
  }
  void badLinesAreNamedAndTheOthersKept() {
    QFETCH(QByteArray, line);
    QFETCH(QString, reason);
    const std::string text = "1,1,2,3,4\n\n" + line.toStdString() + "\n2,5,6,7,8\n";
    const Result<AnchorImport> import = parseAnchorsCsv(text, "a.csv");
    QVERIFY(import.has_value());
    QCOMPARE(import->anchors.size(), std::size_t{2});
    QCOMPARE(import->rejected.size(), std::size_t{1});
    QCOMPARE(import->rejected[0].line, std::size_t{3});
    QCOMPARE(QString::fromStdString(import->rejected[0].reason), reason);
  }

  void refusesWhatHoldsNoAnchors_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("empty") << QByteArray() << "a.csv: holds no anchors";
    QTest::newRow("comments") << QByteArray("# nothing\n\n") << "a.csv: holds no anchors";
    QTest::newRow("prose") << QByteArray("hello world")
                           << "a.csv:1: no line can be read as an anchor; the first one has 1 of at least 5 fields";
    QTest::newRow("missing column") << QByteArray("id,blueprint_x,slam_x,slam_y\n1,2,3,4\n")
                                    << "a.csv:1: the header has no column blueprint_y, which anchors need";
    QTest::newRow("column twice") << QByteArray("id,blueprint_x,blueprint_x,blueprint_y,slam_x,slam_y\n")
                                  << "a.csv:1: the column blueprint_x stands twice in the header";
    QTest::newRow("UTF-16") << QByteArray(
                                   "\xff\xfe"
                                   "1\0,\0",
                                   6)
                            << "a.csv: is UTF-16 text; save it as UTF-8";
  }
  void refusesWhatHoldsNoAnchors() {
    QFETCH(QByteArray, text);
    QFETCH(QString, sentence);
    const Result<AnchorImport> import = parseAnchorsCsv(text.toStdString(), "a.csv");
    QVERIFY(!import);
    QVERIFY(import.error().code == ErrorCode::kMalformed);
    QCOMPARE(QString::fromStdString(import.error().sentence()), sentence);
  }

  void cutAnywhereNothingIsInvented() {
    const std::string text = formatAnchorsCsv(kThree);
    for (std::size_t length = 0; length < text.size(); ++length) {
      const Result<AnchorImport> import = parseAnchorsCsv(std::string_view(text).substr(0, length), "a.csv");
      if (!import) continue;
      QVERIFY(import->anchors.size() <= kThree.size());
      for (std::size_t k = 0; k + 1 < import->anchors.size(); ++k) QVERIFY(import->anchors[k] == kThree[k]);
    }
  }

  void withoutIdsTheyAreCounted() {
    const Result<AnchorImport> import =
        parseAnchorsCsv("blueprint_x,blueprint_y,slam_x,slam_y\n1,2,3,4\nbad\n5,6,7,8\n", "a.csv");
    QCOMPARE(import->anchors.size(), std::size_t{2});
    QCOMPARE(import->anchors[1].id, AnchorId{2});
  }

  void latin1NamesBecomeUnicode() {
    const Result<AnchorImport> import = parseAnchorsCsv("1,2,3,4,5,1,T\xfcr\n", "a.csv");
    QCOMPARE(import->anchors[0].name, std::string("T\xc3\xbcr"));
  }

  void hopelessFilesEndSoon() {
    std::string text;
    for (int k = 0; k < 20000; ++k) text += "no anchor\n";
    const Result<AnchorImport> import = parseAnchorsCsv(text, "a.csv");
    QVERIFY(!import);
    QVERIFY(import.error().message.find("more than 10000 lines") != std::string::npos);
  }

  void missingFilesAndFolders() {
    const test::TemporaryFolder folder;
    QVERIFY(readAnchors(folder.path("none.csv")).error().code == ErrorCode::kNotFound);
    const Result<AnchorImport> qgis =
        readAnchors(folder.write("a.points", "mapX,mapY,sourceX,sourceY,enable\n1,2,3,-4,1\n"));
    QVERIFY(!qgis && qgis.error().message.find("QGIS") != std::string::npos);  // not taken for id, x, y, x, y
    QVERIFY(readAnchors(folder.path()).error().code == ErrorCode::kUnreadable);
    QVERIFY(writeAnchorsCsv(folder.path() / "no" / "a.csv", kThree).error().code == ErrorCode::kUnwritable);
  }
};

QTEST_APPLESS_MAIN(AnchorsCsvTest)
#include "anchors_csv_test.moc"

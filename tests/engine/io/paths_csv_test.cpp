// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/paths_csv.h"

#include <QtTest>

using namespace cad2slam;

class PathsCsvTest : public QObject {
  Q_OBJECT
 private slots:
  void reads_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("plain") << "1.5,2,-3,4e1\n0,0,1,1\n";
    QTest::newRow("header") << "start_x,start_y,goal_x,goal_y\n1.5,2,-3,4e1\n0,0,1,1\n";
    QTest::newRow("comments, blanks, CRLF, no end") << "# paths\r\n\r\n 1.5 , 2 ,-3, 4e1 \r\n0,0,1,1";
    QTest::newRow("byte order mark") << "\xef\xbb\xbfstart_x,start_y,goal_x,goal_y\n1.5,2,-3,40\n0,0,1,1\n";
  }
  void reads() {
    QFETCH(QString, text);
    const auto paths = parsePathsCsv(text.toStdString(), "p.csv");
    QVERIFY(paths);
    QCOMPARE(paths->size(), std::size_t{2});
    QCOMPARE((*paths)[0].start, Eigen::Vector2d(1.5, 2.0));
    QCOMPARE((*paths)[0].goal, Eigen::Vector2d(-3.0, 40.0));
  }

  void refuses_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("where");
    QTest::newRow("empty") << ""
                           << "p.csv";
    QTest::newRow("only a header") << "start_x,start_y,goal_x,goal_y\n"
                                   << "p.csv";
    QTest::newRow("three numbers") << "1,2,3,4\n1,2,3\n"
                                   << "p.csv:2";
    QTest::newRow("five numbers") << "1,2,3,4,5\n"
                                  << "p.csv:1";
    QTest::newRow("words") << "1,2,3,4\n\n1,2,three,4\n"
                           << "p.csv:3";
    QTest::newRow("infinite") << "1,2,inf,4\n"
                              << "p.csv:1";
    QTest::newRow("header twice") << "start_x,a,b,c\nstart_x,a,b,c\n1,2,3,4\n"
                                  << "p.csv:2";
  }
  void refuses() {
    QFETCH(QString, text);
    QFETCH(QString, where);
    const auto paths = parsePathsCsv(text.toStdString(), "p.csv");
    QVERIFY(!paths);
    QCOMPARE(QString::fromStdString(paths.error().where), where);
  }

  void missingFile() { QVERIFY(!readPathsCsv("/nowhere/paths.csv")); }
};

QTEST_APPLESS_MAIN(PathsCsvTest)
#include "paths_csv_test.moc"

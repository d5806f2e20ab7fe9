// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/line_chart.h"

#include <QXmlStreamReader>
#include <QtTest>

#include <cmath>
#include <limits>

using namespace cad2slam;

class LineChartTest : public QObject {
  Q_OBJECT
 private slots:
  void isWellFormedAndComplete() {
    const std::string svg = drawLineChart({{"one & only", "#123456", {{4, 1.0}, {8, 0.5}, {16, 0.3}}, true},
                                           {"other", "#abcdef", {{4, 2.0}, {8, 1.5}}, false}},
                                          "anchors", "error < 1");
    QXmlStreamReader xml(QString::fromStdString(svg));
    int circles = 0;
    int paths = 0;
    while (!xml.atEnd()) {
      if (xml.readNext() != QXmlStreamReader::StartElement) continue;
      circles += xml.name() == u"circle" ? 1 : 0;
      paths += xml.name() == u"path" ? 1 : 0;
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QCOMPARE(circles, 5);
    QCOMPARE(paths, 2);
    QVERIFY(QString::fromStdString(svg).contains("one &amp; only"));
  }

  void lessIsLower() {
    const QString svg = QString::fromStdString(drawLineChart({{"a", "red", {{1, 10.0}, {10, 0.1}}, false}}, "x", "y"));
    QList<double> heights;
    QXmlStreamReader xml(svg);
    while (!xml.atEnd()) {
      if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"circle") {
        heights.push_back(xml.attributes().value("cy").toDouble());
      }
    }
    QCOMPARE(heights.size(), 2);
    QVERIFY(heights[0] < heights[1]);  // rows of a picture grow down
  }

  void pointsThatCannotBeDrawnAreLeftOut() {
    const double infinity = std::numeric_limits<double>::infinity();
    const QString svg = QString::fromStdString(
        drawLineChart({{"a", "red", {{4, infinity}, {8, 0.0}, {16, std::nan("")}, {30, 0.5}}, false}}, "x", "y"));
    QCOMPARE(svg.count("<circle"), 1);
    QVERIFY(!svg.contains("nan") && !svg.contains("inf"));
  }

  void nothingToShow() { QVERIFY(QString::fromStdString(drawLineChart({}, "x", "y")).contains("nothing to show")); }
};

QTEST_APPLESS_MAIN(LineChartTest)
#include "line_chart_test.moc"

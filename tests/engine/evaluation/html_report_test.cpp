// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/html_report.h"

#include <opencv2/imgcodecs.hpp>

#include <QXmlStreamReader>
#include <QtTest>

using namespace cad2slam;

class HtmlReportTest : public QObject {
  Q_OBJECT
 private slots:
  void base64() {
    const auto encode = [](const char* text) {
      const QByteArray bytes(text);
      return encodeBase64({bytes.begin(), bytes.end()});
    };
    for (const char* text : {"", "f", "fo", "foo", "foob", "fooba", "foobar"}) {
      QCOMPARE(QByteArray::fromStdString(encode(text)), QByteArray(text).toBase64());
    }
  }

  void hostileTextStaysText() {
    HtmlReport report("<script>alert(1)</script>", "a & b");
    report.addHeading("\"quoted\"");
    report.addParagraph("<img src=x>");
    report.addTable({"<b>"}, {{"</td>"}});
    const QString page = QString::fromStdString(report.page());
    QVERIFY(!page.contains("<script"));
    QVERIFY(!page.contains("<img"));
    QVERIFY(page.contains("a &amp; b"));
    QVERIFY(page.contains("<td>&lt;/td&gt;</td>"));
  }

  void needsNoOtherFile() {
    HtmlReport report("t", "s");
    QVERIFY(report.addPicture(cv::Mat(4, 5, CV_8UC3, cv::Scalar(1, 2, 3)), "caption"));
    report.addSvg("<svg></svg>", "chart");
    const QString page = QString::fromStdString(report.page());
    QVERIFY(!page.contains("http://") && !page.contains("https://") && !page.contains("<link"));
    QVERIFY(page.contains("name=\"viewport\""));
    QVERIFY(page.contains("@media print"));
  }

  void picturesReadBack() {
    HtmlReport report("t", "s");
    cv::Mat picture(7, 9, CV_8UC3, cv::Scalar(10, 200, 30));
    picture.at<cv::Vec3b>(3, 4) = {255, 0, 1};
    QVERIFY(report.addPicture(picture, "p"));
    const QByteArray page = QByteArray::fromStdString(report.page());
    const qsizetype from = page.indexOf("base64,") + 7;
    const QByteArray png = QByteArray::fromBase64(page.mid(from, page.indexOf('"', from) - from));
    const cv::Mat read = cv::imdecode(std::vector<unsigned char>(png.begin(), png.end()), cv::IMREAD_UNCHANGED);
    QCOMPARE(read.size(), picture.size());
    QCOMPARE(cv::norm(read, picture, cv::NORM_INF), 0.0);
    QVERIFY(!report.addPicture(cv::Mat(), "empty"));
  }

  void bestOfEachColumnAndGroupIsBold() {
    HtmlReport report("t", "s");
    report.addTable({"method", "n", "mean"},
                    {{"a", "4", "0.5"}, {"b", "4", "0.25"}, {"a", "8", "0.125"}, {"b", "8", "-"}}, true, 1);
    const QString page = QString::fromStdString(report.page());
    QVERIFY(page.contains("<b>0.25</b>"));
    QVERIFY(page.contains("<b>0.125</b>"));
    QVERIFY(!page.contains("<b>0.5</b>") && !page.contains("<b>4</b>") && !page.contains("<b>-</b>"));
  }

  void bodyIsWellFormed() {
    HtmlReport report("t", "s");
    report.addHeading("h");
    report.addTable({"a", "b"}, {{"1", "2"}, {"3", "4"}}, true);
    report.addParagraph("p");
    report.addSvg("<svg><path d=\"M0 0\"/></svg>", "c");
    QString page = QString::fromStdString(report.page());
    page = page.mid(page.indexOf("<body>"));
    page = page.left(page.indexOf("</body>") + 7);
    QXmlStreamReader xml(page);
    while (!xml.atEnd()) xml.readNext();
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
  }
};

QTEST_APPLESS_MAIN(HtmlReportTest)
#include "html_report_test.moc"

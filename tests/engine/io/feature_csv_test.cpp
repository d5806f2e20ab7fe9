// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/feature_csv.h"

#include <QtTest>

#include "support/damaged_text.h"

namespace cad2slam {
namespace {

using test::damaged;

const std::string kCsv =
    "feature,kind,part,x,y,theta,name\n1,point,1,1.5,-2,0.25,\"a, b\"\n2,path,1,0,0,,way\n2,path,1,1,1,,way\n"
    "3,polygon,1,0,0,,zone\n3,polygon,1,4,0,,zone\n3,polygon,1,4,4,,zone\n";

}  // namespace

class FeatureCsvTest : public QObject {
  Q_OBJECT
 private slots:
  void csvComesBack();
  void awkwardNamesComeBack();
  void separatorsAndMissingColumns();
  void damagedTexts();
};

void FeatureCsvTest::csvComesBack() {
  const Result<FeatureList> features = parseFeatureCsv(kCsv, "x");
  QVERIFY(features.has_value());
  QCOMPARE(formatFeatureCsv(*features), kCsv);
  QVERIFY(!parseFeatureCsv("", "x").has_value());
  QVERIFY(!parseFeatureCsv("a,b\n1,2\n", "x").has_value());
  QVERIFY(!parseFeatureCsv("x,y\n1,nan\n", "x").has_value());
  QVERIFY(!parseFeatureCsv("feature,kind,x,y\n1,path,1,1\n", "x").has_value());
  QVERIFY(!parseFeatureCsv("feature,x,y\n1,1,1\n2,1,1\n1,1,1\n", "x").has_value());
}

void FeatureCsvTest::awkwardNamesComeBack() {
  for (const char* name : {"a, b", "a \"b\"", "two\nlines", " blank ", "# no comment", "\xc3\xa4"}) {
    Feature feature;
    feature.parts = {{{1.0, 2.0}}};
    feature.name = name;
    const Result<FeatureList> again = parseFeatureCsv(formatFeatureCsv({feature}), "x");
    QVERIFY(again);
    QCOMPARE(QString::fromStdString(again->at(0).name), QString(name));
  }
}

void FeatureCsvTest::separatorsAndMissingColumns() {
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  for (const std::string& text :
       {std::string("y;x;theta\n2;1;0.5\n4;3;\n"), std::string("x\ty\ttheta\n1\t2\t0.5\n3\t4\t\n"),
        byte_order_mark + "X,Y,Theta\r\n1,2,0.5\r\n3,4,\r\n"}) {
    const Result<FeatureList> features = parseFeatureCsv(text, "x");
    QVERIFY(features);
    QCOMPARE(features->size(), std::size_t{2});
    QCOMPARE(features->at(0).parts[0][0], Eigen::Vector2d(1.0, 2.0));
    QCOMPARE(*features->at(0).heading, 0.5);
    QVERIFY(!features->at(1).heading);
  }
}

void FeatureCsvTest::damagedTexts() {
  std::mt19937 random(11);
  int accepted = 0;
  for (int k = 0; k < 10000; ++k) {
    const Result<FeatureList> features = parseFeatureCsv(damaged(kCsv, random), "x");
    if (!features) {
      QVERIFY(!features.error().message.empty());
      continue;
    }
    ++accepted;
    for (const Feature& feature : *features) {
      for (const PointList& part : feature.parts) {
        QVERIFY(!part.empty());
        for (const Eigen::Vector2d& place : part) QVERIFY(place.allFinite());
      }
    }
    const std::string written = formatFeatureCsv(*features);
    const Result<FeatureList> again = parseFeatureCsv(written, "x");
    QVERIFY2(again.has_value(), written.c_str());
    QVERIFY2(formatFeatureCsv(*again) == written, written.c_str());
  }
  QVERIFY(accepted > 50);
}

}  // namespace cad2slam

QTEST_APPLESS_MAIN(cad2slam::FeatureCsvTest)
#include "feature_csv_test.moc"

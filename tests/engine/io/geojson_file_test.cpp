// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/geojson_file.h"

#include <QtTest>

#include "support/damaged_text.h"

namespace cad2slam {
namespace {

using test::damaged;

const std::string kGeoJson = R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "id": 3, "geometry": {"type": "Point", "coordinates": [1.5, -2, 9]}, "properties": {"yaw": 1}},
{"type": "Feature", "geometry": {"type": "MultiLineString", "coordinates": [[[0, 0], [1, 1]], [[2, 2], [3, 3e1]]]}},
{"type": "Feature", "geometry": {"type": "MultiPolygon", "coordinates": [[[[0, 0], [4, 0], [4, 4], [0, 0]],
[[1, 0.5], [2, 0.5], [2, 1], [1, 0.5]]], [[[7, 7], [8, 7], [8, 8], [7, 7]]]]}, "properties": {"name": "a, b"}}]})";

}  // namespace

class GeoJsonFileTest : public QObject {
  Q_OBJECT
 private slots:
  void geoJsonComesBack();
  void allGeometriesAreKept_data();
  void allGeometriesAreKept();
  void headingsStayUnderTheirKey();
  void wrongTextsAreRefused_data();
  void wrongTextsAreRefused();
  void damagedTexts();
};

void GeoJsonFileTest::geoJsonComesBack() {
  const Result<FeatureList> features = parseGeoJson(kGeoJson, "x");
  QVERIFY(features.has_value());
  QCOMPARE(features->size(), std::size_t{3});
  QCOMPARE(*(*features)[0].heading, 1.0);
  QCOMPARE((*features)[2].parts.size(), std::size_t{3});
  QCOMPARE((*features)[2].parts[0].size(), std::size_t{3});
  QCOMPARE(QString::fromStdString((*features)[2].name), QString("a, b"));
  const std::string text = *formatGeoJson(*features, "map");
  const Result<FeatureList> again = parseGeoJson(text, "x");
  QVERIFY(again.has_value());
  QCOMPARE(*formatGeoJson(*again, "map"), text);
}

void GeoJsonFileTest::damagedTexts() {
  std::mt19937 random(11);
  int accepted = 0;
  for (int k = 0; k < 10000; ++k) {
    const Result<FeatureList> features = parseGeoJson(damaged(kGeoJson, random), "x");
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
    const Result<std::string> written = formatGeoJson(*features, "map");
    QVERIFY(written.has_value());
    const Result<FeatureList> again = parseGeoJson(*written, "x");
    QVERIFY(again.has_value());
    QVERIFY2(*formatGeoJson(*again, "map") == *written, written->c_str());
  }
  QVERIFY(accepted > 50);
}

void GeoJsonFileTest::allGeometriesAreKept_data() {
  QTest::addColumn<QByteArray>("geometry");
  QTest::addColumn<int>("parts");
  QTest::newRow("point") << QByteArray(R"({"coordinates":[1.5,-2.0],"type":"Point"})") << 1;
  QTest::newRow("points") << QByteArray(R"({"coordinates":[[1.0,2.0],[3.0,4.0]],"type":"MultiPoint"})") << 2;
  QTest::newRow("path") << QByteArray(R"({"coordinates":[[1.0,2.0],[3.0,4.0]],"type":"LineString"})") << 1;
  QTest::newRow("paths")
      << QByteArray(R"({"coordinates":[[[1.0,2.0],[3.0,4.0]],[[5.0,6.0],[7.0,8.0]]],"type":"MultiLineString"})") << 2;
  const QByteArray ring = "[[0.0,0.0],[4.0,0.0],[4.0,4.0],[0.0,0.0]]";
  const QByteArray hole = "[[1.0,0.5],[2.0,0.5],[2.0,1.0],[1.0,0.5]]";
  QTest::newRow("polygon with a hole") << R"({"coordinates":[)" + ring + "," + hole + R"(],"type":"Polygon"})" << 2;
  QTest::newRow("polygons") << R"({"coordinates":[[)" + ring + "," + hole + "],[" + ring +
                                   R"(]],"type":"MultiPolygon"})"
                            << 3;
}

void GeoJsonFileTest::allGeometriesAreKept() {
  QFETCH(QByteArray, geometry);
  QFETCH(int, parts);
  const Result<FeatureList> features = parseGeoJson(geometry.toStdString(), "x");  // a geometry alone is a feature
  QVERIFY(features);
  QCOMPARE(features->front().parts.size(), static_cast<std::size_t>(parts));
  const std::string written = *formatGeoJson(*features, "map");
  QVERIFY2(QByteArray::fromStdString(written).contains(geometry), written.c_str());
}

void GeoJsonFileTest::headingsStayUnderTheirKey() {
  for (const char* key : {"heading_rad", "theta", "yaw"}) {
    const std::string text = std::string(R"({"type":"Feature","geometry":{"type":"Point","coordinates":[1,2]},)") +
                             R"("properties":{")" + key + R"(":0.25,"floor":3}})";
    FeatureList features = *parseGeoJson(text, "x");
    QCOMPARE(*features[0].heading, 0.25);
    features[0].heading = 0.75;
    const std::string written = *formatGeoJson(features, "slam_1");
    QVERIFY(written.find(std::string("\"") + key + "\":0.75") != std::string::npos);
    QVERIFY(written.find(R"("floor":3)") != std::string::npos && written.find("slam_1") != std::string::npos);
  }
}

void GeoJsonFileTest::wrongTextsAreRefused_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::newRow("empty") << QByteArray();
  QTest::newRow("a list") << QByteArray("[]");
  QTest::newRow("unknown geometry") << QByteArray(R"({"type":"Circle","coordinates":[0,0]})");
  QTest::newRow("one number") << QByteArray(R"({"type":"Point","coordinates":[0]})");
  QTest::newRow("a word") << QByteArray(R"({"type":"Point","coordinates":["a",0]})");
  QTest::newRow("beyond all numbers") << QByteArray(R"({"type":"Point","coordinates":[1e999,0]})");
  QTest::newRow("path of one") << QByteArray(R"({"type":"LineString","coordinates":[[0,0]]})");
  QTest::newRow("ring without area") << QByteArray(R"({"type":"Polygon","coordinates":[[[0,0],[1,1],[0,0]]]})");
  QTest::newRow("no ring") << QByteArray(R"({"type":"Polygon","coordinates":[]})");
  QTest::newRow("nothing of many") << QByteArray(R"({"type":"MultiPoint","coordinates":[]})");
  QTest::newRow("a number of features") << QByteArray(R"({"type":"FeatureCollection","features":3})");
  QTest::newRow("no geometry") << QByteArray(R"({"type":"Feature","properties":{}})");
  QTest::newRow("cut off") << QByteArray::fromStdString(kGeoJson).left(200);
  QTest::newRow("very deep") << QByteArray(100'000, '[');
}

void GeoJsonFileTest::wrongTextsAreRefused() {
  QFETCH(QByteArray, text);
  const Result<FeatureList> features = parseGeoJson(text.toStdString(), "zones.geojson");
  QVERIFY(!features);
  QVERIFY(QString::fromStdString(features.error().sentence()).contains("zones.geojson"));
}

}  // namespace cad2slam

QTEST_APPLESS_MAIN(cad2slam::GeoJsonFileTest)
#include "geojson_file_test.moc"

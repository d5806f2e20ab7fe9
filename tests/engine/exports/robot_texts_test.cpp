// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0

// The readers behind the exports, fed with damaged texts: an error or a value, never a crash, and what is read is
// written and read again as the same.
#include <QtTest>

#include <random>

#include "cad2slam/io/feature_csv.h"
#include "cad2slam/io/geojson_file.h"
#include "cad2slam/io/pose_protocol.h"
#include "cad2slam/io/rmf_building.h"

namespace cad2slam {
namespace {

const std::string kGeoJson = R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "id": 3, "geometry": {"type": "Point", "coordinates": [1.5, -2, 9]}, "properties": {"yaw": 1}},
{"type": "Feature", "geometry": {"type": "MultiLineString", "coordinates": [[[0, 0], [1, 1]], [[2, 2], [3, 3e1]]]}},
{"type": "Feature", "geometry": {"type": "MultiPolygon", "coordinates": [[[[0, 0], [4, 0], [4, 4], [0, 0]],
[[1, 0.5], [2, 0.5], [2, 1], [1, 0.5]]], [[[7, 7], [8, 7], [8, 8], [7, 7]]]]}, "properties": {"name": "a, b"}}]})";

const std::string kCsv =
    "feature,kind,part,x,y,theta,name\n1,point,1,1.5,-2,0.25,\"a, b\"\n2,path,1,0,0,,way\n2,path,1,1,1,,way\n"
    "3,polygon,1,0,0,,zone\n3,polygon,1,4,0,,zone\n3,polygon,1,4,4,,zone\n";

const std::string kBuilding =
    "levels:\n  L1:\n    drawing: {filename: a.png}\n    features:\n      - {id: a, name: n, x: 1, y: 2}\n"
    "    layers:\n      scan:\n        filename: b.png\n        features:\n          - {id: b, name: m, x: 3, y: 4.5}\n"
    "    constraints:\n      - {ids: [a, b]}\n    vertices: [[1, 2, 0, dock], [3, 4, 0, \"\"]]\n    lanes: [[0, 1, "
    "{}]]\n";

const std::string kRequest = R"({"id": 7, "op": "project", "poses": [[1, 2.5, -0.5], [3e1, 4]], "outside": "rigid"})";

std::string damaged(const std::string& text, std::mt19937& random) {
  std::string copy = text;
  for (unsigned k = 0; k < 1 + random() % 4; ++k) {
    const std::size_t place = random() % copy.size();
    switch (random() % 4) {
      case 0:
        copy[place] = static_cast<char>(random());
        break;
      case 1:
        copy[place] = "{}[]\",:-0eE.\n &*"[random() % 16];
        break;
      case 2:
        copy.erase(place, random() % 20);
        break;
      default:
        copy.insert(place, copy.substr(random() % copy.size(), random() % 20));
    }
    if (copy.empty()) copy = " ";
  }
  return random() % 4 == 0 ? copy.substr(0, random() % copy.size()) : copy;
}

}  // namespace

class RobotTextsTest : public QObject {
  Q_OBJECT
 private slots:
  void geoJsonComesBack();
  void csvComesBack();
  void damagedFeatures();
  void damagedBuildings();
  void damagedRequests();
};

void RobotTextsTest::geoJsonComesBack() {
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

void RobotTextsTest::csvComesBack() {
  const Result<FeatureList> features = parseFeatureCsv(kCsv, "x");
  QVERIFY(features.has_value());
  QCOMPARE(formatFeatureCsv(*features), kCsv);
  QVERIFY(!parseFeatureCsv("", "x").has_value());
  QVERIFY(!parseFeatureCsv("a,b\n1,2\n", "x").has_value());
  QVERIFY(!parseFeatureCsv("x,y\n1,nan\n", "x").has_value());
  QVERIFY(!parseFeatureCsv("feature,kind,x,y\n1,path,1,1\n", "x").has_value());
  QVERIFY(!parseFeatureCsv("feature,x,y\n1,1,1\n2,1,1\n1,1,1\n", "x").has_value());
}

void RobotTextsTest::damagedFeatures() {
  std::mt19937 random(11);
  int accepted = 0;
  for (int k = 0; k < 20000; ++k) {
    const bool csv = k % 2 == 0;
    const std::string text = damaged(csv ? kCsv : kGeoJson, random);
    const Result<FeatureList> features = csv ? parseFeatureCsv(text, "x") : parseGeoJson(text, "x");
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
    QVERIFY2(formatFeatureCsv(*again) == formatFeatureCsv(*features), written->c_str());
  }
  QVERIFY(accepted > 100);
}

void RobotTextsTest::damagedBuildings() {
  QVERIFY(parseRmfBuilding(kBuilding, "x").has_value());
  const MapFrame frame = *MapFrame::create(0.1, 10, 10, {});
  std::mt19937 random(12);
  for (int k = 0; k < 5000; ++k) {
    const Result<RmfBuilding> building = parseRmfBuilding(damaged(kBuilding, random), "x");
    if (!building) {
      QVERIFY(!building.error().message.empty());
      continue;
    }
    const Result<RmfLevel> level = findLevel(*building, "");
    if (!level) continue;
    (void)lanesOf(*level, frame);
    const Result<AnchorList> anchors = anchorsOf(*level, "", frame, frame);
    if (!anchors) continue;
    for (const Anchor& anchor : *anchors) QVERIFY(frame.contains(anchor.in_blueprint + Eigen::Vector2d(1e-9, -1e-9)));
  }
}

void RobotTextsTest::damagedRequests() {
  std::string id;
  const Result<PoseRequest> good = parsePoseRequest(kRequest, id);
  QVERIFY(good.has_value() && good->poses.size() == 2 && id == "7" && good->outside == OutsidePolicy::kRigid);
  std::mt19937 random(13);
  for (int k = 0; k < 20000; ++k) {
    const Result<PoseRequest> request = parsePoseRequest(damaged(kRequest, random), id);
    if (!request) {
      std::string answer;
      appendError(id, request.error(), answer);
      QVERIFY(answer.front() == '{' && answer.back() == '\n');
      QCOMPARE(std::count(answer.begin(), answer.end(), '\n'), 1);
      continue;
    }
    for (const Pose2& pose : request->poses) QVERIFY(pose.isFinite());
  }
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::RobotTextsTest)
#include "robot_texts_test.moc"

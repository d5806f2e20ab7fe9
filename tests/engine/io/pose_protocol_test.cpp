// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/pose_protocol.h"

#include <QtTest>

#include "support/damaged_text.h"

namespace cad2slam {
namespace {

using test::damaged;

const std::string kRequest = R"({"id": 7, "op": "project", "poses": [[1, 2.5, -0.5], [3e1, 4]], "outside": "rigid"})";

}  // namespace

class PoseProtocolTest : public QObject {
  Q_OBJECT
 private slots:
  void answersAreOneLine();
  void idsAreRepeatedAsSent();
  void damagedRequests();
};

void PoseProtocolTest::answersAreOneLine() {
  std::string id;
  const PoseRequest batch = *parsePoseRequest(kRequest, id);
  const Projection answers[] = {{{{1.0, 2.5}, -0.5}, ProjectionStatus::kInside}, {{}, ProjectionStatus::kOutside}};
  std::string out = "kept\n";
  appendAnswer(batch, answers, out);
  QCOMPARE(QString::fromStdString(out),
           QString("kept\n{\"id\":7,\"poses\":[[1,2.5,-0.5],null],\"status\":[\"inside\",\"outside\"]}\n"));
  const PoseRequest single = *parsePoseRequest(R"({"op": "unproject", "pose": [1, 2], "id": "a\"b"})", id);
  QVERIFY(single.single && single.kind == PoseRequest::Kind::kUnproject && !single.outside);
  out.clear();
  appendAnswer(single, answers + 1, out);
  QCOMPARE(QString::fromStdString(out), QString("{\"id\":\"a\\\"b\",\"pose\":null,\"status\":\"outside\"}\n"));
  out.clear();
  appendError("", {ErrorCode::kMalformed, "two\nlines \"of\" text", {}}, out);
  QCOMPARE(QString::fromStdString(out),
           QString("{\"error\":{\"code\":\"malformed\",\"message\":\"two\\nlines \\\"of\\\" text\"}}\n"));
}

void PoseProtocolTest::idsAreRepeatedAsSent() {
  for (const char* sent : {"7", "-7", "18446744073709551615", "1e3", "1.50", "-0.0", "123456789012345678901234567890",
                           "null", "\"\"", "\"a b\""}) {
    std::string id;
    const auto request = parsePoseRequest(std::string(R"({"op":"info","id":)") + sent + "}", id);
    QVERIFY2(request, sent);
    QCOMPARE(QString::fromStdString(id), QString(sent));
  }
}

void PoseProtocolTest::damagedRequests() {
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

QTEST_APPLESS_MAIN(cad2slam::PoseProtocolTest)
#include "pose_protocol_test.moc"

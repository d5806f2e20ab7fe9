// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/solve_service.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include <opencv2/core.hpp>

using namespace cad2slam;

namespace {

constexpr int kPatience = 60'000;

std::shared_ptr<const OccupancyGrid> freeHall(int width, int height) {
  const MapFrame frame = *MapFrame::create(0.1, width, height, Pose2{});
  return std::make_shared<const OccupancyGrid>(frame, cv::Mat(height, width, CV_8UC1, cv::Scalar(0)));
}

SolveRequest requestOf(const std::shared_ptr<const OccupancyGrid>& hall, std::uint64_t revision, double bend = 0.0) {
  SolveRequest request;
  request.revision = revision;
  request.map = "robot";
  request.blueprint = hall;
  request.settings = defaultSettings(Model::kStretch);
  const double width = hall->frame().width() * 0.1;
  const double height = hall->frame().height() * 0.1;
  AnchorId id = 0;
  for (const double x : {0.1, 0.5, 0.9})
    for (const double y : {0.1, 0.9})
      request.anchors.push_back(Anchor{++id, {x * width, y * height}, {x * width + 1.0, y * height + bend * x}});
  return request;
}

}  // namespace

class SolveServiceTest : public QObject {
  Q_OBJECT

 private slots:
  void aResultCarriesItsRequest() {
    SolveService service;
    QSignalSpy solved(&service, &SolveService::solved);
    const auto hall = freeHall(200, 100);
    service.request(requestOf(hall, 7));
    QVERIFY(solved.wait(kPatience));
    const auto result = solved.at(0).at(0).value<SolveResultPtr>();
    QCOMPARE(result->revision, std::uint64_t(7));
    QCOMPARE(result->map, std::string("robot"));
    QCOMPARE(result->solution.anchors_used, std::size_t(6));
    const Projection there = result->projector.slamFromBlueprint({{10.0, 5.0}, 0.0});
    QVERIFY(there.ok());
    QVERIFY((there.pose.translation - Eigen::Vector2d(11.0, 5.0)).norm() < 0.01);
    QVERIFY(!service.isBusy());
  }

  void theNewestOfManyRequestsWins() {
    SolveService service;
    QSignalSpy solved(&service, &SolveService::solved);
    QSignalSpy idle(&service, &SolveService::idle);
    const auto hall = freeHall(600, 400);
    for (std::uint64_t revision = 1; revision <= 20; ++revision)
      service.request(requestOf(hall, revision, 0.01 * double(revision)));
    QTRY_VERIFY_WITH_TIMEOUT(!service.isBusy() && !idle.isEmpty(), kPatience);
    QVERIFY(solved.size() >= 1 && solved.size() < 20);
    QCOMPARE(solved.last().at(0).value<SolveResultPtr>()->revision, std::uint64_t(20));
    std::uint64_t last = 0;
    for (const QList<QVariant>& call : solved) {
      QVERIFY(call.at(0).value<SolveResultPtr>()->revision > last);
      last = call.at(0).value<SolveResultPtr>()->revision;
    }
  }

  void aDragIsNeverStarved() {
    SolveService service;
    QSignalSpy solved(&service, &SolveService::solved);
    const auto hall = freeHall(300, 200);
    QElapsedTimer since;
    since.start();
    std::uint64_t revision = 0;
    while (solved.size() < 5 && since.elapsed() < kPatience) {
      ++revision;
      SolveRequest request = requestOf(hall, revision, 0.001 * double(revision));
      request.quality = Quality::kPreview;
      service.request(std::move(request));
      QTest::qWait(5);
    }
    QVERIFY(solved.size() >= 5);
  }

  void aSlowAnswerIsPrecededByARoughOne() {
    SolveService service;
    QSignalSpy solved(&service, &SolveService::solved);
    QSignalSpy idle(&service, &SolveService::idle);
    SolveRequest request = requestOf(freeHall(600, 400), 1, 0.5);
    request.preview_first = true;
    service.request(request);
    QTRY_VERIFY_WITH_TIMEOUT(!idle.isEmpty(), kPatience);
    QCOMPARE(solved.size(), 2);
    const auto rough = solved.at(0).at(0).value<SolveResultPtr>();
    const auto full = solved.at(1).at(0).value<SolveResultPtr>();
    QVERIFY(rough->quality == Quality::kPreview && full->quality == Quality::kFull);
    QVERIFY(rough->revision == 1 && full->revision == 1);
    QVERIFY(rough->mesh->nodeCount() < full->mesh->nodeCount());

    request.revision = 2;  // whatever comes in between, the newest is the last
    service.request(request);
    request.revision = 3;
    service.request(request);
    idle.clear();
    QTRY_VERIFY_WITH_TIMEOUT(!idle.isEmpty(), kPatience);
    const auto last = solved.last().at(0).value<SolveResultPtr>();
    QVERIFY(last->revision == 3 && last->quality == Quality::kFull);
  }

  void whatFailsIsToldOnce() {
    SolveService service;
    QSignalSpy failed(&service, &SolveService::failed);
    QSignalSpy idle(&service, &SolveService::idle);
    SolveRequest request = requestOf(freeHall(200, 100), 3);
    request.anchors[1].in_slam.x() = std::nan("");
    request.preview_first = true;
    service.request(std::move(request));
    QTRY_VERIFY_WITH_TIMEOUT(!idle.isEmpty(), kPatience);
    QCOMPARE(failed.size(), 1);
  }

  void cancelLeavesSilence() {
    SolveService service;
    QSignalSpy solved(&service, &SolveService::solved);
    QSignalSpy idle(&service, &SolveService::idle);
    service.request(requestOf(freeHall(800, 600), 1));
    service.cancel();
    QTRY_VERIFY_WITH_TIMEOUT(!idle.isEmpty(), kPatience);
    QVERIFY(solved.isEmpty());
  }

  void failureIsASentenceWithItsRevision() {
    SolveService service;
    QSignalSpy failed(&service, &SolveService::failed);
    SolveRequest request = requestOf(freeHall(200, 100), 3);
    request.anchors[1].in_slam.x() = std::nan("");
    service.request(std::move(request));
    QVERIFY(failed.wait(kPatience));
    const auto failure = failed.at(0).at(0).value<SolveFailure>();
    QCOMPARE(failure.revision, std::uint64_t(3));
    QVERIFY(!failure.error.message.empty());
  }

  void sigmaComesAfterTheSolve() {
    SolveService service;
    QSignalSpy known(&service, &SolveService::sigmaKnown);
    service.request(requestOf(freeHall(200, 100), 1, 0.3));
    service.requestSigma("robot", {10.0, 5.0});
    service.requestSigma("nobody", {10.0, 5.0});
    QTRY_COMPARE_WITH_TIMEOUT(known.size(), 2, kPatience);
    QVERIFY(known.at(0).at(1).toDouble() >= 0.0);
    QVERIFY(std::isnan(known.at(1).at(1).toDouble()));
  }

  void othersAreSolvedAsideAfterWhatIsAsked() {
    SolveService service;
    QStringList order;
    connect(&service, &SolveService::solved, this,
            [&](const SolveResultPtr& result) { order += QString::fromStdString(result->map); });
    connect(&service, &SolveService::solvedAside, this,
            [&](const SolveResultPtr& result) { order += QString::fromStdString("aside " + result->map); });
    const auto hall = freeHall(400, 300);
    const auto named = [&](const char* map, std::uint64_t revision) {
      SolveRequest request = requestOf(hall, revision, 0.1);
      request.map = map;
      return request;
    };
    service.requestAside(named("a", 1));  // runs, is stopped and begins again
    service.requestAside(named("b", 1));
    service.requestAside(named("b", 2));  // instead of the one before
    service.request(named("robot", 3));
    QTRY_VERIFY_WITH_TIMEOUT(!service.isBusy(), kPatience);
    QCOMPARE(order, QStringList({"robot", "aside a", "aside b"}));
  }

  void whatIsSolvedAsideEqualsWhatIsSolved() {
    SolveService service;
    QSignalSpy solved(&service, &SolveService::solved);
    QSignalSpy aside(&service, &SolveService::solvedAside);
    const auto hall = freeHall(300, 200);
    service.request(requestOf(hall, 1, 0.3));
    SolveRequest other = requestOf(hall, 1, 0.3);
    other.map = "other";
    service.requestAside(std::move(other));
    QTRY_VERIFY_WITH_TIMEOUT(solved.size() == 1 && aside.size() == 1, kPatience);
    const auto a = solved.at(0).at(0).value<SolveResultPtr>();
    const auto b = aside.at(0).at(0).value<SolveResultPtr>();
    QVERIFY(a->mesh == b->mesh);  // built once
    for (std::size_t i = 0; i < a->solution.node_slam.size(); ++i)
      QCOMPARE(a->solution.node_slam[i].translation, b->solution.node_slam[i].translation);
  }

  void aDragIsNotStarvedByWhatIsSolvedAside() {
    SolveService service;
    QSignalSpy aside(&service, &SolveService::solvedAside);
    QSignalSpy solved(&service, &SolveService::solved);
    SolveRequest other = requestOf(freeHall(800, 600), 1, 0.1);
    other.map = "other";
    service.requestAside(std::move(other));
    const auto hall = freeHall(300, 200);
    for (std::uint64_t revision = 1; revision <= 10; ++revision) {
      SolveRequest request = requestOf(hall, revision, 0.001 * double(revision));
      request.quality = Quality::kPreview;
      service.request(std::move(request));
      QTRY_VERIFY_WITH_TIMEOUT(solved.size() == int(revision), kPatience);
    }
    QTRY_COMPARE_WITH_TIMEOUT(aside.size(), 1, kPatience);
    service.cancelAside();
    QVERIFY(!service.isBusy());
  }

  void cancelAsideLeavesSilence() {
    SolveService service;
    QSignalSpy aside(&service, &SolveService::solvedAside);
    QSignalSpy solved(&service, &SolveService::solved);
    const auto hall = freeHall(600, 400);
    service.requestAside(requestOf(hall, 1));
    SolveRequest other = requestOf(hall, 1);
    other.map = "other";
    service.requestAside(std::move(other));
    service.cancelAside();
    service.request(requestOf(hall, 2));
    QTRY_VERIFY_WITH_TIMEOUT(!service.isBusy(), kPatience);
    QCOMPARE(solved.size(), 1);
    QVERIFY(aside.isEmpty());
  }

  void endsWhileWorking() {
    for (int i = 0; i < 5; ++i) {
      SolveService service;
      service.request(requestOf(freeHall(800, 600), 1));
      QTest::qWait(i * 7);
    }
  }
};

QTEST_GUILESS_MAIN(SolveServiceTest)
#include "solve_service_test.moc"

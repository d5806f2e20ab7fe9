// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/c_api/cad2slam.h"

#include <QtTest>

#include <random>
#include <thread>

#include "cad2slam/io/projector_file.h"
#include "cad2slam/projection/make_projector.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/solver/mesh_solver.h"
#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

Eigen::Vector2d bend(const Eigen::Vector2d& p) {
  const Eigen::Vector2d turned = rotationMatrix(2.9) * p;
  return {1.05 * turned.x() + 0.4 * std::sin(0.2 * p.y()), turned.y() + 0.5 * std::cos(0.15 * p.x())};
}

std::string corridorFile() {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  const AnchorList anchors = testing::anchorsAt(*mesh, 25, 4, bend);
  const Solution solution = *MeshSolver(mesh).solve(anchors, defaultSettings(Model::kStretch));
  ProjectorOptions options;
  options.slam.name = "robot 7";
  return *formatProjectorFile(*makeProjectorData(*mesh, solution, anchors, options));
}

bool equal(const cad2slam_pose& a, const Pose2& b) {
  const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return same(a.x, b.translation.x()) && same(a.y, b.translation.y()) && same(a.heading, b.heading);
}

}  // namespace

class CApiTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void cleanupTestCase() { cad2slam_free(in_c_); }
  void givesWhatTheCppLibraryGives_data();
  void givesWhatTheCppLibraryGives();
  void threadsShareAProjector();
  void messagesAreCutBetweenCharacters();
  void damageIsMalformed();

 private:
  std::string file_;
  std::optional<Projector> in_cpp_;
  cad2slam_projector* in_c_ = nullptr;
  std::vector<cad2slam_pose> poses_;
};

void CApiTest::initTestCase() {
  file_ = corridorFile();
  in_cpp_ = *loadProjector(file_, "corridor");
  char message[256];
  const int result = cad2slam_load_bytes(file_.data(), file_.size(), "corridor", &in_c_, message, sizeof message);
  QVERIFY2(result == CAD2SLAM_OK, message);
  QCOMPARE(QByteArray(cad2slam_metadata(in_c_, "slam_name")), QByteArray("robot 7"));
  QCOMPARE(cad2slam_node_count(in_c_), in_cpp_->nodeCount());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-40.0, 40.0);
  std::uniform_real_distribution<double> heading(-10.0, 10.0);
  for (int k = 0; k < 20000; ++k) poses_.push_back({place(random), place(random), heading(random)});
}

void CApiTest::givesWhatTheCppLibraryGives_data() {
  QTest::addColumn<int>("in_c");
  QTest::addColumn<bool>("rigid");
  QTest::newRow("as the file says") << int{CAD2SLAM_OUTSIDE_AS_FILE} << false;
  QTest::newRow("error") << int{CAD2SLAM_OUTSIDE_ERROR} << false;
  QTest::newRow("rigid") << int{CAD2SLAM_OUTSIDE_RIGID} << true;
}

void CApiTest::givesWhatTheCppLibraryGives() {
  QFETCH(int, in_c);
  QFETCH(bool, rigid);
  const OutsidePolicy policy = rigid ? OutsidePolicy::kRigid : OutsidePolicy::kError;
  std::vector<cad2slam_pose> there(poses_.size());
  std::vector<cad2slam_pose> back(poses_.size());
  std::vector<uint8_t> status(poses_.size());
  cad2slam_slam_from_blueprint_many(in_c_, poses_.data(), there.data(), status.data(), poses_.size(), in_c);
  std::size_t answered = 0;
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    const Pose2 pose{{poses_[k].x, poses_[k].y}, poses_[k].heading};
    const Projection expected = in_cpp_->slamFromBlueprint(pose, policy);
    QVERIFY(equal(there[k], expected.pose) && status[k] == static_cast<uint8_t>(expected.status));
    answered += expected.ok() ? 1 : 0;
  }
  QVERIFY(answered > 100);
  cad2slam_blueprint_from_slam_many(in_c_, there.data(), back.data(), status.data(), poses_.size(), in_c);
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    const Pose2 pose{{there[k].x, there[k].y}, there[k].heading};
    const Projection expected = in_cpp_->blueprintFromSlam(pose, policy);
    QVERIFY(equal(back[k], expected.pose) && status[k] == static_cast<uint8_t>(expected.status));
  }
}

void CApiTest::threadsShareAProjector() {
  cad2slam_projector* fresh = nullptr;  // nobody has asked it anything
  QCOMPARE(cad2slam_load_bytes(file_.data(), file_.size(), nullptr, &fresh, nullptr, 0), int{CAD2SLAM_OK});
  std::vector<std::vector<cad2slam_pose>> answers(4, poses_);
  std::vector<std::thread> threads;
  for (auto& mine : answers) {
    threads.emplace_back([&mine, fresh] {
      cad2slam_blueprint_from_slam_many(fresh, mine.data(), mine.data(), nullptr, mine.size(), CAD2SLAM_OUTSIDE_RIGID);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    const Projection expected =
        in_cpp_->blueprintFromSlam({{poses_[k].x, poses_[k].y}, poses_[k].heading}, OutsidePolicy::kRigid);
    for (const auto& mine : answers) QVERIFY(equal(mine[k], expected.pose));
  }
  cad2slam_free(fresh);
}

void CApiTest::messagesAreCutBetweenCharacters() {
  for (std::size_t size = 1; size < 40; ++size) {
    std::vector<char> message(size + 1, '#');
    cad2slam_projector* projector = nullptr;
    QCOMPARE(cad2slam_load("/\u00e4\u2603\U0001F916", &projector, message.data(), size), int{CAD2SLAM_NOT_FOUND});
    QCOMPARE(message[size], '#');
    const QByteArray text(message.data());
    QVERIFY(text.size() < static_cast<qsizetype>(size));
    QCOMPARE(QString::fromUtf8(text).toUtf8(), text);
  }
}

void CApiTest::damageIsMalformed() {
  std::mt19937 random(9);
  for (int k = 0; k < 300; ++k) {
    std::string damaged = file_;
    damaged[random() % damaged.size()] ^= static_cast<char>(1U << (random() % 8U));
    if (k % 3 == 0) damaged.resize(random() % damaged.size());
    cad2slam_projector* projector = nullptr;
    char message[64] = "";
    const int result = cad2slam_load_bytes(damaged.data(), damaged.size(), "x", &projector, message, sizeof message);
    if (result == CAD2SLAM_OK) {  // only blanks behind the header mean nothing
      QCOMPARE(damaged.size(), file_.size());
      cad2slam_free(projector);
    } else {
      QCOMPARE(result, int{CAD2SLAM_MALFORMED});
      QVERIFY(projector == nullptr && message[0] != '\0');
    }
  }
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::CApiTest)
#include "cad2slam_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QTemporaryDir>
#include <QtTest>

#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <random>

#include "cad2slam/c_api/cad2slam.h"
#include "cad2slam/io/projector_file.h"
#include "support/bent_hall.h"

/// Robots query in their control loop: a query takes no memory, whatever it is asked and whatever it answers. And where
/// there is no memory for loading, that is an error as any other and no exception.

namespace {

thread_local bool counts = false;
thread_local int allocations = 0;
thread_local int failing = -1;  // which one gets no memory
/// [bytes] What is smaller is not counted and never fails: memory runs out at the arrays of a large building, and
/// destructors of nlohmann/json, which allocate a little, cannot do without.
thread_local std::size_t smallest = 0;

/// Whether this allocation may have what it asks for.
bool granted(std::size_t size) {
  return !counts || size < smallest || allocations++ != failing;
}

}  // namespace

// In place of the functions of the C library, under which everything else allocates: operator new and Eigen as well.
extern "C" {
void* __libc_malloc(std::size_t size);                           // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void* old, std::size_t size);               // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t count, std::size_t size);        // NOLINT(bugprone-reserved-identifier)
void* __libc_memalign(std::size_t alignment, std::size_t size);  // NOLINT(bugprone-reserved-identifier)

void* malloc(std::size_t size) {
  return granted(size) ? __libc_malloc(size) : nullptr;
}

void* realloc(void* old, std::size_t size) {
  return granted(size) ? __libc_realloc(old, size) : nullptr;
}

void* calloc(std::size_t count, std::size_t size) {
  return granted(count * size) ? __libc_calloc(count, size) : nullptr;
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return granted(size) ? __libc_memalign(alignment, size) : nullptr;
}

void* mmap(void* place, std::size_t size, int protection, int flags, int file, off_t offset) {
  if (!granted(size)) return MAP_FAILED;
  return reinterpret_cast<void*>(::syscall(SYS_mmap, place, size, protection, flags, file, offset));
}
}

namespace cad2slam {
namespace {

template <class Work>
int allocationsOf(const Work& work) {
  allocations = 0;
  counts = true;
  work();
  counts = false;
  return allocations;
}

/// Places on the mesh, beyond it, and no places at all; of the blueprint, and good enough for the SLAM frame.
std::vector<Pose2> queries() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-30.0, 30.0);
  std::vector<Pose2> poses;
  for (int k = 0; k < 500; ++k) poses.push_back({{place(random), place(random)}, place(random)});
  poses.push_back({{std::numeric_limits<double>::quiet_NaN(), 0.0}, 0.0});
  poses.push_back({{1e300, -1e300}, 0.0});
  return poses;
}

}  // namespace

class MemoryTest : public QObject {
  Q_OBJECT
 private slots:
  void countingWorks();
  void queriesTakeNoMemory_data();
  void queriesTakeNoMemory();
  void loadingWithoutMemoryIsAnError();
};

void MemoryTest::countingWorks() {
  std::vector<int> numbers;
  QVERIFY(allocationsOf([&] { numbers.resize(1000); }) >= 1);
}

void MemoryTest::queriesTakeNoMemory_data() {
  QTest::addColumn<bool>("paper_weights");
  QTest::addColumn<bool>("folded");
  QTest::newRow("smooth") << false << false;
  QTest::newRow("paper") << true << false;
  QTest::newRow("smooth, folded") << false << true;
  QTest::newRow("paper, folded") << true << true;
}

void MemoryTest::queriesTakeNoMemory() {
  QFETCH(bool, paper_weights);
  QFETCH(bool, folded);
  ProjectorData data = test::bentHallData();
  data.info.weights = paper_weights ? BlendWeights::kPaper : BlendWeights::kSmooth;
  if (folded) std::swap(data.node_slam[50], data.node_slam[75]);
  const Projector projector = *Projector::create(data);
  const std::string file = *formatProjectorFile(data);
  cad2slam_projector* in_c = nullptr;
  QCOMPARE(cad2slam_load_bytes(file.data(), file.size(), nullptr, &in_c, nullptr, 0), int{CAD2SLAM_OK});
  const std::vector<Pose2> poses = queries();
  std::array<int, 5> answers{};
  const int taken = allocationsOf([&] {
    for (const Pose2& pose : poses) {
      for (const OutsidePolicy outside : {OutsidePolicy::kError, OutsidePolicy::kRigid}) {
        ++answers[static_cast<std::size_t>(projector.slamFromBlueprint(pose, outside).status)];
        ++answers[static_cast<std::size_t>(projector.blueprintFromSlam(pose, outside).status)];
      }
      (void)projector.jacobian(pose.translation);
      cad2slam_pose answer = {pose.translation.x(), pose.translation.y(), pose.heading};
      (void)cad2slam_slam_from_blueprint(in_c, &answer, &answer, CAD2SLAM_OUTSIDE_RIGID);
      (void)cad2slam_blueprint_from_slam(in_c, &answer, &answer, CAD2SLAM_OUTSIDE_AS_FILE);
    }
  });
  cad2slam_free(in_c);
  QCOMPARE(taken, 0);
  for (const ProjectionStatus status : {ProjectionStatus::kInside, ProjectionStatus::kExtrapolated,
                                        ProjectionStatus::kOutside, ProjectionStatus::kInvalid}) {
    QVERIFY(answers[static_cast<std::size_t>(status)] > 0);
  }
}

void MemoryTest::loadingWithoutMemoryIsAnError() {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("hall.c2s").toStdString();
  QVERIFY(writeProjectorFile(path, test::bentHallData()));
  const std::string c_path = path.string();
  smallest = 2048;
  bool loaded = false;
  for (failing = 0; !loaded; ++failing) {
    std::optional<ErrorCode> code;
    const int taken = allocationsOf([&] {
      const Result<Projector> projector = loadProjector(path);
      if (!projector) code = projector.error().code;
    });
    loaded = taken <= failing;
    QCOMPARE(loaded, !code.has_value());
    if (code) QCOMPARE(*code, ErrorCode::kInternal);
  }
  const int all = failing - 1;
  QVERIFY2(all >= 3, qPrintable(QString::number(all)));
  for (failing = 0; failing < all; ++failing) {
    cad2slam_projector* in_c = nullptr;
    char message[100];
    int result = CAD2SLAM_OK;
    allocationsOf([&] { result = cad2slam_load(c_path.c_str(), &in_c, message, sizeof message); });
    QCOMPARE(result, int{CAD2SLAM_OUT_OF_MEMORY});
    QVERIFY(in_c == nullptr && QByteArray(message).contains("memory"));
  }
  failing = -1;
  smallest = 0;
}

}  // namespace cad2slam

QTEST_APPLESS_MAIN(cad2slam::MemoryTest)
#include "memory_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/projector_file.h"

#include <QtTest>

#include <atomic>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <thread>

#include "cad2slam/io/projector_header.h"
#include "support/projector_parts.h"
#include "support/projector_samples.h"
#include "support/temporary_folder.h"

using namespace cad2slam;

namespace {

using Edit = std::function<void(ProjectorHeader&, std::string& data)>;

/// A good file with something changed, and sealed again: what a program would write that means harm or has a bug.
std::string edited(const Edit& edit) {
  const std::string bytes = *formatProjectorFile(test::sampleProjector(4, 3));
  auto [header, data] = *test::partsOf(bytes);
  edit(header, data);
  sealProjectorHeader(header, data);
  return formatProjectorPrefix(header) + data;
}

template <class Number>
Edit setNumber(const char* array, std::size_t index, Number value) {
  return [=](const ProjectorHeader& header, std::string& data) {
    std::memcpy(data.data() + header.arrays.at(array).begin + index * sizeof(Number), &value, sizeof(Number));
  };
}

}  // namespace

Q_DECLARE_METATYPE(Edit)

class ProjectorFileTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsWrittenIsRead() {
    const test::TemporaryFolder folder;
    for (const auto& [columns, rows] : {std::pair(3, 1), {4, 3}, {40, 25}}) {
      const ProjectorData data = test::sampleProjector(columns, rows);
      const Result<std::string> bytes = formatProjectorFile(data);
      QVERIFY2(bytes, bytes ? "" : bytes.error().sentence().c_str());
      QVERIFY(*formatProjectorFile(data) == *bytes);
      QVERIFY(test::sameProjector(*parseProjectorFile(*bytes, "x"), data));
      QVERIFY(writeProjectorFile(folder.path("a.c2s"), data).has_value());
      QVERIFY(folder.read("a.c2s") == *bytes);
      QVERIFY(test::sameProjector(*readProjectorFile(folder.path("a.c2s")), data));
    }
  }

  void theLoadedFunctionIsTheSame() {
    const test::TemporaryFolder folder;
    const ProjectorData data = test::sampleProjector(12, 9);
    QVERIFY(writeProjectorFile(folder.path("a.c2s"), data).has_value());
    const Result<Projector> made = Projector::create(data);
    const Result<Projector> loaded = loadProjector(folder.path("a.c2s"));
    QVERIFY2(loaded, loaded ? "" : loaded.error().sentence().c_str());
    QVERIFY(test::sameInfo(loaded->info(), data.info));
    for (int k = 0; k < 1000; ++k) {
      const Pose2 pose{data.info.lattice.blueprintFromCells({0.012 * k, 8.0 - 0.007 * k}), 0.1 * k};
      QVERIFY(test::samePose(loaded->slamFromBlueprint(pose).pose, made->slamFromBlueprint(pose).pose));
    }
  }

  void anyAddressWillDo() {
    const std::string bytes = *formatProjectorFile(test::sampleProjector(4, 3));
    for (std::size_t shift = 0; shift < 9; ++shift) {
      const std::string shifted = std::string(shift, 'x') + bytes;
      QVERIFY(loadProjector(std::string_view(shifted).substr(shift), "x").has_value());
      QVERIFY(parseProjectorFile(std::string_view(shifted).substr(shift), "x").has_value());
    }
  }

  void cutAnywhereItIsAnError() {
    const std::string bytes = *formatProjectorFile(test::sampleProjector(3, 1));
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      const Result<Projector> loaded = loadProjector(std::string_view(bytes).substr(0, length), "a.c2s");
      QVERIFY2(!loaded, std::to_string(length).c_str());
      QVERIFY(loaded.error().code == ErrorCode::kMalformed);
      QCOMPARE(loaded.error().where, std::string("a.c2s"));
    }
    QVERIFY(!loadProjector(bytes + "x", "a.c2s"));
  }

  void anyChangedByteIsAnError() {
    const std::string bytes = *formatProjectorFile(test::sampleProjector(3, 1));
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ 1);
      QVERIFY2(!loadProjector(changed, "a.c2s"), std::to_string(at).c_str());
      QVERIFY(!parseProjectorFile(changed, "a.c2s"));
    }
  }

  void filesThatLieAreRefusedThoughSealed_data() {
    QTest::addColumn<Edit>("edit");
    QTest::addColumn<QString>("word");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const auto row = [](const char* name, const Edit& edit, const char* word) { QTest::newRow(name) << edit << word; };
    row("NaN centre", setNumber("node_blueprint", 3, nan), "");
    row("infinite pose", setNumber("node_slam", 4, infinity), "");
    row("NaN heading", setNumber("node_slam", 2, nan), "");
    row("NaN stretch", setNumber("node_stretch", 0, nan), "");
    row("wild stretch", setNumber("node_stretch", 0, 700.0), "");
    row("two nodes on one tile", setNumber("node_tile", 0, std::int32_t{1}), "");
    row("tile at the end of the world", setNumber("node_tile", 0, std::numeric_limits<std::int32_t>::min()), "");
    row("edge to nowhere", setNumber("edges", 1, std::uint32_t{12}), "an edge to a node that does not exist");
    row("NaN anchor", setNumber("anchors", 7, nan), "an anchor that is not finite");
    row("NaN check", setNumber("check_poses", 0, nan), "a check pose that is not finite");
    row("wrong check place", setNumber("check_poses", 9, 77.0), "does not reproduce its own check pose 2");
    row("wrong check heading", setNumber("check_poses", 5, 0.01), "does not reproduce its own check pose 1");
    row(
        "no edges",
        [](ProjectorHeader& header, std::string& data) {
          const ArrayEntry edges = header.arrays.at("edges");
          data.erase(edges.begin, edges.end - edges.begin);
          header.arrays.erase("edges");
          for (auto& [name, entry] : header.arrays) {
            if (entry.begin < edges.end) continue;
            entry.begin -= edges.end - edges.begin;
            entry.end -= edges.end - edges.begin;
          }
        },
        "has no array edges");
    row(
        "other type", [](ProjectorHeader& header, std::string&) { header.arrays["edges"].dtype = "I32"; },
        "an array edges that is not U32");
    row(
        "other columns",
        [](ProjectorHeader& header, std::string&) {
          header.arrays["node_slam"].shape = {18, 2};
        },
        "an array node_slam that is not F64 in 3 columns");
    row(
        "one column list", [](ProjectorHeader& header, std::string&) { header.arrays["edges"].shape = {34}; },
        "an array edges");
    row(
        "fewer nodes in one array",
        [](ProjectorHeader& header, std::string&) {
          header.arrays["node_tile"].shape = {11, 2};
          header.arrays["node_tile"].end -= 8;
          header.arrays["rest"] = {"U8", {8}, header.arrays["node_tile"].end, header.arrays["node_tile"].end + 8};
        },
        "different lengths");
    row(
        "newer format", [](ProjectorHeader& header, std::string&) { header.metadata["version"] = "2.0"; }, "2.0");
    row(
        "no scale", [](ProjectorHeader& header, std::string&) { header.metadata.erase("scale"); }, "scale");
    row(
        "negative cells", [](ProjectorHeader& header, std::string&) { header.metadata["cell_size_m"] = "-1"; }, "");
  }
  void filesThatLieAreRefusedThoughSealed() {
    QFETCH(Edit, edit);
    QFETCH(QString, word);
    const std::string bytes = edited(edit);
    const Result<Projector> loaded = loadProjector(bytes, "a.c2s");
    QVERIFY(!loaded);
    QVERIFY(loaded.error().code == ErrorCode::kMalformed);
    QCOMPARE(loaded.error().where, std::string("a.c2s"));
    QVERIFY2(QString::fromStdString(loaded.error().message).contains(word), loaded.error().message.c_str());
    QVERIFY(!parseProjectorFile(bytes, "a.c2s"));
  }

  void newerMinorVersionsAreRead() {
    const std::string bytes = edited([](ProjectorHeader& header, std::string& data) {
      header.metadata["version"] = "1.9";
      header.metadata["colour"] = "blue";
      header.arrays["sigma"] = {"F32", {2, 3}, data.size(), data.size() + 24};
      data += std::string(24, 's');
    });
    QVERIFY(loadProjector(bytes, "a.c2s").has_value());
  }

  /// What nobody knows is hashed as well, wherever it lies and however long it is.
  void unknownArraysBeforeTheOthers() {
    std::string bytes = edited([](ProjectorHeader& header, std::string& data) {
      constexpr std::size_t kLong = 1000003;  // no multiple of anything: all others lie on odd addresses
      for (auto& [name, entry] : header.arrays) {
        entry.begin += kLong;
        entry.end += kLong;
      }
      header.arrays["picture"] = {"U8", {kLong}, 0, kLong};
      data.insert(0, kLong, 'p');
    });
    QVERIFY(test::sameProjector(*parseProjectorFile(bytes, "a.c2s"), test::sampleProjector(4, 3)));
    char& in_picture = bytes[bytes.size() - 500000];
    in_picture = 'q';
    QVERIFY(loadProjector(bytes, "a.c2s").error().message.find("SHA-256") != std::string::npos);
  }

  void withoutSealsItIsNoProjector() {
    const std::string bytes = *formatProjectorFile(test::sampleProjector(3, 1));
    auto [header, data] = *test::partsOf(bytes);
    header.metadata.erase("header_sha256");
    QVERIFY(!loadProjector(formatProjectorPrefix(header) + data, "a.c2s"));
  }

  void dataThatNoReaderTakesAreNotWritten_data() {
    QTest::addColumn<int>("what");
    for (int what = 0; what < 8; ++what) QTest::addRow("%d", what) << what;
  }
  void dataThatNoReaderTakesAreNotWritten() {
    QFETCH(int, what);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    ProjectorData data = test::sampleProjector(4, 3);
    if (what == 0) data.node_slam.pop_back();
    if (what == 1) data.node_slam[3].heading = nan;
    if (what == 2) data.edges[0][1] = 12;
    if (what == 3) data.anchors[0][0] = nan;
    if (what == 4) data.check_poses[0].in_slam.translation.x() += 0.1;
    if (what == 5) data.info.scale = nan;
    if (what == 6) data.info.note = std::string(2000000, 'x');
    if (what == 7) data = {};
    const test::TemporaryFolder folder;
    folder.write("a.c2s", "old");
    const Result<void> written = writeProjectorFile(folder.path("a.c2s"), data);
    QVERIFY(!written);
    QVERIFY(!written.error().message.empty());
    QCOMPARE(folder.read("a.c2s"), std::string("old"));
  }

  void largeFilesAreHashedInSlices() {
    const ProjectorData data = test::sampleProjector(200, 150);
    std::string bytes = *formatProjectorFile(data);
    QVERIFY(bytes.size() > (1U << 20));
    QVERIFY(loadProjector(bytes, "x").has_value());
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    QVERIFY(loadProjector(bytes, "x").error().message.find("SHA-256") != std::string::npos);
  }

  /// Our own programs replace files as a whole. One that writes into a file while a robot loads it must neither end the
  /// robot's process nor give it a function that was never checked.
  void aFileThatIsRewrittenInPlaceIsReadAsAWholeOrRefused() {
    const test::TemporaryFolder folder;
    ProjectorData data = test::sampleProjector(200, 150);
    const std::string first = *formatProjectorFile(data);
    for (Pose2& pose : data.node_slam) pose.translation.x() += 1.0;
    for (CheckPose& check : data.check_poses) check.in_slam.translation.x() += 1.0;
    const std::string second = *formatProjectorFile(data);
    QCOMPARE(first.size(), second.size());
    const std::filesystem::path path = folder.write("a.c2s", first);

    std::atomic<bool> ends{false};
    std::thread writer([&] {
      std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
      while (!ends) {
        for (const std::string* content : {&second, &first}) {
          file.seekp(0).write(content->data(), static_cast<std::streamsize>(content->size())).flush();
          std::filesystem::resize_file(path, content->size() / 3);
        }
      }
    });
    const auto placesOf = [&data](const Projector& projector) {
      std::vector<Eigen::Vector2d> places;
      for (const Eigen::Vector2d& center : data.node_blueprint) {
        places.push_back(projector.slamFromBlueprint({center, 0.0}, OutsidePolicy::kError).pose.translation);
      }
      return places;
    };
    const std::vector<Eigen::Vector2d> of_first = placesOf(*loadProjector(first, "first"));
    const std::vector<Eigen::Vector2d> of_second = placesOf(*loadProjector(second, "second"));
    int mixed = 0;
    int refused = 0;
    for (int k = 0; k < 200; ++k) {
      const Result<Projector> loaded = loadProjector(path);
      if (!loaded) {
        ++refused;
        continue;
      }
      const std::vector<Eigen::Vector2d> places = placesOf(*loaded);
      if (places != of_first && places != of_second) ++mixed;
    }
    ends = true;
    writer.join();
    QCOMPARE(mixed, 0);
    QVERIFY(refused > 0);
  }

  void aLargeFileOfAnotherKindIsRefusedByItsFirstBytes() {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.write("map.bag", "#ROSBAG V2.0\n");
    std::filesystem::resize_file(path, std::uintmax_t{1} << 42);  // of holes; more than any memory
    QVERIFY(loadProjector(path).error().code == ErrorCode::kMalformed);
    const std::string good = *formatProjectorFile(test::sampleProjector(4, 3));
    const std::filesystem::path longer = folder.write("longer.c2s", good);
    std::filesystem::resize_file(longer, std::uintmax_t{1} << 42);
    QVERIFY(loadProjector(longer).error().message.find("bytes too many") != std::string::npos);
    QVERIFY(readProjectorFile(longer).error().code == ErrorCode::kMalformed);
  }

  void missingFilesAndFolders() {
    const test::TemporaryFolder folder;
    QVERIFY(loadProjector(folder.path("none.c2s")).error().code == ErrorCode::kNotFound);
    QVERIFY(loadProjector(folder.path()).error().code == ErrorCode::kUnreadable);
    QVERIFY(loadProjector(folder.write("empty.c2s", "")).error().code == ErrorCode::kMalformed);
    QVERIFY(readProjectorFile(folder.path("none.c2s")).error().code == ErrorCode::kNotFound);
  }
};

QTEST_APPLESS_MAIN(ProjectorFileTest)
#include "projector_file_test.moc"

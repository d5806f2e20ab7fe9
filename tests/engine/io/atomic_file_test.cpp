// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/atomic_file.h"

#include <QtTest>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>

#include "support/temporary_folder.h"

using namespace cad2slam;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kOnlyTheFile{"file"};

/// Runs `work` in a process of its own; its exit code is 0 when `work` says true.
template <class Work>
pid_t inChild(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work() ? 0 : 1);
  return child;
}

int exitCodeOf(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

class AtomicFileTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsWrittenIsRead() {
    const test::TemporaryFolder folder;
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{262144}, std::size_t{3000000}}) {
      std::string content(size, '\0');
      for (std::size_t k = 0; k < size; ++k) content[k] = static_cast<char>(k % 251);
      QVERIFY(writeFileAtomically(folder.path("file"), content).has_value());
      QVERIFY(*readFile(folder.path("file"), size) == content);
      QCOMPARE(folder.names(), kOnlyTheFile);
    }
  }

  void piecesAreJoined() {
    const test::TemporaryFolder folder;
    std::string expected;
    const auto produce = [&expected](const ByteSink& sink) -> Result<void> {
      for (int k = 0; k < 100000; ++k) {
        const std::string piece = std::to_string(k) + "\n";
        expected += piece;
        if (const Result<void> written = sink(piece); !written) return written;
      }
      return {};
    };
    QVERIFY(writeFileAtomically(folder.path("file"), produce).has_value());
    QVERIFY(folder.read("file") == expected);
  }

  void aFailingProducerChangesNothing() {
    const test::TemporaryFolder folder;
    folder.write("file", "old");
    const auto produce = [](const ByteSink& sink) -> Result<void> {
      static_cast<void>(sink(std::string(1000000, 'x')));
      return fail(ErrorCode::kCancelled, "enough");
    };
    const Result<void> written = writeFileAtomically(folder.path("file"), produce);
    QVERIFY(!written);
    QVERIFY(written.error().code == ErrorCode::kCancelled);
    QCOMPARE(folder.read("file"), std::string("old"));
    QCOMPARE(folder.names(), kOnlyTheFile);
  }

  void permissionsStay() {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("file", "old");
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
    QVERIFY(writeFileAtomically(path, "new").has_value());
    QVERIFY(fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read));
  }

  void newFilesFollowTheUmask() {
    const test::TemporaryFolder folder;
    const mode_t old_mask = ::umask(027);
    QVERIFY(writeFileAtomically(folder.path("file"), "new").has_value());
    ::umask(old_mask);
    QVERIFY((fs::status(folder.path("file")).permissions() & fs::perms::all) == fs::perms(0640));
  }

  void linksLeadToTheirTarget() {
    const test::TemporaryFolder folder;
    fs::create_directory(folder.path("deep"));
    fs::create_symlink("deep/target", folder.path("link"));
    fs::create_symlink(folder.path("link"), folder.path("link_to_link"));
    QVERIFY(writeFileAtomically(folder.path("link_to_link"), "first").has_value());  // the target does not exist yet
    QVERIFY(writeFileAtomically(folder.path("link"), "second").has_value());
    QVERIFY(fs::is_symlink(folder.path("link")));
    QCOMPARE(folder.read("deep/target"), std::string("second"));
    fs::create_symlink("loop", folder.path("loop"));
    QVERIFY(writeFileAtomically(folder.path("loop"), "x").error().code == ErrorCode::kUnwritable);
  }

  void refusesWhatCannotBeReplaced_data() {
    QTest::addColumn<QString>("path");
    QTest::newRow("a folder") << ".";
    QTest::newRow("no file name") << "./";
    QTest::newRow("empty") << "";
    QTest::newRow("no such folder") << "none/file";
    QTest::newRow("a device") << "/dev/null";
    QTest::newRow("inside a file") << "/etc/passwd/file";
    QTest::newRow("name too long") << QString(300, 'x');
  }
  void refusesWhatCannotBeReplaced() {
    QFETCH(QString, path);
    const test::TemporaryFolder folder;
    const Result<void> written = writeFileAtomically(path.isEmpty() ? "" : folder.path() / path.toStdString(), "x");
    QVERIFY(!written);
    QVERIFY(written.error().code == ErrorCode::kUnwritable);
    QVERIFY(folder.names().empty());
  }

  void aProtectedFileStays() {
    if (::geteuid() == 0) QSKIP("root may write everything");
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("file", "old");
    fs::permissions(path, fs::perms::owner_read);
    QVERIFY(writeFileAtomically(path, "new").error().code == ErrorCode::kUnwritable);
    QCOMPARE(folder.read("file"), std::string("old"));
  }

  void longNamesHaveRoomForTheTemporaryFile() {
    const test::TemporaryFolder folder;
    QVERIFY(writeFileAtomically(folder.path(std::string(255, 'x')), "new").has_value());
  }

  void aFullDiskLeavesTheOldFile() {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("file", "old");
    const pid_t child = inChild([&path] {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{65536, 65536};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      const Result<void> written = writeFileAtomically(path, std::string(1000000, 'x'));
      return !written && written.error().code == ErrorCode::kUnwritable && written.error().where == path.string();
    });
    QCOMPARE(exitCodeOf(child), 0);
    QCOMPARE(folder.read("file"), std::string("old"));
    QCOMPARE(folder.names(), kOnlyTheFile);
  }

  void killedAtAnyMomentTheOldOrTheNewFileIsThere() {
    const test::TemporaryFolder folder;
    const std::string contents[] = {std::string(400000, 'a'), std::string(700000, 'b')};
    const fs::path path = folder.write("file", contents[0]);
    std::mt19937 random(3);
    int complete[] = {0, 0};
    constexpr int kKills = 150;
    constexpr int kPatience = 1500;  // on a busy machine a save takes longer
    for (int k = 0; k < kKills || (k < kPatience && (complete[0] == 0 || complete[1] == 0)); ++k) {
      std::uniform_int_distribution<useconds_t> moment(0, static_cast<useconds_t>(4000 * (1 + k / kKills)));
      const pid_t child = inChild([&] {
        for (int turn = 1;; ++turn) {
          if (!writeFileAtomically(path, contents[turn % 2])) return false;
        }
      });
      ::usleep(moment(random));
      ::kill(child, SIGKILL);
      QCOMPARE(exitCodeOf(child), -1);  // killed, not failed
      const std::string found = folder.read("file");
      QVERIFY(found == contents[0] || found == contents[1]);
      ++complete[found == contents[1] ? 1 : 0];
    }
    QVERIFY2(complete[0] > 0 && complete[1] > 0, "the moments never hit a save");
  }

  void readingIsLimited() {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("file", "0123456789");
    QCOMPARE(*readFile(path, 10), std::string("0123456789"));
    QVERIFY(readFile(path, 9).error().code == ErrorCode::kMalformed);
    QVERIFY(readFile(folder.path("none"), 9).error().code == ErrorCode::kNotFound);
    QVERIFY(readFile(folder.path(), 9).error().code == ErrorCode::kUnreadable);
    // A file that claims a size of zero and another that claims a terabyte.
    QVERIFY(!readFile("/proc/self/status", 1 << 20)->empty());
    QCOMPARE(::truncate(path.c_str(), off_t{1} << 40), 0);
    QVERIFY(readFile(path, 1 << 20).error().code == ErrorCode::kMalformed);
  }
};

QTEST_APPLESS_MAIN(AtomicFileTest)
#include "atomic_file_test.moc"

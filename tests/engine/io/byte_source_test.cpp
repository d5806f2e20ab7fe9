// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/byte_source.h"

#include <QtTest>

#include <string>

#include "support/temporary_folder.h"

using namespace cad2slam;

class ByteSourceTest : public QObject {
  Q_OBJECT

 private slots:
  void filesAndMemoryGiveTheSame() {
    const test::TemporaryFolder folder;
    const std::string content = "0123456789";
    ByteSource memory = ByteSource::ofMemory(content, "memory");
    Result<ByteSource> file = ByteSource::ofFile(folder.write("a", content));
    QVERIFY(file.has_value());
    for (ByteSource* source : {&memory, &*file}) {
      QCOMPARE(source->remaining(), std::uintmax_t{10});
      std::string taken(4, ' ');
      QVERIFY(source->read(taken.data(), 4).has_value());
      QCOMPARE(taken, std::string("0123"));
      QVERIFY(source->read(taken.data(), 0).has_value());
      QVERIFY(source->read(taken.data(), 3).has_value());
      QCOMPARE(taken, std::string("4563"));
      QCOMPARE(source->remaining(), std::uintmax_t{3});
      const Result<void> beyond = source->read(taken.data(), 4);
      QVERIFY(!beyond);
      QCOMPARE(beyond.error().where, source->name());
      QVERIFY(source->read(taken.data(), 3).has_value());
      QCOMPARE(taken, std::string("7893"));
    }
  }

  void aFileThatIsCutMeanwhile() {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.write("a", std::string(100000, 'x'));
    Result<ByteSource> source = ByteSource::ofFile(path);
    std::string taken(60000, ' ');
    QVERIFY(source->read(taken.data(), 10).has_value());
    std::filesystem::resize_file(path, 50000);
    const Result<void> read = source->read(taken.data(), taken.size());
    QVERIFY(!read);
    QVERIFY(read.error().code == ErrorCode::kMalformed);
    QCOMPARE(read.error().message, std::string("was cut off while it was read"));
    QCOMPARE(read.error().where, path.string());
  }

  /// It has the size of the time it was opened.
  void aFileThatGrowsMeanwhile() {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.write("a", "abc");
    Result<ByteSource> source = ByteSource::ofFile(path);
    std::filesystem::resize_file(path, 50000);
    QCOMPARE(source->remaining(), std::uintmax_t{3});
    std::string taken(4, ' ');
    QVERIFY(!source->read(taken.data(), 4));
  }

  void whatIsNoFile() {
    const test::TemporaryFolder folder;
    QVERIFY(ByteSource::ofFile(folder.path("none")).error().code == ErrorCode::kNotFound);
    QVERIFY(ByteSource::ofFile(folder.path()).error().code == ErrorCode::kUnreadable);
  }
};

QTEST_APPLESS_MAIN(ByteSourceTest)
#include "byte_source_test.moc"

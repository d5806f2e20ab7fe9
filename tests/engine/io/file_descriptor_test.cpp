// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/file_descriptor.h"

#include <QtTest>

#include <sys/stat.h>

#include "support/temporary_folder.h"

using namespace cad2slam;

class FileDescriptorTest : public QObject {
  Q_OBJECT

 private slots:
  void readsFromAnyPlace() {
    const test::TemporaryFolder folder;
    Result<FileDescriptor> file = openRegularFile(folder.write("a", "0123456789"));
    QVERIFY(file.has_value());
    QCOMPARE(*file->size(), std::uintmax_t{10});
    QCOMPARE(*file->readAt(3, 4), std::string("3456"));
    QCOMPARE(*file->readAt(8, 4), std::string("89"));
    QCOMPARE(*file->readAt(100, 4), std::string());
    QVERIFY(!file->readAt(~std::uintmax_t{0}, 4));  // no such place in any file
    char bytes[4];
    QCOMPARE(*file->read(bytes, 4), std::size_t{4});
    QCOMPARE(std::string(bytes, 4), std::string("0123"));
  }

  void refusesWhatIsNoFile() {
    const test::TemporaryFolder folder;
    QVERIFY(openRegularFile(folder.path("none")).error().code == ErrorCode::kNotFound);
    QVERIFY(openRegularFile(folder.path() / "none" / "deeper").error().code == ErrorCode::kNotFound);
    QVERIFY(openRegularFile("").error().code == ErrorCode::kNotFound);
    QVERIFY(openRegularFile(folder.path()).error().code == ErrorCode::kUnreadable);
    QVERIFY(openRegularFile("/dev/zero").error().code == ErrorCode::kUnreadable);
    const std::filesystem::path pipe = folder.path("pipe");  // opening one must not wait for a writer
    QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
    QVERIFY(openRegularFile(pipe).error().code == ErrorCode::kUnreadable);
    QCOMPARE(openRegularFile(pipe).error().where, pipe.string());
  }
};

QTEST_APPLESS_MAIN(FileDescriptorTest)
#include "file_descriptor_test.moc"

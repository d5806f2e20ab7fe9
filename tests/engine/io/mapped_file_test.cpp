// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/mapped_file.h"

#include <QtTest>

#include "cad2slam/io/atomic_file.h"
#include "support/temporary_folder.h"

using namespace cad2slam;

class MappedFileTest : public QObject {
  Q_OBJECT

 private slots:
  void showsTheBytesOfTheFile() {
    const test::TemporaryFolder folder;
    std::string content(100000, 'x');
    content[50000] = 'y';
    const Result<MappedFile> file = MappedFile::open(folder.write("a", content));
    QVERIFY(file.has_value());
    QVERIFY(file->bytes() == content);
    file->release(file->bytes().substr(10, 80000));
    file->release({});
    QVERIFY(file->bytes() == content);  // released parts are read again
  }

  void replacingTheFileDoesNotDisturbAReader() {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.write("a", std::string(100000, 'x'));
    const Result<MappedFile> file = MappedFile::open(path);
    QVERIFY(writeFileAtomically(path, "short").has_value());
    QVERIFY(file->bytes() == std::string(100000, 'x'));
  }

  void anEmptyFileIsNoError() {
    const test::TemporaryFolder folder;
    const Result<MappedFile> file = MappedFile::open(folder.write("empty", ""));
    QVERIFY(file.has_value());
    QVERIFY(file->bytes().empty());
  }

  void refusesWhatIsNoFile() {
    const test::TemporaryFolder folder;
    QVERIFY(MappedFile::open(folder.path("none")).error().code == ErrorCode::kNotFound);
    QVERIFY(MappedFile::open(folder.path()).error().code == ErrorCode::kUnreadable);
  }
};

QTEST_APPLESS_MAIN(MappedFileTest)
#include "mapped_file_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/sha256.h"

#include <QCryptographicHash>
#include <QtTest>

#include <string>

#include "support/temporary_folder.h"

using namespace cad2slam;

class Sha256Test : public QObject {
  Q_OBJECT

 private slots:
  void standardVectors() {  // FIPS 180-2
    QCOMPARE(sha256Hex("", 0), std::string("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"));
    QCOMPARE(sha256Hex("abc", 3), std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
  }

  void filesOfAnySizeAgreeWithAnotherImplementation() {
    const test::TemporaryFolder folder;
    for (const std::size_t size : {0U, 1U, 63U, 64U, 65U, 262143U, 262144U, 262145U, 700001U}) {
      std::string bytes(size, '\0');
      for (std::size_t k = 0; k < size; ++k) bytes[k] = static_cast<char>(k * k >> 3);
      const Result<std::string> hash = sha256HexOfFile(folder.write("file", bytes));
      QVERIFY(hash.has_value());
      const QByteArray expected = QCryptographicHash::hash(
          QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(size)), QCryptographicHash::Sha256);
      QCOMPARE(QByteArray::fromStdString(*hash), expected.toHex());
      QCOMPARE(sha256Hex(bytes.data(), bytes.size()), *hash);
    }
  }

  void aMissingFileIsAnError() {
    const test::TemporaryFolder folder;
    const Result<std::string> hash = sha256HexOfFile(folder.path("none"));
    QVERIFY(!hash);
    QVERIFY(hash.error().code == ErrorCode::kNotFound);
  }
};

QTEST_APPLESS_MAIN(Sha256Test)
#include "sha256_test.moc"

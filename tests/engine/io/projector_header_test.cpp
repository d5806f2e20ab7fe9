// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/projector_header.h"

#include <QtTest>

#include "support/projector_parts.h"

using namespace cad2slam;

namespace {

std::string fileOf(const std::string& json, const std::string& data) {
  std::string bytes;
  for (int k = 0; k < 8; ++k) bytes += static_cast<char>((json.size() >> (8 * k)) & 0xff);
  return bytes + json + data;
}

const std::string kData(24, 'd');

}  // namespace

class ProjectorHeaderTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsWrittenIsRead() {
    ProjectorHeader header;
    header.arrays["b"] = {"F64", {1, 2}, 0, 16};
    header.arrays["a"] = {"I32", {2}, 16, 24};
    header.arrays["none"] = {"U8", {0, 5}, 24, 24};
    header.metadata = {{"name", "T\xc3\xbcr \"1\"\n"}, {"", "x"}};
    const std::string bytes = formatProjectorPrefix(header) + kData;
    const Result<test::ProjectorParts> parts = test::partsOf(bytes);
    QVERIFY2(parts, parts ? "" : parts.error().sentence().c_str());
    QCOMPARE((bytes.size() - parts->data.size()) % 64, std::size_t{0});
    QVERIFY(parts->data == kData);
    QVERIFY(parts->header.metadata == header.metadata);
    QCOMPARE(formatProjectorHeader(parts->header), formatProjectorHeader(header));
    const std::string expected =
        "{\"__metadata__\":{\"\":\"x\",\"name\":\"T\xc3\xbcr \\\"1\\\"\\n\"},"
        "\"a\":{\"data_offsets\":[16,24],\"dtype\":\"I32\",\"shape\":[2]},"
        "\"b\":{\"data_offsets\":[0,16],\"dtype\":\"F64\",\"shape\":[1,2]},"
        "\"none\":{\"data_offsets\":[24,24],\"dtype\":\"U8\",\"shape\":[0,5]}}";
    QCOMPARE(formatProjectorHeader(header), expected);
  }

  void theSealCoversNamesAndData() {
    ProjectorHeader header;
    header.arrays["a"] = {"U8", {24}, 0, 24};
    header.metadata["note"] = "one";
    QVERIFY(!headerSealHolds(header));
    sealProjectorHeader(header, kData);
    QVERIFY(headerSealHolds(header));
    ProjectorHeader changed = header;
    changed.metadata["note"] = "two";
    QVERIFY(!headerSealHolds(changed));
    changed = header;
    changed.arrays["a"].shape = {12, 2};
    QVERIFY(!headerSealHolds(changed));
    changed = header;
    sealProjectorHeader(changed, kData);  // sealing again is the same
    QCOMPARE(formatProjectorHeader(changed), formatProjectorHeader(header));
    sealProjectorHeader(changed, "other");
    QVERIFY(changed.metadata.at(kDataSealKey) != header.metadata.at(kDataSealKey));
  }

  void bytesThatAreNoUnicodeCannotBreakTheText() {
    ProjectorHeader header;
    header.metadata["note"] = "T\xfcr";
    const Result<test::ProjectorParts> parts = test::partsOf(formatProjectorPrefix(header));
    QCOMPARE(parts->header.metadata.at("note"), std::string("T\xef\xbf\xbdr"));
  }

  void refusesWhatIsNoFlatHeader_data() {
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("word");
    const auto row = [](const char* name, const std::string& json, const char* word) {
      QTest::newRow(name) << QByteArray::fromStdString(json) << word;
    };
    const std::string good = R"("a":{"dtype":"U8","shape":[24],"data_offsets":[0,24]})";
    row("empty", "", "not valid JSON");
    row("list", "[]", "no JSON object");
    row("number", "7", "no JSON object");
    row("cut off", "{" + good, "not valid JSON");
    row("two documents", "{" + good + "}{}", "not valid JSON");
    row("zero bytes", "{" + good + "}" + std::string("\0x", 2), "zero bytes");
    row("array twice", "{" + good + "," + good + "}", "'a' twice");
    row("metadata twice", R"({"__metadata__":{},"__metadata__":{}})", "'__metadata__' twice");
    row("metadata key twice", R"({"__metadata__":{"k":"1","k":"1"}})", "'k' twice");
    row("key twice", R"({"a":{"dtype":"U8","dtype":"U8","shape":[24],"data_offsets":[0,24]}})", "'dtype' twice");
    row("number as metadata", R"({"__metadata__":{"k":1}})", "a number");
    row("nested metadata", R"({"__metadata__":{"k":{}}})", "an object");
    row("array is text", R"({"a":"x"})", "a text");
    row("array is null", R"({"a":null})", "null");
    row("unknown key", R"({"a":{"dtype":"U8","shape":[24],"data_offsets":[0,24],"x":1}})", "unknown key 'x'");
    row("no shape", R"({"a":{"dtype":"U8","data_offsets":[0,24]}})", "dtype, shape and data_offsets");
    row("negative", R"({"a":{"dtype":"U8","shape":[-24],"data_offsets":[0,24]}})", "negative");
    row("fraction", R"({"a":{"dtype":"U8","shape":[24.0],"data_offsets":[0,24]}})", "fraction");
    row("beyond 64 bits", R"({"a":{"dtype":"U8","shape":[99999999999999999999],"data_offsets":[0,24]}})", "fraction");
    row("three offsets", R"({"a":{"dtype":"U8","shape":[24],"data_offsets":[0,12,24]}})", "data_offsets");
    row("nested shape", R"({"a":{"dtype":"U8","shape":[[24]],"data_offsets":[0,24]}})", "a list");
    row("dtype list", R"({"a":{"dtype":["U8"],"shape":[24],"data_offsets":[0,24]}})", "a list");
    row("long shape", R"({"a":{"dtype":"U8","shape":[24,1,1,1,1,1,1,1,1],"data_offsets":[0,24]}})", "too long");
    row("unknown type", R"({"a":{"dtype":"F80","shape":[24],"data_offsets":[0,24]}})", "unknown type");
    row("shape overflow", R"({"a":{"dtype":"F64","shape":[4294967296,4294967296,3],"data_offsets":[0,24]}})",
        "impossible");
    row("shape too small", R"({"a":{"dtype":"U8","shape":[23],"data_offsets":[0,24]}})", "does not fit");
    row("backwards", R"({"a":{"dtype":"U8","shape":[24],"data_offsets":[24,0]}})", "does not fit");
    row("gap",
        R"({"a":{"dtype":"U8","shape":[8],"data_offsets":[0,8]},"b":{"dtype":"U8","shape":[8],"data_offsets":[16,24]}})",
        "gap");
    row("overlap",
        R"({"a":{"dtype":"U8","shape":[16],"data_offsets":[0,16]},"b":{"dtype":"U8","shape":[16],"data_offsets":[8,24]}})",
        "overlap");
    row("beyond the file", R"({"a":{"dtype":"U8","shape":[32],"data_offsets":[0,32]}})", "8 bytes are missing");
    row("bytes left over", R"({"a":{"dtype":"U8","shape":[16],"data_offsets":[0,16]}})", "8 bytes too many");
    row("deep", std::string(500000, '['), "no JSON object");
    row("deep inside", R"({"a":{"shape":)" + std::string(500000, '['), "a list");
  }
  void refusesWhatIsNoFlatHeader() {
    QFETCH(QByteArray, json);
    QFETCH(QString, word);
    const Result<test::ProjectorParts> parts = test::partsOf(fileOf(json.toStdString(), kData));
    QVERIFY(!parts);
    QVERIFY(parts.error().code == ErrorCode::kMalformed);
    QCOMPARE(parts.error().where, std::string("a.c2s"));
    QVERIFY2(QString::fromStdString(parts.error().message).contains(word), parts.error().message.c_str());
  }

  void lengthsThatLie() {
    for (const std::string& bytes : {std::string(), std::string(7, '\0'), std::string(8, '\xff'),
                                     std::string("\x40\0\0\0\0\0\0\0{}", 10), std::string("\0\0\x20\0\0\0\0\0", 8)}) {
      QVERIFY(!test::partsOf(bytes));
    }
  }

  void tooManyArraysAreRefused() {
    ProjectorHeader header;
    for (int k = 0; k < 1000; ++k) header.arrays[std::to_string(k) + "a"] = {"U8", {0}, 0, 0};
    QVERIFY(!test::partsOf(formatProjectorPrefix(header)));
  }
};

QTEST_APPLESS_MAIN(ProjectorHeaderTest)
#include "projector_header_test.moc"

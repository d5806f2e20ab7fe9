// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/strict_json.h"

#include <QtTest>

using namespace cad2slam;

class StrictJsonTest : public QObject {
  Q_OBJECT

 private slots:
  void readsWhatIsFine() {
    const auto document = parseStrictJson(R"({"a": [1, {"a": 2}, {"a": 3}], "b": {"a": null}})", "x.json");
    QVERIFY(document.has_value());
    QCOMPARE((*document)["a"][2]["a"].get<int>(), 3);
    QVERIFY(parseStrictJson(std::string(64, '[') + std::string(64, ']'), "x").has_value());
  }

  void refusesWhatHidesSomething_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("empty") << QByteArray() << "x.json:1: is not valid JSON";
    QTest::newRow("cut off") << QByteArray("{\n\"a\": [1,\n") << "x.json:3: is not valid JSON";
    QTest::newRow("two documents") << QByteArray("{}\n{}") << "x.json:2: is not valid JSON";
    QTest::newRow("twice") << QByteArray(R"([{"a": 1, "b": 2, "a": 1}])")
                           << "x.json: has the key 'a' twice in one object";
    QTest::newRow("zero byte") << QByteArray("{}\0{\"a\": 1}", 11) << "x.json: is no text: it holds zero bytes";
    QTest::newRow("no UTF-8") << QByteArray("[\"\xff\"]") << "x.json:1: is not valid JSON";
    QTest::newRow("too large a number") << QByteArray("[1e999]") << "x.json:1: is not valid JSON";
    QTest::newRow("deep") << QByteArray(1000000, '[') << "x.json: is nested too deeply";
    QTest::newRow("deep objects") << QByteArray("{\"a\":").repeated(100000) << "x.json: is nested too deeply";
  }
  void refusesWhatHidesSomething() {
    QFETCH(QByteArray, text);
    QFETCH(QString, sentence);
    const auto document = parseStrictJson(text.toStdString(), "x.json");
    QVERIFY(!document);
    QVERIFY(document.error().code == ErrorCode::kMalformed);
    QCOMPARE(QString::fromStdString(document.error().sentence()), sentence);
  }
};

QTEST_APPLESS_MAIN(StrictJsonTest)
#include "strict_json_test.moc"

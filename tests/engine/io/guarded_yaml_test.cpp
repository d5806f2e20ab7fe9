// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/guarded_yaml.h"

#include <QtTest>

using namespace cad2slam;

/// Every reader of YAML goes through this guard: what it lets pass is a tree no larger than its text.
class GuardedYamlTest : public QObject {
  Q_OBJECT
 private slots:
  void treesAreRead();
  void bombsAreRefused_data();
  void bombsAreRefused();
};

void GuardedYamlTest::treesAreRead() {
  const Result<YAML::Node> tree = loadYaml("a: [1, {b: x}]\nc: &name plain\nd: ~\n", "f.yaml");
  QVERIFY(tree);
  QCOMPARE((*tree)["a"][1]["b"].Scalar(), std::string("x"));
  QCOMPARE((*tree)["c"].Scalar(), std::string("plain"));
  QVERIFY((*tree)["d"].IsNull());
  QVERIFY(loadYaml("", "f.yaml")->IsNull());
  QVERIFY(loadYaml("a: " + std::string(31, '[') + std::string(31, ']'), "f.yaml"));
}

void GuardedYamlTest::bombsAreRefused_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("where");
  QTest::addColumn<QString>("why");
  const auto nested = [](int depth) { return "a:\n  " + QByteArray(depth, '[') + QByteArray(depth, ']') + "\n"; };
  QByteArray laughs = "a0: &a0 [x, x]\n";
  for (int k = 1; k < 30; ++k) {
    const QByteArray name = QByteArray::number(k);
    const QByteArray before = "*a" + QByteArray::number(k - 1);
    laughs += "a" + name + ": &a" + name + " [" + before + ", " + before + "]\n";
  }
  QTest::newRow("a billion laughs") << laughs << "f.yaml:2"
                                    << "aliases";
  QTest::newRow("a list in itself") << QByteArray("a: &a [*a]\n") << "f.yaml:1"
                                    << "aliases";
  QTest::newRow("one list too deep") << nested(32) << "f.yaml:2"
                                     << "nested";
  QTest::newRow("very deep lists") << nested(100'000) << "f.yaml:2"
                                   << "nested";
  QTest::newRow("deep maps") << QByteArray("{a: ").repeated(50'000) << "f.yaml:1"
                             << "nested";
  QTest::newRow("deep dashes") << QByteArray("- ").repeated(50'000) + "x"
                               << "f.yaml:1"
                               << "nested";
  QTest::newRow("deep complex keys") << QByteArray("? ").repeated(50'000) << "f.yaml:1"
                                     << "nested";
  QTest::newRow("not YAML") << QByteArray("a: 1\nb: [1, 2\n") << "f.yaml:"
                            << "is not valid YAML";
}

void GuardedYamlTest::bombsAreRefused() {
  QFETCH(QByteArray, text);
  QFETCH(QString, where);
  QFETCH(QString, why);
  const Result<YAML::Node> tree = loadYaml(text.toStdString(), "f.yaml");
  QVERIFY(!tree);
  QVERIFY2(QString::fromStdString(tree.error().where).startsWith(where), tree.error().where.c_str());
  QVERIFY2(QString::fromStdString(tree.error().message).contains(why), tree.error().message.c_str());
}

QTEST_APPLESS_MAIN(GuardedYamlTest)
#include "guarded_yaml_test.moc"

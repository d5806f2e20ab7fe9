// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/map_yaml.h"

#include <QtTest>

#include <random>

#include "support/temporary_folder.h"

using namespace cad2slam;

namespace {

const std::string kGood =
    "image: map.pgm\nresolution: 0.05\norigin: [-1.5, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// The good text with one line replaced.
std::string with(const std::string& key, const std::string& line) {
  std::string text = kGood;
  const std::size_t begin = text.find(key + ":");
  text.replace(begin, text.find('\n', begin) - begin, line);
  return text;
}

bool sameMetadata(const MapMetadata& a, const MapMetadata& b) {
  return a.image == b.image && a.resolution_m_per_px == b.resolution_m_per_px &&
         a.metric_from_corner.translation == b.metric_from_corner.translation &&
         a.metric_from_corner.heading == b.metric_from_corner.heading && a.occupied_threshold == b.occupied_threshold &&
         a.free_threshold == b.free_threshold && a.negate == b.negate && a.mode == b.mode;
}

}  // namespace

class MapYamlTest : public QObject {
  Q_OBJECT

 private slots:
  void readsAMapServerFile() {
    const Result<MapYaml> read = parseMapYaml(kGood, "site/map.yaml");
    QVERIFY2(read, read ? "" : read.error().sentence().c_str());
    QCOMPARE(read->metadata.image.string(), std::string("site/map.pgm"));
    QCOMPARE(read->metadata.resolution_m_per_px, 0.05);
    QCOMPARE(read->metadata.metric_from_corner.translation.x(), -1.5);
    QCOMPARE(read->metadata.metric_from_corner.translation.y(), 2.0);
    QCOMPARE(read->metadata.metric_from_corner.heading, 0.0);
    QCOMPARE(read->metadata.occupied_threshold, 0.65);
    QCOMPARE(read->metadata.free_threshold, 0.196);
    QVERIFY(!read->metadata.negate);
    QVERIFY(read->metadata.mode == MapMode::kTrinary);
    QVERIFY(read->warnings.empty());
  }

  void readsOtherWaysToSayIt() {
    QCOMPARE(parseMapYaml(with("image", "image: /maps/a.png"), "site/map.yaml")->metadata.image.string(),
             std::string("/maps/a.png"));
    QCOMPARE(parseMapYaml(with("image", "image: 'a b.png' # plan"), "map.yaml")->metadata.image.string(),
             std::string("a b.png"));
    QVERIFY(parseMapYaml(with("negate", "negate: true"), "map.yaml")->metadata.negate);
    QVERIFY(parseMapYaml(with("negate", "negate: 1"), "map.yaml")->metadata.negate);
    QVERIFY(parseMapYaml(kGood + "mode: raw\n", "map.yaml")->metadata.mode == MapMode::kRaw);
    QVERIFY(parseMapYaml(kGood + "mode: scale\n", "map.yaml")->metadata.mode == MapMode::kScale);
    QVERIFY(parseMapYaml(with("origin", "origin:\n  - -1.5\n  - 2\n  - 0\n"), "map.yaml").has_value());
    QVERIFY(parseMapYaml("%YAML 1.1\n---\n" + kGood + "...\n", "map.yaml").has_value());
    QVERIFY(parseMapYaml(kGood + "voxels: {a: [1, {b: 2}], c: ~}\nfloor: EG\n", "map.yaml").has_value());
  }

  void yawIsReadAndSaid() {
    const Result<MapYaml> turned = parseMapYaml(with("origin", "origin: [0, 0, 0.5]"), "map.yaml");
    QCOMPARE(turned->metadata.metric_from_corner.heading, 0.5);
    QCOMPARE(turned->warnings.size(), std::size_t{1});
    for (const char* nan : {".nan", "-.nan", "nan", "-nan", ".NaN"}) {  // stands in files of the wild
      const Result<MapYaml> odd = parseMapYaml(with("origin", std::string("origin: [0, 0, ") + nan + "]"), "map.yaml");
      QVERIFY(odd.has_value());
      QCOMPARE(odd->metadata.metric_from_corner.heading, 0.0);
      QCOMPARE(odd->warnings.size(), std::size_t{1});
    }
  }

  void errorsNameFileLineAndKey_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("where");
    QTest::addColumn<QString>("word");
    const auto row = [](const char* name, const std::string& text, const char* where, const char* word) {
      QTest::newRow(name) << QByteArray::fromStdString(text) << where << word;
    };
    row("empty", "", "m.yaml", "holds no map");
    row("no map", "hello", "m.yaml:1", "image: map.pgm");
    row("list", "- 1\n- 2\n", "m.yaml:1", "image: map.pgm");
    row("not YAML", "image: [\n", "m.yaml:2", "YAML");
    row("missing", with("resolution", "# nothing"), "m.yaml", "resolution is missing");
    row("no negate", with("negate", ""), "m.yaml", "negate is missing");
    row("empty image", with("image", "image: ''"), "m.yaml:1", "image");
    row("image list", with("image", "image: [a]"), "m.yaml:1", "image");
    row("zero byte in image", with("image", "image: \"a\\0b\""), "m.yaml:1", "image");
    row("word resolution", with("resolution", "resolution: fine"), "m.yaml:2", "resolution");
    row("zero resolution", with("resolution", "resolution: 0"), "m.yaml:2", "resolution");
    row("negative resolution", with("resolution", "resolution: -0.05"), "m.yaml:2", "resolution");
    row("NaN resolution", with("resolution", "resolution: .nan"), "m.yaml:2", "resolution");
    row("infinite resolution", with("resolution", "resolution: .inf"), "m.yaml:2", "resolution");
    row("two numbers", with("origin", "origin: [0, 0]"), "m.yaml:3", "origin");
    row("nested origin", with("origin", "origin: [0, 0, [0]]"), "m.yaml:3", "origin");
    row("NaN x", with("origin", "origin: [.nan, 0, 0]"), "m.yaml:3", "origin");
    row("infinite yaw", with("origin", "origin: [0, 0, .inf]"), "m.yaml:3", "origin");
    row("negate word", with("negate", "negate: maybe"), "m.yaml:4", "negate");
    row("threshold beyond 1", with("occupied_thresh", "occupied_thresh: 65"), "m.yaml:5", "occupied_thresh");
    row("thresholds crossed", with("free_thresh", "free_thresh: 0.7"), "m.yaml:6", "free_thresh");
    row("unknown mode", kGood + "mode: Trinary\n", "m.yaml:7", "mode");
    row("key twice", kGood + "image: b.pgm\n", "m.yaml:7", "already stands in line 1");
    row("list as key", "? [a, b]\n: c\n", "m.yaml:1", "key");
    row("alias", "image: &a x\nresolution: *a\n", "m.yaml:2", "alias");
    row("deep lists", "a: " + std::string(10000, '['), "m.yaml:1", "nested");
    row(
        "deep dashes",
        "a:\n - " +
            [] {
              std::string s;
              for (int k = 0; k < 9000; ++k) s += "- ";
              return s;
            }() +
            "x",
        "m.yaml:2", "nested");
    row("too large", kGood + std::string(70000, '#'), "m.yaml", "too large");
  }
  void errorsNameFileLineAndKey() {
    QFETCH(QByteArray, text);
    QFETCH(QString, where);
    QFETCH(QString, word);
    const Result<MapYaml> read = parseMapYaml(text.toStdString(), "m.yaml");
    QVERIFY(!read);
    QVERIFY(read.error().code == ErrorCode::kMalformed);
    QCOMPARE(QString::fromStdString(read.error().where), where);
    QVERIFY2(QString::fromStdString(read.error().message).contains(word), read.error().message.c_str());
  }

  void cutAnywhereItIsAnErrorOrTheSame() {
    for (std::size_t length = 0; length < kGood.size(); ++length) {
      const Result<MapYaml> read = parseMapYaml(kGood.substr(0, length), "m.yaml");
      if (read) QCOMPARE(read->metadata.resolution_m_per_px, 0.05);  // only the last threshold may have lost digits
    }
  }

  void whatIsWrittenIsRead() {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const std::vector<std::string> names{"map.pgm", "a b.png", "t\xc3\xbcr: #1.png", "\"q\"\\.png", "true", "~",
                                         "1.5",     "-x"};
    for (int k = 0; k < 500; ++k) {
      MapMetadata metadata;
      metadata.yaml = "folder/map.yaml";
      metadata.image = std::filesystem::path("folder") / names[static_cast<std::size_t>(k) % names.size()];
      metadata.resolution_m_per_px = std::exp(12.0 * unit(random) - 9.0);
      metadata.metric_from_corner = {{1e8 * (unit(random) - 0.5), 1e-8 * unit(random)}, unit(random)};
      metadata.occupied_threshold = unit(random);
      metadata.free_threshold = metadata.occupied_threshold * unit(random);
      metadata.negate = k % 2 == 0;
      metadata.mode = static_cast<MapMode>(k % 3);
      const std::string text = formatMapYaml(metadata, names[static_cast<std::size_t>(k) % names.size()]);
      const Result<MapYaml> read = parseMapYaml(text, metadata.yaml);
      QVERIFY2(read, read ? "" : (text + read.error().sentence()).c_str());
      QVERIFY(sameMetadata(read->metadata, metadata));
    }
  }

  void missingFilesAndFolders() {
    const test::TemporaryFolder folder;
    QVERIFY(readMapYaml(folder.path("none.yaml")).error().code == ErrorCode::kNotFound);
    QVERIFY(readMapYaml(folder.path()).error().code == ErrorCode::kUnreadable);
    QCOMPARE(readMapYaml(folder.write("m.yaml", kGood))->metadata.image, folder.path("map.pgm"));
  }
};

QTEST_APPLESS_MAIN(MapYamlTest)
#include "map_yaml_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/pixel_classifier.h"

#include <opencv2/core.hpp>

#include <QtTest>

using namespace cad2slam;

namespace {

constexpr CellState F = CellState::kFree;
constexpr CellState O = CellState::kOccupied;
constexpr CellState U = CellState::kUnknown;

PixelRules rulesOf(MapSemantics semantics, MapMode mode = MapMode::kTrinary) {
  PixelRules rules;
  rules.semantics = semantics;
  rules.mode = mode;
  return rules;
}

struct Classified {
  CellState first;
  cv::Mat states;
  PixelNotes notes;
};

Classified classified(const cv::Mat& picture, const PixelRules& rules) {
  const auto classifier = PixelClassifier::create(picture.type(), rules);
  if (!classifier) return {static_cast<CellState>(99), {}, {}};
  const cv::Mat states = (*classifier)->classify(picture);
  return {static_cast<CellState>(states.at<std::uint8_t>(0, 0)), states, (*classifier)->notes()};
}

CellState stateOf(const cv::Mat& pixel, const PixelRules& rules) {
  return classified(pixel, rules).first;
}

cv::Mat grey(int value) {
  return cv::Mat(1, 1, CV_8UC1, cv::Scalar(value));
}
cv::Mat bgra(int blue, int green, int red, int alpha) {
  return cv::Mat(1, 1, CV_8UC4, cv::Scalar(blue, green, red, alpha));
}

}  // namespace

Q_DECLARE_METATYPE(cv::Mat)
Q_DECLARE_METATYPE(cad2slam::CellState)
Q_DECLARE_METATYPE(cad2slam::MapMode)

class PixelClassifierTest : public QObject {
  Q_OBJECT

 private slots:
  void pixelsReadAsBothServersReadThem_data() {
    QTest::addColumn<cv::Mat>("pixel");
    QTest::addColumn<MapMode>("mode");
    QTest::addColumn<bool>("negate");
    QTest::addColumn<CellState>("jazzy");
    QTest::addColumn<CellState>("humble");
    const auto row = [](const char* name, const cv::Mat& pixel, MapMode mode, bool negate, CellState jazzy,
                        CellState humble) { QTest::newRow(name) << pixel << mode << negate << jazzy << humble; };
    const MapMode trinary = MapMode::kTrinary;
    const MapMode scale = MapMode::kScale;
    const MapMode raw = MapMode::kRaw;
    row("saver free", grey(254), trinary, false, F, F);
    row("saver occupied", grey(0), trinary, false, O, O);
    row("saver unknown", grey(205), trinary, false, U, U);
    row("negated free", grey(0), trinary, true, F, F);
    row("negated occupied", grey(255), trinary, true, O, O);
    row("between in scale", grey(150), scale, false, U, U);
    row("white in scale", grey(255), scale, false, F, F);
    // Colour: luminance of pure green is 149, the mean of its channels 85.
    row("green", bgra(0, 255, 0, 255), scale, false, U, O);
    row("blue", bgra(255, 0, 0, 255), scale, false, O, O);
    // Alpha: jazzy calls anything not opaque unknown; humble takes it as a fourth grey channel in trinary mode.
    row("opaque black", bgra(0, 0, 0, 255), trinary, false, O, O);
    row("opaque grey", bgra(60, 60, 60, 255), trinary, false, O, U);
    row("clear black", bgra(0, 0, 0, 0), trinary, false, U, O);
    row("clear white", bgra(255, 255, 255, 0), trinary, false, U, U);
    row("nearly opaque white", bgra(255, 255, 255, 254), trinary, false, U, F);
    row("clear white in scale", bgra(255, 255, 255, 0), scale, false, U, U);
    row("nearly opaque in scale", bgra(0, 0, 0, 254), scale, false, U, U);
    // Raw: the value is the occupancy in percent; negate and alpha do not count.
    row("raw 0", grey(0), raw, false, F, F);
    row("raw 19", grey(19), raw, true, F, F);
    row("raw 50", grey(50), raw, false, U, U);
    row("raw 100", grey(100), raw, true, O, O);
    row("raw 101", grey(101), raw, false, U, U);
    row("raw 255", grey(255), raw, false, U, U);
    row("raw clear", bgra(0, 0, 0, 0), raw, false, F, F);
  }
  void pixelsReadAsBothServersReadThem() {
    QFETCH(cv::Mat, pixel);
    QFETCH(MapMode, mode);
    QFETCH(bool, negate);
    QFETCH(CellState, jazzy);
    QFETCH(CellState, humble);
    for (const auto& [semantics, expected] :
         {std::pair(MapSemantics::kJazzy, jazzy), {MapSemantics::kHumble, humble}}) {
      PixelRules rules = rulesOf(semantics, mode);
      rules.negate = negate;
      QVERIFY(stateOf(pixel, rules) == expected);
      QCOMPARE(classified(pixel, rules).notes.read_differently, std::size_t{jazzy != humble ? 1U : 0U});
      // 16 bits say the same as 8, and grey the same as grey in three channels.
      cv::Mat wide;
      pixel.convertTo(wide, CV_16U, 257.0);
      QVERIFY(stateOf(wide, rules) == expected);
      if (pixel.channels() == 1) {
        cv::Mat colour;
        cv::merge(std::vector<cv::Mat>{pixel, pixel, pixel}, colour);
        QVERIFY(stateOf(colour, rules) == expected);
      }
    }
  }

  void aValueOnAThresholdBelongsToItOnlyInJazzy() {
    PixelRules rules = rulesOf(MapSemantics::kJazzy);
    rules.occupied_threshold = 0.6;  // 102 is 0.6 exactly
    rules.free_threshold = 0.0;
    QVERIFY(stateOf(grey(102), rules) == O);
    QVERIFY(stateOf(grey(255), rules) == F);
    rules.semantics = MapSemantics::kHumble;
    QVERIFY(stateOf(grey(102), rules) == U);
    QVERIFY(stateOf(grey(255), rules) == U);
  }

  void equalThresholdsDecideTheTie() {
    PixelRules rules = rulesOf(MapSemantics::kJazzy);
    rules.occupied_threshold = rules.free_threshold = 1.0;
    QVERIFY(stateOf(grey(0), rules) == F);  // free wins
  }

  void brightnessIsRelativeToTheMaximum() {
    PixelRules rules = rulesOf(MapSemantics::kJazzy);
    rules.full_brightness = 100;
    QVERIFY(stateOf(grey(100), rules) == F);
    QVERIFY(stateOf(grey(30), rules) == O);
    QVERIFY(stateOf(grey(60), rules) == U);
  }

  void unknownCountedAsFreeIsNoticed() {
    PixelRules rules = rulesOf(MapSemantics::kJazzy);
    QVERIFY(!classified(grey(205), rules).notes.grey_205_is_free);
    rules.free_threshold = 0.25;
    QVERIFY(classified(grey(205), rules).notes.grey_205_is_free);
    QVERIFY(classified(bgra(205, 205, 205, 255), rules).notes.grey_205_is_free);
    QVERIFY(!classified(grey(204), rules).notes.grey_205_is_free);
  }

  void piecesSayWhatTheWholeSays() {
    for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1, CV_16UC4}) {
      cv::Mat picture(31, 17, type);
      cv::randu(picture, 0, CV_MAT_DEPTH(type) == CV_8U ? 256 : 65536);
      for (const MapSemantics semantics : {MapSemantics::kJazzy, MapSemantics::kHumble}) {
        PixelRules rules = rulesOf(semantics);
        rules.free_threshold = 0.25;
        const cv::Mat before = picture.clone();
        const Classified whole = classified(picture, rules);
        QCOMPARE(cv::norm(before, picture, cv::NORM_INF), 0.0);  // what a caller gave is not written to
        const auto classifier = PixelClassifier::create(type, rules);
        QVERIFY(classifier.has_value());
        cv::Mat states;
        for (int row = 0; row < picture.rows; row += 7) {
          const cv::Mat piece = picture.rowRange(row, std::min(picture.rows, row + 7));
          states.push_back((*classifier)->classify(piece));
        }
        QCOMPARE(cv::norm(states, whole.states, cv::NORM_INF), 0.0);
        QCOMPARE((*classifier)->notes().read_differently, whole.notes.read_differently);
        QCOMPARE((*classifier)->notes().grey_205_is_free, whole.notes.grey_205_is_free);
      }
    }
  }

  void otherPixelTypesAreRefused() {
    for (const int type : {CV_32FC1, CV_8SC1, CV_8UC2, CV_64FC3}) {
      QVERIFY(!PixelClassifier::create(type, rulesOf(MapSemantics::kJazzy)));
    }
  }
};

QTEST_APPLESS_MAIN(PixelClassifierTest)
#include "pixel_classifier_test.moc"

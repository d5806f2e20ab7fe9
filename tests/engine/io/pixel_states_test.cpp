// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/pixel_states.h"

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

CellState stateOf(const cv::Mat& pixel, const PixelRules& rules) {
  const Result<PixelStates> result = classifyPixels(pixel.clone(), rules);
  return result ? static_cast<CellState>(result->states.at<std::uint8_t>(0, 0)) : static_cast<CellState>(99);
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

class PixelStatesTest : public QObject {
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
      const Result<PixelStates> result = classifyPixels(pixel.clone(), rules);
      QCOMPARE(result->read_differently, std::size_t{jazzy != humble ? 1U : 0U});
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
    QVERIFY(!classifyPixels(grey(205), rules)->grey_205_is_free);
    rules.free_threshold = 0.25;
    QVERIFY(classifyPixels(grey(205), rules)->grey_205_is_free);
    QVERIFY(classifyPixels(bgra(205, 205, 205, 255), rules)->grey_205_is_free);
    QVERIFY(!classifyPixels(grey(204), rules)->grey_205_is_free);
  }

  void greyIsClassifiedInPlaceUnlessShared() {
    cv::Mat mine(4, 5, CV_8UC1, cv::Scalar(254));
    const std::uint8_t* pixels = mine.data;
    const cv::Mat shared(4, 5, CV_8UC1, cv::Scalar(254));
    const Result<PixelStates> moved = classifyPixels(std::move(mine), rulesOf(MapSemantics::kJazzy));
    QVERIFY(moved->states.data == pixels);
    const Result<PixelStates> copied = classifyPixels(shared, rulesOf(MapSemantics::kJazzy));
    QVERIFY(copied->states.data != shared.data);
    QCOMPARE(int{shared.at<std::uint8_t>(3, 4)}, 254);
  }

  void otherPixelTypesAreRefused() {
    for (const int type : {CV_32FC1, CV_8SC1, CV_8UC2, CV_64FC3}) {
      QVERIFY(!classifyPixels(cv::Mat(1, 1, type, cv::Scalar::all(0)), rulesOf(MapSemantics::kJazzy)));
    }
    QVERIFY(!classifyPixels(cv::Mat(), rulesOf(MapSemantics::kJazzy)));
  }
};

QTEST_APPLESS_MAIN(PixelStatesTest)
#include "pixel_states_test.moc"

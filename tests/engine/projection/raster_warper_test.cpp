// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/projection/raster_warper.h"

#include <QtTest>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "cad2slam/geometry/similarity2.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

constexpr int kWidth_px = 240;
constexpr int kHeight_px = 160;

/// A projector over tiles of 1 m that cover `width` x `height` m from (0, 0) upwards, whose nodes follow `warp`.
template <class Warp>
Projector projectorOf(int width, int height, const Warp& warp, double scale = 1.0) {
  ProjectorData data;
  data.info.scale = scale;
  for (std::int32_t row = 0; row < height; ++row) {
    for (std::int32_t column = 0; column < width; ++column) {
      const Vector2d center(column + 0.5, row + 0.5);
      data.node_tile.push_back({column, row});
      data.node_blueprint.push_back(center);
      data.node_slam.push_back(warp(center));
      data.node_stretch.emplace_back(0.0, 0.0);
    }
  }
  return *Projector::create(data);
}

Projector identity() {
  return projectorOf(24, 16, [](const Vector2d& center) { return Pose2{center, 0.0}; });
}

Projector bent() {
  return projectorOf(24, 16, [](const Vector2d& p) {
    return Pose2{{p.x() + 0.6 * std::sin(0.35 * p.y()), p.y() + 0.5 * std::cos(0.3 * p.x())}, 0.0};
  });
}

MapFrame frameOf(int width_px, int height_px, double resolution = 0.1, const Pose2& origin = {}) {
  return *MapFrame::create(resolution, width_px, height_px, origin);
}

/// A smooth picture, so that interpolation is no matter, in 1, 3 or 4 channels of 8 or 16 bits.
cv::Mat smoothPicture(int type) {
  cv::Mat_<double> waves(kHeight_px, kWidth_px);
  for (int row = 0; row < kHeight_px; ++row) {
    for (int column = 0; column < kWidth_px; ++column) {
      waves(row, column) = 0.5 + 0.25 * std::sin(0.05 * column) + 0.25 * std::cos(0.07 * row);
    }
  }
  std::vector<cv::Mat> channels;
  const double largest = CV_MAT_DEPTH(type) == CV_16U ? 65535.0 : 255.0;
  for (int channel = 0; channel < CV_MAT_CN(type); ++channel) {
    cv::Mat scaled;
    waves.convertTo(scaled, CV_MAT_DEPTH(type), largest / (channel + 1));
    channels.push_back(scaled);
  }
  cv::Mat picture;
  cv::merge(channels, picture);
  return picture;
}

/// The position of each pixel in both 16 bit channels, in 1/64 pixel: a look-up table made visible.
cv::Mat coordinatePicture(int width_px, int height_px) {
  cv::Mat picture(height_px, width_px, CV_16UC2);
  for (int row = 0; row < height_px; ++row) {
    for (int column = 0; column < width_px; ++column) {
      picture.at<cv::Vec2w>(row, column) = {static_cast<std::uint16_t>(64 * column + 32),
                                            static_cast<std::uint16_t>(64 * row + 32)};
    }
  }
  return picture;
}

double meanDifference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(a.total() * static_cast<std::size_t>(a.channels()));
}

}  // namespace

class RasterWarperTest : public QObject {
  Q_OBJECT
 private slots:
  void identityReproducesThePicture_data() { types(); }
  void identityReproducesThePicture();
  void similarityEqualsWarpAffine_data() { types(); }
  void similarityEqualsWarpAffine();
  void everyPixelIsLookedUpRight_data() { directions(); }
  void everyPixelIsLookedUpRight();
  void thereAndBackIsTheStart();
  void turnedFramesAreRespected();
  void beyondTheReachIsOutside_data() { directions(); }
  void beyondTheReachIsOutside();
  void nearestNeighbourMixesNothing();
  void extentHoldsEverythingDrawn_data() { directions(); }
  void extentHoldsEverythingDrawn();
  void refusals();

 private:
  static void types();
  static void directions();
};

void RasterWarperTest::types() {
  QTest::addColumn<int>("type");
  QTest::newRow("8 bit grey") << CV_8UC1;
  QTest::newRow("8 bit colour") << CV_8UC3;
  QTest::newRow("8 bit colour and alpha") << CV_8UC4;
  QTest::newRow("16 bit grey") << CV_16UC1;
  QTest::newRow("16 bit colour") << CV_16UC3;
}

void RasterWarperTest::directions() {
  QTest::addColumn<WarpDirection>("direction");
  QTest::newRow("to SLAM") << WarpDirection::kToSlam;
  QTest::newRow("to blueprint") << WarpDirection::kToBlueprint;
}

void RasterWarperTest::identityReproducesThePicture() {
  QFETCH(int, type);
  const cv::Mat picture = smoothPicture(type);
  const MapFrame frame = frameOf(kWidth_px, kHeight_px);
  for (const WarpDirection direction : {WarpDirection::kToSlam, WarpDirection::kToBlueprint}) {
    for (const bool smooth : {true, false}) {
      WarpOptions options;
      options.smooth = smooth;
      const Result<cv::Mat> warped = warpRaster(identity(), direction, picture, frame, frame, options);
      QVERIFY(warped.has_value());
      QCOMPARE(warped->type(), type);
      QCOMPARE(cv::norm(*warped, picture, cv::NORM_INF), 0.0);
    }
  }
}

void RasterWarperTest::similarityEqualsWarpAffine() {
  QFETCH(int, type);
  const cv::Mat picture = smoothPicture(type);
  const Similarity2 truth{1.2, 0.5, {9.0, -2.0}};
  const Projector projector = projectorOf(
      24, 16,
      [&](const Vector2d& center) {
        return truth * Pose2{center, 0.0};
      },
      truth.scale);
  const MapFrame source = frameOf(kWidth_px, kHeight_px);
  const MapFrame target = frameOf(300, 320, 0.1, {{1.0, -2.0}, 0.0});
  WarpOptions options;
  options.outside_value = cv::Scalar::all(7);
  const Result<cv::Mat> warped = warpRaster(projector, WarpDirection::kToSlam, picture, source, target, options);
  QVERIFY(warped.has_value());
  // The same map between pixel centres, from three points of it.
  cv::Point2f from[3];
  cv::Point2f to[3];
  const Vector2d pixels[3] = {{0.0, 0.0}, {100.0, 0.0}, {0.0, 100.0}};
  for (int k = 0; k < 3; ++k) {
    const Vector2d there = target.pixelFromMetric(truth * source.metricFromPixel(pixels[k]));
    from[k] = {static_cast<float>(pixels[k].x() - 0.5), static_cast<float>(pixels[k].y() - 0.5)};
    to[k] = {static_cast<float>(there.x() - 0.5), static_cast<float>(there.y() - 0.5)};
  }
  cv::Mat expected;
  cv::warpAffine(picture, expected, cv::getAffineTransform(from, to), {target.width(), target.height()},
                 cv::INTER_LINEAR, cv::BORDER_CONSTANT, options.outside_value);
  // One part in a thousand of white: two ways to round the look-up and one border.
  const double white = picture.depth() == CV_16U ? 65535.0 : 255.0;
  QVERIFY(meanDifference(*warped, expected) < 1e-3 * white);
  QVERIFY(cv::mean(expected)[0] > 0.1 * white);
}

void RasterWarperTest::everyPixelIsLookedUpRight() {
  QFETCH(WarpDirection, direction);
  const bool to_slam = direction == WarpDirection::kToSlam;
  const Projector projector = bent();
  const MapFrame source = frameOf(kWidth_px, kHeight_px);
  const MapFrame target = frameOf(310, 231, 0.09, {{-1.5, -2.0}, 0.0});
  WarpOptions options;
  options.outside_value = cv::Scalar::all(0);
  options.reach_m = 0.0;
  const Result<cv::Mat> warped =
      warpRaster(projector, direction, coordinatePicture(kWidth_px, kHeight_px), source, target, options);
  QVERIFY(warped.has_value());
  int checked = 0;
  for (int row = 0; row < target.height(); ++row) {
    for (int column = 0; column < target.width(); ++column) {
      const Pose2 place{target.metricFromPixel({column + 0.5, row + 0.5}), 0.0};
      const Projection there = to_slam ? projector.blueprintFromSlam(place, OutsidePolicy::kError)
                                       : projector.slamFromBlueprint(place, OutsidePolicy::kError);
      if (!there.ok()) continue;
      const Vector2d exact = source.pixelFromMetric(there.pose.translation);
      // At the rim of the source, bilinear look-ups mix with the outside value.
      if ((exact.array() < 1.0).any() || exact.x() > kWidth_px - 1.0 || exact.y() > kHeight_px - 1.0) continue;
      const cv::Vec2w found = warped->at<cv::Vec2w>(row, column);
      const Vector2d looked_up(found[0] / 64.0, found[1] / 64.0);
      // A quarter pixel, and the steps of cv::remap (1/32) and of the picture (1/64).
      QVERIFY2((looked_up - exact).cwiseAbs().maxCoeff() < 0.25 + 0.05,
               qPrintable(QString("pixel %1 %2: %3 %4 instead of %5 %6")
                              .arg(column)
                              .arg(row)
                              .arg(looked_up.x())
                              .arg(looked_up.y())
                              .arg(exact.x())
                              .arg(exact.y())));
      ++checked;
    }
  }
  QVERIFY(checked > 30000);
}

void RasterWarperTest::thereAndBackIsTheStart() {
  const cv::Mat picture = smoothPicture(CV_8UC1);
  const MapFrame frame = frameOf(kWidth_px, kHeight_px);
  const MapFrame roomy = frameOf(320, 240, 0.1, {{-4.0, -4.0}, 0.0});
  const Projector projector = bent();
  const Result<cv::Mat> there = warpRaster(projector, WarpDirection::kToSlam, picture, frame, roomy);
  QVERIFY(there.has_value());
  const Result<cv::Mat> back = warpRaster(projector, WarpDirection::kToBlueprint, *there, roomy, frame);
  QVERIFY(back.has_value());
  QVERIFY(meanDifference(*back, picture) < 1.0);
}

void RasterWarperTest::turnedFramesAreRespected() {
  // The same raster, but its YAML says that it lies turned and shifted: with the identity it is only redrawn.
  const cv::Mat picture = smoothPicture(CV_8UC1);
  const MapFrame turned = frameOf(kWidth_px, kHeight_px, 0.1, {{16.0, 0.0}, 0.5 * kPi});
  const MapFrame upright = frameOf(kHeight_px, kWidth_px);
  const Projector projector = projectorOf(16, 24, [](const Vector2d& center) { return Pose2{center, 0.0}; });
  const Result<cv::Mat> warped = warpRaster(projector, WarpDirection::kToSlam, picture, turned, upright);
  QVERIFY(warped.has_value());
  cv::Mat expected;
  cv::rotate(picture, expected, cv::ROTATE_90_COUNTERCLOCKWISE);
  QVERIFY(cv::norm(*warped, expected, cv::NORM_INF) <= 1.0);
}

void RasterWarperTest::beyondTheReachIsOutside() {
  QFETCH(WarpDirection, direction);
  // The mesh covers 6 x 6 m in the middle of a white raster.
  const Projector projector = projectorOf(6, 6, [](const Vector2d& center) { return Pose2{center, 0.0}; });
  const MapFrame frame = frameOf(200, 200, 0.1, {{-7.0, -7.0}, 0.0});
  const cv::Mat white(200, 200, CV_8UC1, cv::Scalar(255));
  for (const double reach_m : {0.0, 0.7, 3.0}) {
    WarpOptions options;
    options.outside_value = cv::Scalar::all(33);
    options.reach_m = reach_m;
    const cv::Mat warped = *warpRaster(projector, direction, white, frame, frame, options);
    for (int row = 0; row < 200; ++row) {
      for (int column = 0; column < 200; ++column) {
        const double distance = projector.distanceToMesh(frame.metricFromPixel({column + 0.5, row + 0.5}));
        const int value = warped.at<std::uint8_t>(row, column);
        if (distance < reach_m - 1e-6) QCOMPARE(value, 255);
        if (distance > reach_m + 1e-6) QCOMPARE(value, 33);
      }
    }
  }
}

void RasterWarperTest::nearestNeighbourMixesNothing() {
  cv::Mat checks(kHeight_px, kWidth_px, CV_8UC1);
  for (int row = 0; row < kHeight_px; ++row) {
    for (int column = 0; column < kWidth_px; ++column) {
      checks.at<std::uint8_t>(row, column) = (row + column) % 2 == 0 ? 0 : 254;
    }
  }
  const MapFrame frame = frameOf(kWidth_px, kHeight_px);
  WarpOptions options;
  options.smooth = false;
  const cv::Mat warped = *warpRaster(bent(), WarpDirection::kToSlam, checks, frame, frame, options);
  for (int row = 0; row < kHeight_px; ++row) {
    for (int column = 0; column < kWidth_px; ++column) {
      const int value = warped.at<std::uint8_t>(row, column);
      QVERIFY(value == 0 || value == 254 || value == 205);
    }
  }
}

void RasterWarperTest::extentHoldsEverythingDrawn() {
  QFETCH(WarpDirection, direction);
  const Projector projector = bent();
  const MapFrame source = frameOf(kWidth_px, kHeight_px);
  const Result<MapFrame> extent = warpedExtent(projector, direction, source, 0.2);
  QVERIFY(extent.has_value());
  QCOMPARE(extent->resolution(), 0.2);
  // A frame wider by a metre on each side shows nothing that the extent cuts off.
  const MapFrame wider = frameOf(extent->width() + 10, extent->height() + 10, 0.2,
                                 {extent->metricFromCorner().translation - Vector2d(1.0, 1.0), 0.0});
  const cv::Mat white(kHeight_px, kWidth_px, CV_8UC1, cv::Scalar(255));
  WarpOptions options;
  options.outside_value = cv::Scalar::all(0);
  const cv::Mat whole = *warpRaster(projector, direction, white, source, wider, options);
  const cv::Mat inner = whole(cv::Rect(5, 5, extent->width(), extent->height()));
  QCOMPARE(cv::countNonZero(whole), cv::countNonZero(inner));
  QVERIFY(cv::countNonZero(whole) > 5000);
}

void RasterWarperTest::refusals() {
  const MapFrame frame = frameOf(kWidth_px, kHeight_px);
  const cv::Mat picture = smoothPicture(CV_8UC1);
  const auto codeOf = [](const auto& result) {
    return result.has_value() ? std::optional<ErrorCode>() : std::optional(result.error().code);
  };
  const MapFrame other = frameOf(10, 10);
  QVERIFY(codeOf(warpRaster(identity(), WarpDirection::kToSlam, picture, other, frame)) == ErrorCode::kOutOfDomain);
  const MapFrame huge = frameOf(40'000, 10);
  QVERIFY(codeOf(warpRaster(identity(), WarpDirection::kToSlam, picture, frame, huge)) == ErrorCode::kOutOfDomain);
  for (const double resolution : {0.0, -1.0, std::nan(""), 1e-9}) {
    QVERIFY(codeOf(warpedExtent(identity(), WarpDirection::kToSlam, frame, resolution)) == ErrorCode::kOutOfDomain);
  }
  // The mesh lies nowhere on this raster.
  const MapFrame elsewhere = frameOf(100, 100, 0.1, {{500.0, 500.0}, 0.0});
  QVERIFY(codeOf(warpedExtent(identity(), WarpDirection::kToSlam, elsewhere, 0.1)) == ErrorCode::kDegenerate);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::RasterWarperTest)
#include "raster_warper_test.moc"

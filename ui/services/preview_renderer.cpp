// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/preview_renderer.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "ui/services/ink.h"
#include "ui/views/mesh_layer.h"
#include "ui/views/raster_layer.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

constexpr int kLargestPatch_px = 6000;  // of a side; larger ones are read from a coarser level
constexpr int kProbes = 24;             // places along each side of a view where the warp is looked at
constexpr int kHeatStep_px = 8;

/// The pixels of a raster that a view needs, with the frame of just these.
struct Patch {
  cv::Mat pixels;
  std::optional<MapFrame> frame;
};

/// `area` in pixels of level 0; `scale` = pixels of the raster for each pixel of the picture. With `inking` the pixels
/// are ink.
Patch readPatch(const PreviewRaster& raster, const QRectF& area, double scale, const Inking* inking = nullptr) {
  Patch patch;
  int level = RasterLayer::levelForScale(1.0 / scale, raster.tiles->levels());
  while (level + 1 < raster.tiles->levels() &&
         std::max(area.width(), area.height()) / (1 << level) > kLargestPatch_px) {
    ++level;
  }
  const double shrink = 1.0 / (1 << level);
  const cv::Size size = raster.tiles->levelSize(level);
  const auto clampedTo = [](double value, int most) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(most)));
  };
  const int left = clampedTo(area.left() * shrink - 2.0, size.width);
  const int top = clampedTo(area.top() * shrink - 2.0, size.height);
  const int right = clampedTo(area.right() * shrink + 3.0, size.width);
  const int bottom = clampedTo(area.bottom() * shrink + 3.0, size.height);
  if (right <= left || bottom <= top) return patch;
  const cv::Rect rect(left, top, right - left, bottom - top);
  patch.pixels = inking ? inkRegion(*raster.tiles, level, rect, *inking) : raster.tiles->region(level, rect, kPaper);
  if (patch.pixels.empty()) return patch;
  const double grow = 1 << level;
  const Vector2d corner = raster.frame->metricFromPixel({left * grow, bottom * grow});
  const Result<MapFrame> frame = MapFrame::create(raster.frame->resolution() * grow, right - left, bottom - top,
                                                  {corner, raster.frame->metricFromCorner().heading});
  if (frame) patch.frame = *frame;
  return patch;
}

/// Ink of the base as the view shows it.
cv::Mat drawBase(const PreviewRaster& base, const MapFrame& view, const Inking& inking) {
  QRectF area;
  for (const Vector2d& corner :
       {Vector2d(0, 0), Vector2d(view.width(), 0), Vector2d(0, view.height()), Vector2d(view.width(), view.height())}) {
    const Vector2d pixel = base.frame->pixelFromMetric(view.metricFromPixel(corner));
    const QRectF dot(pixel.x(), pixel.y(), 1e-6, 1e-6);
    area = area.isNull() ? dot : area.united(dot);
  }
  cv::Mat picture(view.height(), view.width(), CV_8UC1, cv::Scalar(kPaper));
  const Patch patch = readPatch(base, area, view.resolution() / base.frame->resolution(), &inking);
  if (!patch.frame) return picture;
  const auto patchFromView = [&](double x, double y) {
    const Vector2d pixel = patch.frame->pixelFromMetric(view.metricFromPixel({x + 0.5, y + 0.5}));
    return Vector2d(pixel - Vector2d(0.5, 0.5));
  };
  const Vector2d origin = patchFromView(0, 0);
  const Vector2d across = patchFromView(1, 0) - origin;
  const Vector2d down = patchFromView(0, 1) - origin;
  const cv::Matx23d affine(across.x(), down.x(), origin.x(), across.y(), down.y(), origin.y());
  cv::warpAffine(greyOf(patch.pixels), picture, affine, picture.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                 cv::BORDER_CONSTANT, cv::Scalar(kPaper));
  return picture;
}

/// Where the view's pixels come from in the raster of a layer: the box around it, and raster pixels per view pixel.
bool sourceArea(const PreviewLayer& layer, WarpDirection direction, const MapFrame& view, QRectF* area, double* scale) {
  std::vector<Pose2> places;
  for (int row = 0; row <= kProbes; ++row) {
    for (int column = 0; column <= kProbes; ++column) {
      places.push_back({view.metricFromPixel({view.width() * static_cast<double>(column) / kProbes,
                                              view.height() * static_cast<double>(row) / kProbes}),
                        0.0});
    }
  }
  std::vector<Projection> there(places.size());
  if (direction == WarpDirection::kToBlueprint) {
    layer.projector.slamFromBlueprint(places.data(), there.data(), places.size(), OutsidePolicy::kRigid);
  } else {
    layer.projector.blueprintFromSlam(places.data(), there.data(), places.size(), OutsidePolicy::kRigid);
  }
  std::vector<double> steps;
  bool any = false;
  const double step_px = static_cast<double>(view.width()) / kProbes;
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (!there[i].ok()) continue;
    const Vector2d pixel = layer.raster.frame->pixelFromMetric(there[i].pose.translation);
    const QRectF dot(pixel.x(), pixel.y(), 1e-6, 1e-6);
    *area = any ? area->united(dot) : dot;
    any = true;
    if (i > 0 && i % (kProbes + 1) != 0 && there[i - 1].ok()) {
      const Vector2d before = layer.raster.frame->pixelFromMetric(there[i - 1].pose.translation);
      steps.push_back((pixel - before).norm() / step_px);
    }
  }
  if (!any || steps.empty()) return false;
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  *scale = steps[steps.size() / 2];
  // The warp may bulge between the probes.
  const double bulge = 0.5 * std::max(area->width(), area->height()) / kProbes + 2.0 * *scale;
  area->adjust(-bulge, -bulge, bulge, bulge);
  return *scale > 0.0 && std::isfinite(*scale);
}

/// Grey, or ink, and coverage of a layer as the view shows it; CV_8UC2, empty when nothing of it is in view.
Result<cv::Mat> drawLayer(const PreviewLayer& layer, WarpDirection direction, const MapFrame& view,
                          const Inking* inking = nullptr) {
  QRectF area;
  double scale = 1.0;
  if (!sourceArea(layer, direction, view, &area, &scale)) return cv::Mat();
  const Patch patch = readPatch(layer.raster, area, scale, inking);
  if (!patch.frame) return cv::Mat();
  const cv::Mat grey = greyOf(patch.pixels);
  cv::Mat with_coverage;
  cv::merge(std::vector<cv::Mat>{grey, cv::Mat(grey.size(), CV_8UC1, cv::Scalar(255))}, with_coverage);
  WarpOptions options;
  options.outside_value = cv::Scalar::all(0);
  return warpRaster(layer.projector, direction, with_coverage, *patch.frame, view, options);
}

QImage toImage(const cv::Mat& premultiplied, QImage::Format format) {
  QImage image(premultiplied.cols, premultiplied.rows, format);
  cv::Mat target(image.height(), image.width(), CV_8UC4, image.bits(), static_cast<std::size_t>(image.bytesPerLine()));
  premultiplied.copyTo(target);
  return image;
}

Result<QImage> drawWarped(const PreviewScene& scene, const MapFrame& view) {
  Result<cv::Mat> layer = drawLayer(scene.layers.front(), scene.direction, view);
  if (!layer) return failAs(layer);
  if (layer->empty())
    return toImage(cv::Mat(view.height(), view.width(), CV_8UC4, cv::Scalar()), QImage::Format_ARGB32_Premultiplied);
  cv::Mat picture(layer->size(), CV_8UC4);
  cv::mixChannels({*layer}, {picture}, {0, 0, 0, 1, 0, 2, 1, 3});  // grey is already weighted with its coverage
  return toImage(picture, QImage::Format_ARGB32_Premultiplied);
}

/// Lays one ink over the paper, multiplying, so that several make a dark place where they meet.
void layInk(cv::Mat& paper, const cv::Mat& amounts, const cv::Mat& coverage, const QColor& ink) {
  std::array<cv::Vec3b, 256> factors;
  const std::array<int, 3> color{ink.blue(), ink.green(), ink.red()};
  for (std::size_t value = 0; value < factors.size(); ++value) {
    for (int c = 0; c < 3; ++c) {
      const double amount = 1.0 - static_cast<double>(value) / 255.0;
      const double kept = 255.0 - amount * (255 - color[static_cast<std::size_t>(c)]);
      factors[value][c] = static_cast<uchar>(std::lround(kept));
    }
  }
  cv::parallel_for_(cv::Range(0, paper.rows), [&](const cv::Range& range) {
    for (int row = range.start; row < range.end; ++row) {
      const uchar* value = amounts.ptr(row);
      const uchar* covered = coverage.empty() ? nullptr : coverage.ptr(row);
      auto* pixel = paper.ptr<cv::Vec4b>(row);
      for (int column = 0; column < paper.cols; ++column) {
        if (covered != nullptr && covered[column] < 128) continue;
        const cv::Vec3b& factor = factors[value[column]];
        if (factor[0] == 255 && factor[1] == 255 && factor[2] == 255) continue;
        for (int c = 0; c < 3; ++c) pixel[column][c] = static_cast<uchar>(pixel[column][c] * factor[c] / 255);
      }
    }
  });
}

Result<QImage> drawInks(const PreviewScene& scene, const MapFrame& view) {
  cv::Mat paper(view.height(), view.width(), CV_8UC4, cv::Scalar::all(255));
  layInk(paper, drawBase(scene.base, view, inkingOf(*scene.base.tiles)), cv::Mat(), scene.base_ink);
  for (const PreviewLayer& layer : scene.layers) {
    if (!layer.raster.isUsable()) continue;
    const Inking inking = inkingOf(*layer.raster.tiles);
    Result<cv::Mat> drawn = drawLayer(layer, scene.direction, view, &inking);
    if (!drawn) return failAs(drawn);
    if (drawn->empty()) continue;
    cv::Mat amounts;
    cv::Mat coverage;
    cv::extractChannel(*drawn, amounts, 0);
    cv::extractChannel(*drawn, coverage, 1);
    layInk(paper, amounts, coverage, layer.ink);
  }
  return toImage(paper, QImage::Format_RGB32);
}

/// 1, 2 or 5 times a power of ten of a unit.
double niceAbove(double value, double unit) {
  const double in_units = value / unit;
  const double decade = std::pow(10.0, std::floor(std::log10(in_units)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (in_units <= factor * decade) return factor * decade * unit;
  }
  return 10.0 * decade * unit;
}

/// What nearly all of some values do not exceed; the strongest colour is for the rest.
double nearlyLargest(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto high = values.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), high, values.end());
  return *high;
}

/// A number for each place of the blueprint [m], NaN where the mesh is folded, and which one gets the strongest colour.
struct HeatField {
  std::function<double(const Vector2d& place)> value;
  double full = 0.0;
};

/// Local scale or turn relative to its mean.
HeatField bendField(const Projector& projector, PreviewKind kind) {
  const bool is_turn = kind == PreviewKind::kRotation;
  const auto valueOf = [is_turn](const Eigen::Matrix2d& jacobian) {
    return is_turn ? std::atan2(jacobian(1, 0) - jacobian(0, 1), jacobian(0, 0) + jacobian(1, 1))
                   : 0.5 * std::log(jacobian.determinant());
  };
  std::vector<double> values;
  double sine = 0.0;
  double cosine = 0.0;
  double sum = 0.0;
  for (const Vector2d& middle : projector.tileMiddles()) {
    const Eigen::Matrix2d jacobian = projector.jacobian(middle);
    if (!(jacobian.determinant() > 0.0)) continue;
    values.push_back(valueOf(jacobian));
    sine += std::sin(values.back());
    cosine += std::cos(values.back());
    sum += values.back();
  }
  const double mean =
      is_turn ? std::atan2(sine, cosine) : sum / static_cast<double>(std::max<std::size_t>(1, values.size()));
  const auto relative = [is_turn, mean](double value) {
    return is_turn ? wrapAngle(value - mean) : std::expm1(value - mean);
  };
  for (double& value : values) value = std::abs(relative(value));
  const double least = is_turn ? 0.5 * kPi / 180.0 : 0.005;
  return {[&projector, valueOf, relative](const Vector2d& place) {
            const Eigen::Matrix2d jacobian = projector.jacobian(place);
            return jacobian.determinant() > 0.0 ? relative(valueOf(jacobian)) : std::nan("");
          },
          niceAbove(std::max(nearlyLargest(std::move(values)), least), is_turn ? kPi / 180.0 : 0.01)};
}

/// Distance to the nearest anchor.
HeatField coverageField(const Projector& projector, const std::vector<Vector2d>& anchors) {
  const auto distance = [&anchors](const Vector2d& place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector2d& anchor : anchors) nearest = std::min(nearest, (anchor - place).squaredNorm());
    return std::sqrt(nearest);
  };
  std::vector<double> values;
  if (!anchors.empty()) {
    for (const Vector2d& middle : projector.tileMiddles()) values.push_back(distance(middle));
  }
  return {distance, niceAbove(std::max(nearlyLargest(std::move(values)), 1.0), 1.0)};
}

/// Blueprint places [m] of a lattice over a view, with a step of kHeatStep_px from the middle of its first pixel on;
/// NaN where the projector has no answer. CV_64FC2.
cv::Mat placesInBlueprint(const PreviewScene& scene, const MapFrame& view) {
  const Projector& projector = scene.layers.front().projector;
  cv::Mat places((view.height() - 1) / kHeatStep_px + 2, (view.width() - 1) / kHeatStep_px + 2, CV_64FC2);
  cv::parallel_for_(cv::Range(0, places.rows), [&](const cv::Range& range) {
    for (int row = range.start; row < range.end; ++row) {
      for (int column = 0; column < places.cols; ++column) {
        Vector2d place = view.metricFromPixel({column * kHeatStep_px + 0.5, row * kHeatStep_px + 0.5});
        if (scene.direction == WarpDirection::kToSlam) {
          place = projector.blueprintFromSlam({place, 0.0}, OutsidePolicy::kRigid).pose.translation;
        }
        places.at<cv::Vec2d>(row, column) = cv::Vec2d(place.x(), place.y());
      }
    }
  });
  return places;
}

QImage drawHeat(const PreviewScene& scene, PreviewKind kind, const MapFrame& view, double* full_color) {
  const Projector& projector = scene.layers.front().projector;
  const HeatField field =
      kind == PreviewKind::kCoverage ? coverageField(projector, scene.anchors) : bendField(projector, kind);
  *full_color = field.full;
  const cv::Mat places = placesInBlueprint(scene, view);
  cv::Mat colors(places.size(), CV_8UC3, cv::Scalar());  // black where folded or unknown
  cv::parallel_for_(cv::Range(0, places.rows), [&](const cv::Range& range) {
    for (int row = range.start; row < range.end; ++row) {
      for (int column = 0; column < places.cols; ++column) {
        const cv::Vec2d place = places.at<cv::Vec2d>(row, column);
        if (std::isnan(place[0])) continue;
        const double value = field.value({place[0], place[1]});
        if (std::isnan(value)) continue;
        const QColor color = strainColor(value, field.full);
        colors.at<cv::Vec3b>(row, column) = cv::Vec3b(
            static_cast<uchar>(color.blue()), static_cast<uchar>(color.green()), static_cast<uchar>(color.red()));
      }
    }
  });
  // The field is smooth and drawn from the lattice; the outline of the mesh is not, and is looked up pixel by pixel.
  QImage image(view.width(), view.height(), QImage::Format_ARGB32_Premultiplied);
  cv::Mat picture(image.height(), image.width(), CV_8UC4, image.bits(), static_cast<std::size_t>(image.bytesPerLine()));
  cv::parallel_for_(cv::Range(0, places.rows - 1), [&](const cv::Range& range) {
    for (int block_row = range.start; block_row < range.end; ++block_row) {
      for (int block_column = 0; block_column + 1 < places.cols; ++block_column) {
        const auto corner = [&](int down, int across) {
          return places.at<cv::Vec2d>(block_row + down, block_column + across);
        };
        const auto color = [&](int down, int across) {
          return cv::Vec3d(colors.at<cv::Vec3b>(block_row + down, block_column + across));
        };
        // Far from the mesh nothing is drawn.
        const cv::Vec2d middle = 0.25 * (corner(0, 0) + corner(0, 1) + corner(1, 0) + corner(1, 1));
        const double reach = cv::norm(corner(1, 1) - corner(0, 0)) + cv::norm(corner(1, 0) - corner(0, 1));
        const cv::Rect block =
            cv::Rect(block_column * kHeatStep_px, block_row * kHeatStep_px, kHeatStep_px, kHeatStep_px) &
            cv::Rect(0, 0, picture.cols, picture.rows);
        if (!(projector.distanceToMesh({middle[0], middle[1]}) <= reach)) {
          picture(block).setTo(cv::Scalar());
          continue;
        }
        for (int row = block.y; row < block.br().y; ++row) {
          const double v = static_cast<double>(row - block.y) / kHeatStep_px;
          for (int column = block.x; column < block.br().x; ++column) {
            const double u = static_cast<double>(column - block.x) / kHeatStep_px;
            const auto mixed = [&](const auto& of) {
              return (1 - v) * ((1 - u) * of(0, 0) + u * of(0, 1)) + v * ((1 - u) * of(1, 0) + u * of(1, 1));
            };
            const cv::Vec2d place = mixed(corner);
            const bool inside = projector.distanceToMesh({place[0], place[1]}) <= 0.0;  // false for NaN
            const cv::Vec3d shade = inside ? mixed(color) : cv::Vec3d();
            picture.at<cv::Vec4b>(row, column) =
                inside ? cv::Vec4b(static_cast<uchar>(shade[0]), static_cast<uchar>(shade[1]),
                                   static_cast<uchar>(shade[2]), 255)
                       : cv::Vec4b();
          }
        }
      }
    }
  });
  return image;
}

}  // namespace

Result<MapFrame> frameOfView(const ViewState& state, const QSize& size, double ratio) {
  const QSize device = (QSizeF(size) * ratio).toSize();
  const QPointF corner = state.widgetFromMetres(size).inverted().map(QPointF(0, size.height()));
  return MapFrame::create(state.m_per_px / ratio, device.width(), device.height(),
                          {{corner.x(), corner.y()}, -state.rotation_rad});
}

Result<PreviewPicture> renderPreview(const PreviewRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  if (!request.scene || request.scene->layers.empty() || !request.scene->base.isUsable() ||
      !request.scene->layers.front().raster.isUsable()) {
    return fail(ErrorCode::kNotFound, "there is nothing to lay over the map");
  }
  Result<MapFrame> view = frameOfView(request.state, request.size, request.ratio);
  if (!view) return failAs(view);

  PreviewPicture picture;
  picture.state = request.state;
  picture.size = request.size;
  picture.kind = request.kind;
  Result<QImage> image;
  switch (request.kind) {
    case PreviewKind::kWarped:
      image = drawWarped(*request.scene, *view);
      break;
    case PreviewKind::kInks:
      image = drawInks(*request.scene, *view);
      break;
    case PreviewKind::kStretch:
    case PreviewKind::kRotation:
    case PreviewKind::kCoverage:
      image = drawHeat(*request.scene, request.kind, *view, &picture.full_color);
      break;
  }
  if (!image) return failAs(image);
  picture.image = *image;
  picture.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return picture;
}

}  // namespace cad2slam

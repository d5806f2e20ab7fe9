// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/raster_layer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <QPainterPath>
#include <QPolygonF>

#include <opencv2/imgproc.hpp>

namespace cad2slam {
namespace {

constexpr int kTile = RasterSource::kTileSize;
constexpr int kPiece_px = 1 << 16;  // OpenCV does so many with the calling thread alone

int typeOf(QImage::Format format) {
  return format == QImage::Format_Grayscale8 ? CV_8UC1 : CV_8UC4;
}
int typeOf(const QImage& image) {
  return typeOf(image.format());
}

/// The pixels of an image without copying them; 1 channel for Grayscale8, else 4.
cv::Mat matOf(QImage& image) {
  return cv::Mat(image.height(), image.width(), typeOf(image), image.bits(),
                 static_cast<std::size_t>(image.bytesPerLine()));
}
cv::Mat matOf(const QImage& image) {  // OpenCV has no read-only matrix; nobody writes through this one
  return cv::Mat(image.height(), image.width(), typeOf(image), const_cast<uchar*>(image.constBits()),
                 static_cast<std::size_t>(image.bytesPerLine()));
}

/// Whether two maps differ by a shift of whole device pixels only.
bool isWholeShift(const QTransform& from, const QTransform& to, QPoint* shift) {
  const double tolerance = 1e-9 * std::max({std::abs(from.m11()), std::abs(from.m12()), 1e-12});
  if (std::abs(from.m11() - to.m11()) > tolerance || std::abs(from.m12() - to.m12()) > tolerance) return false;
  if (std::abs(from.m21() - to.m21()) > tolerance || std::abs(from.m22() - to.m22()) > tolerance) return false;
  const double dx = to.dx() - from.dx();
  const double dy = to.dy() - from.dy();
  if (std::abs(dx) > 1e6 || std::abs(dy) > 1e6) return false;
  *shift = QPoint(static_cast<int>(std::lround(dx)), static_cast<int>(std::lround(dy)));
  return std::abs(dx - shift->x()) < 0.02 && std::abs(dy - shift->y()) < 0.02;
}

/// Moves the pixels of an image; what comes in from outside keeps its old pixels.
void shiftInPlace(QImage& image, const QPoint& shift) {
  const auto pixel_bytes = static_cast<std::size_t>(image.depth() / 8);
  const std::size_t kept = static_cast<std::size_t>(image.width() - std::abs(shift.x())) * pixel_bytes;
  const std::size_t from = static_cast<std::size_t>(std::max(0, -shift.x())) * pixel_bytes;
  const std::size_t to = static_cast<std::size_t>(std::max(0, shift.x())) * pixel_bytes;
  const int rows = image.height() - std::abs(shift.y());
  for (int i = 0; i < rows; ++i) {
    // Away from the side it moves to, so that no row is overwritten before it has moved.
    const int target = shift.y() > 0 ? image.height() - 1 - i : i;
    std::memmove(image.scanLine(target) + to, image.constScanLine(target - shift.y()) + from, kept);
  }
}

/// Whether something of a raster of this size lies within the device, and all numbers on the way there can be counted
/// with: whatever files say, it is drawn or it is not.
bool isVisible(const QTransform& device_from_image, const QSize& raster_size, const QSize& device_size) {
  constexpr double kLargestScale = 1e9;
  for (const double slope :
       {device_from_image.m11(), device_from_image.m12(), device_from_image.m21(), device_from_image.m22()})
    if (!(std::abs(slope) < kLargestScale)) return false;
  if (!(std::sqrt(std::abs(device_from_image.determinant())) > 1.0 / kLargestScale)) return false;
  const QRectF seen = device_from_image.mapRect(QRectF(QPointF(0, 0), QSizeF(raster_size)));
  return seen.left() < device_size.width() && seen.right() > 0.0 && seen.top() < device_size.height() &&
         seen.bottom() > 0.0;
}

}  // namespace

void RasterLayer::setSource(std::shared_ptr<RasterSource> source) {
  source_ = std::move(source);
  patch_ = cv::Mat();
  picture_complete_ = false;
  stale_ = true;
}

void RasterLayer::reserve(const QSize& device_size) {
  if (picture_.size() == device_size) return;
  const qsizetype row_bytes = 4 * static_cast<qsizetype>(device_size.width());
  const auto bytes = static_cast<std::size_t>(row_bytes * device_size.height());
  if (bytes > picture_buffer_.size()) picture_buffer_.assign(bytes, 0);
  picture_ = QImage(picture_buffer_.data(), device_size.width(), device_size.height(), row_bytes, QImage::Format_RGB32);
  picture_complete_ = false;
}

int RasterLayer::levelForScale(double device_px, int level_count) {
  if (!(device_px > 0.0)) return 0;
  // A level is used until its pixels shrink to 0.6 device pixels: sharper than the next one, no visible aliasing.
  const double level = std::floor(std::log2(1.0 / device_px) + 0.25);
  return static_cast<int>(std::clamp(level, 0.0, std::max(0.0, level_count - 1.0)));
}

void RasterLayer::fillTile(int column, int row) {
  const QRect level_rect(QPoint(0, 0), source_->levelSize(patch_level_));
  const QRect tile_rect = QRect(column * kTile, row * kTile, kTile, kTile) & level_rect;
  const QPoint offset((column - patch_tiles_.x()) * kTile, (row - patch_tiles_.y()) * kTile);
  cv::Mat target = patch_(cv::Rect(offset.x(), offset.y(), tile_rect.width(), tile_rect.height()));

  const QImage exact = source_->tile({patch_level_, column, row});
  if (!exact.isNull() && typeOf(exact) == patch_.type() && exact.size() == tile_rect.size()) {
    matOf(exact).copyTo(target);
    return;
  }
  patch_complete_ = false;
  for (int level = patch_level_ + 1; level < source_->levelCount(); ++level) {
    const int up = level - patch_level_;
    const QImage coarse = source_->tile({level, column >> up, row >> up});
    if (coarse.isNull() || typeOf(coarse) != patch_.type()) continue;
    const int x0 = (tile_rect.x() >> up) - ((column >> up) * kTile);
    const int y0 = (tile_rect.y() >> up) - ((row >> up) * kTile);
    const cv::Mat source = matOf(coarse);
    const cv::Rect part =
        cv::Rect(x0, y0, std::max(1, tile_rect.width() >> up), std::max(1, tile_rect.height() >> up)) &
        cv::Rect(0, 0, source.cols, source.rows);
    if (part.empty()) continue;
    cv::resize(source(part), target, target.size(), 0, 0, cv::INTER_LINEAR);
    return;
  }
  target.setTo(cv::Scalar::all(224));  // nothing known yet
}

bool RasterLayer::gatherPatch(const QTransform& device_from_image, const QSize& device_size) {
  const double scale = std::sqrt(std::abs(device_from_image.determinant()));
  const int level = levelForScale(scale, source_->levelCount());
  const QSize level_size = source_->levelSize(level);
  bool invertible = false;
  const QTransform image_from_device = device_from_image.inverted(&invertible);
  if (!invertible) return false;

  const double reduce = 1.0 / (1 << level);
  const QRectF visible = image_from_device.mapRect(QRectF(QPointF(0, 0), QSizeF(device_size)));
  const auto tileOf = [reduce](double pixel, int size, int margin) {
    const double clamped = std::clamp(pixel * reduce + margin, 0.0, size - 1.0);
    return static_cast<int>(clamped) / kTile;
  };
  const int left = tileOf(visible.left(), level_size.width(), -1);
  const int right = tileOf(visible.right(), level_size.width(), 1);
  const int top = tileOf(visible.top(), level_size.height(), -1);
  const int bottom = tileOf(visible.bottom(), level_size.height(), 1);
  const QRect tiles(QPoint(left, top), QPoint(right, bottom));

  const int type = typeOf(source_->format());
  const bool same = !patch_.empty() && tiles == patch_tiles_ && level == patch_level_ && patch_.type() == type;
  if (same && (patch_complete_ || !stale_)) return true;
  if (!same) {
    const QRect level_rect(QPoint(0, 0), level_size);
    const QRect covered = QRect(left * kTile, top * kTile, tiles.width() * kTile, tiles.height() * kTile) & level_rect;
    if (!patch_.empty() && patch_.type() != type) picture_complete_ = false;  // the raster turned out to have colour
    if (patch_buffer_.type() != type || patch_buffer_.cols < covered.width() || patch_buffer_.rows < covered.height()) {
      patch_ = cv::Mat();
      const int columns = std::max(patch_buffer_.cols, covered.width());
      const int rows = std::max(patch_buffer_.rows, covered.height());
      patch_buffer_ = cv::Mat();  // freed before the new one is taken
      patch_buffer_.create(rows, columns, type);
    }
    patch_ = patch_buffer_(cv::Rect(0, 0, covered.width(), covered.height()));
    patch_level_ = level;
    patch_tiles_ = tiles;
  }
  patch_complete_ = true;
  for (int row = top; row <= bottom; ++row) {
    for (int column = left; column <= right; ++column) fillTile(column, row);
  }
  return true;
}

void RasterLayer::resample(const QTransform& device_from_image, const QRect& device_rect, const QColor& background) {
  const QRect area = device_rect & picture_.rect();
  if (area.isEmpty()) return;
  const double up = 1 << patch_level_;
  const QTransform image_from_device = device_from_image.inverted();
  // Centres of pixels lie at +0.5 in both rasters; OpenCV counts from centres.
  const auto patchFromDevice = [&](double x, double y) {
    const QPointF image = image_from_device.map(QPointF(area.x() + x + 0.5, area.y() + y + 0.5));
    return QPointF(image.x() / up - patch_tiles_.x() * kTile - 0.5, image.y() / up - patch_tiles_.y() * kTile - 0.5);
  };
  const QPointF origin = patchFromDevice(0, 0);
  const QPointF x_step = patchFromDevice(1, 0) - origin;
  const QPointF y_step = patchFromDevice(0, 1) - origin;
  const double pixel_size = 1.0 / std::sqrt(std::abs(x_step.x() * y_step.y() - x_step.y() * y_step.x()));
  const int method = pixel_size >= 2.0 ? cv::INTER_NEAREST : cv::INTER_LINEAR;
  const cv::Mat& patch = patch_;
  cv::Mat picture = matOf(picture_);
  cv::Mat target = picture(cv::Rect(area.x(), area.y(), area.width(), area.height()));
  // OpenCV hands larger pieces to its threads, and a window must not wait for those while they are busy with a solve.
  cv::Mat grey;
  const int band_rows = std::max(1, kPiece_px / target.cols);
  for (int row = 0; row < target.rows; row += band_rows) {
    cv::Mat band = target.rowRange(row, std::min(target.rows, row + band_rows));
    const QPointF start = origin + row * y_step;
    const cv::Matx23d affine(x_step.x(), y_step.x(), start.x(), x_step.y(), y_step.y(), start.y());
    const auto warpInto = [&](cv::Mat& out) {
      cv::warpAffine(patch, out, affine, band.size(), method | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
    };
    if (patch.channels() == 1) {
      grey.create(band.size(), CV_8UC1);
      warpInto(grey);
      cv::cvtColor(grey, band, cv::COLOR_GRAY2BGRA);
    } else {
      warpInto(band);
    }
  }

  const QPolygonF outline = device_from_image.map(QPolygonF(QRectF(QPointF(0, 0), QSizeF(source_->size()))));
  if (!outline.containsPoint(area.topLeft(), Qt::OddEvenFill) ||
      !outline.containsPoint(area.topRight() + QPoint(1, 0), Qt::OddEvenFill) ||
      !outline.containsPoint(area.bottomLeft() + QPoint(0, 1), Qt::OddEvenFill) ||
      !outline.containsPoint(area.bottomRight() + QPoint(1, 1), Qt::OddEvenFill)) {
    QPainterPath outside;
    outside.addRect(area);
    QPainterPath raster;
    raster.addPolygon(outline);
    raster.closeSubpath();
    QPainter painter(&picture_);
    painter.setClipRect(area);
    painter.fillPath(outside.subtracted(raster), background);
  }
}

void RasterLayer::paint(QPainter& painter, const QTransform& widget_from_image, const QSize& size,
                        const QColor& background) {
  const double ratio = painter.device()->devicePixelRatioF();
  const QSize device_size = (QSizeF(size) * ratio).toSize();
  if (!source_ || source_->size().isEmpty() || device_size.isEmpty()) {
    painter.fillRect(QRect(QPoint(0, 0), size), background);
    return;
  }
  const QTransform device_from_image = widget_from_image * QTransform::fromScale(ratio, ratio);
  in_view_ = isVisible(device_from_image, source_->size(), device_size);
  if (!in_view_ || !gatherPatch(device_from_image, device_size)) {
    painter.fillRect(QRect(QPoint(0, 0), size), background);
    return;
  }

  const bool reusable =
      picture_.size() == device_size && picture_background_ == background && picture_complete_ && patch_complete_;
  QPoint shift;
  if (reusable && isWholeShift(picture_transform_, device_from_image, &shift) &&
      std::abs(shift.x()) < device_size.width() && std::abs(shift.y()) < device_size.height()) {
    if (!shift.isNull()) {
      // Draw at the shifted place, so that rounding never adds up over many steps.
      const QTransform moved = picture_transform_ * QTransform::fromTranslate(shift.x(), shift.y());
      const QRect all = picture_.rect();
      const QRect kept = all.translated(shift) & all;
      shiftInPlace(picture_, shift);
      if (shift.x() != 0) {
        const int x = shift.x() > 0 ? 0 : kept.right() + 1;
        resample(moved, QRect(x, 0, std::abs(shift.x()), all.height()), background);
      }
      if (shift.y() != 0) {
        const int y = shift.y() > 0 ? 0 : kept.bottom() + 1;
        resample(moved, QRect(0, y, all.width(), std::abs(shift.y())), background);
      }
      picture_transform_ = moved;
    }
  } else {
    reserve(device_size);
    resample(device_from_image, picture_.rect(), background);
    picture_transform_ = device_from_image;
    picture_background_ = background;
  }
  picture_complete_ = patch_complete_;
  stale_ = false;

  picture_.setDevicePixelRatio(ratio);
  painter.drawImage(QPointF(0, 0), picture_);
  picture_.setDevicePixelRatio(1.0);
}

}  // namespace cad2slam

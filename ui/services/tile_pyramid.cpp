// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/tile_pyramid.h"

#include <algorithm>
#include <exception>

#include <QMetaObject>
#include <QSemaphore>
#include <QThread>

#include <opencv2/imgproc.hpp>

#include "cad2slam/io/picture_rows.h"
#include "ui/convert.h"
#include "ui/engine_sentences.h"
#include "ui/services/pyramid_builder.h"
#include "ui/services/screen_pixels.h"

namespace cad2slam {
namespace {

constexpr int kNoticeInterval_ms = 30;
// Tiles may be unpacked while painting for this long in each span; what is beyond goes to a worker.
constexpr qint64 kSpan_ns = 14'000'000;
constexpr qint64 kSpanBudget_ns = 3'000'000;
constexpr std::size_t kMostWanted = 1024;
constexpr int kRowsAtOnce = 64;
constexpr int kAlwaysAtHand = 2;  // coarsest levels, a handful of tiles: something can be drawn at any time

/// One for each processor but one: images that are read at the same time leave that one to the window. Held for a strip
/// at a time.
QSemaphore& readersAtOnce() {
  static QSemaphore readers(std::max(1, QThread::idealThreadCount() - 1));
  return readers;
}

bool hasColor(const cv::Mat& pixels) {
  for (int row = 0; row < pixels.rows; ++row) {
    const auto* pixel = pixels.ptr<cv::Vec4b>(row);
    int difference = 0;
    for (int column = 0; column < pixels.cols; ++column) {
      difference |= (pixel[column][0] ^ pixel[column][1]) | (pixel[column][1] ^ pixel[column][2]);
    }
    if (difference != 0) return true;
  }
  return false;
}

/// A QImage that shares the pixels of a matrix and keeps them alive.
QImage imageOf(const cv::Mat& pixels) {
  if (pixels.empty()) return {};
  auto* keeper = new cv::Mat(pixels);
  return QImage(
      keeper->data, keeper->cols, keeper->rows, static_cast<qsizetype>(keeper->step[0]),
      keeper->channels() == 1 ? QImage::Format_Grayscale8 : QImage::Format_RGB32,
      [](void* mat) { delete static_cast<cv::Mat*>(mat); }, keeper);
}

}  // namespace

TilePyramid::TilePyramid() {
  tiles_timer_.setSingleShot(true);
  tiles_timer_.setInterval(kNoticeInterval_ms);
  connect(&tiles_timer_, &QTimer::timeout, this, [this] {
    tiles_announced_ = false;
    emit tilesChanged();
  });
  spent_since_.start();
}

TilePyramid::~TilePyramid() {
  stop_ = true;
  lane_.waitForDone();
}

std::shared_ptr<TilePyramid> TilePyramid::load(const std::filesystem::path& image, bool mirrored) {
  std::shared_ptr<TilePyramid> pyramid(new TilePyramid);
  pyramid->lane_.start([self = pyramid.get(), image, mirrored] { self->read(image, mirrored); });
  return pyramid;
}

std::shared_ptr<TilePyramid> TilePyramid::fromPixels(const cv::Mat& pixels) {
  std::shared_ptr<TilePyramid> pyramid(new TilePyramid);
  const QSize size(pixels.cols, pixels.rows);
  auto store = std::make_shared<TileStore>(size, PyramidBuilder::levelCount(size), pixels.channels());
  PyramidBuilder builder(store);
  const bool kept = builder.append(pixels) && builder.finish();
  pyramid->store_ = std::move(store);
  pyramid->state_ = kept ? State::kReady : State::kFailed;
  return pyramid;
}

void TilePyramid::read(const std::filesystem::path& image, bool mirrored) {
  try {
    // Nearly every map is grey even where its file type is not; a quarter of the memory is worth a second start.
    if (cut(image, mirrored, 1) == Cut::kNeedsColor) cut(image, mirrored, 4);
  } catch (const std::exception& failure) {
    announceFailure(tr("The image %1 could not be read: %2").arg(toQString(image), QString::fromUtf8(failure.what())));
  }
}

TilePyramid::Cut TilePyramid::cut(const std::filesystem::path& image, bool mirrored, int channels) {
  const auto failWith = [this](const Error& error) {
    announceFailure(toSentence(error));
    return Cut::kFailed;
  };
  Result<std::unique_ptr<PictureRows>> picture = PictureRows::open(image);
  if (!picture) return failWith(picture.error());
  const QSize size((*picture)->width(), (*picture)->height());
  auto store = std::make_shared<TileStore>(size, PyramidBuilder::levelCount(size), channels);
  if ((*picture)->hasAlpha()) store->noteTransparency();
  PyramidBuilder builder(store);
  bool announced = false;
  for (int rows_done = 0; !stop_;) {
    readersAtOnce().acquire();
    const QSemaphoreReleaser turn(readersAtOnce());
    const Result<cv::Mat> read = (*picture)->read(kRowsAtOnce);
    if (!read) return failWith(read.error());
    if (read->empty()) break;
    cv::Mat rows = screenPixels(*read, (*picture)->fullBrightness());
    if (rows.channels() == 4 && channels == 1) {
      if (hasColor(rows)) return Cut::kNeedsColor;
      cv::Mat grey;
      cv::extractChannel(rows, grey, 0);
      rows = grey;
    } else if (rows.channels() == 1 && channels == 4) {
      cv::cvtColor(rows, rows, cv::COLOR_GRAY2BGRA);
    }
    if (mirrored) cv::flip(rows, rows, 1);
    if (!builder.append(rows)) {
      return failWith(
          {ErrorCode::kUnwritable, "there is no room for the temporary tiles of this image", image.string()});
    }
    if (!announced) announceStore(store);
    announced = true;
    announceTiles();
    rows_done += rows.rows;
    percent_ = static_cast<int>(100LL * rows_done / std::max(1, size.height()));
  }
  if (stop_) return Cut::kDone;
  if (!builder.finish()) {
    return failWith({ErrorCode::kUnwritable, "there is no room for the temporary tiles of this image", image.string()});
  }
  QMetaObject::invokeMethod(
      this,
      [this] {
        state_ = State::kReady;
        emit tilesChanged();
        emit ready();
      },
      Qt::QueuedConnection);
  return Cut::kDone;
}

void TilePyramid::announceStore(std::shared_ptr<TileStore> store) {
  QMetaObject::invokeMethod(
      this,
      [this, store = std::move(store)] {
        {
          const std::lock_guard lock(wanted_mutex_);
          store_ = store;
        }
        emit sizeKnown();
      },
      Qt::QueuedConnection);
}

void TilePyramid::announceTiles() {
  if (tiles_announced_.exchange(true)) return;
  QMetaObject::invokeMethod(
      this, [this] { tiles_timer_.start(); }, Qt::QueuedConnection);
}

void TilePyramid::announceFailure(const QString& sentence) {
  QMetaObject::invokeMethod(
      this,
      [this, sentence] {
        state_ = State::kFailed;
        error_ = sentence;
        emit failed(sentence);
      },
      Qt::QueuedConnection);
}

QSize TilePyramid::size() const {
  return store_ ? store_->size() : QSize();
}
int TilePyramid::levelCount() const {
  return store_ ? store_->levels() : 0;
}
QImage::Format TilePyramid::format() const {
  return store_ && store_->channels() == 4 ? QImage::Format_RGB32 : QImage::Format_Grayscale8;
}

QImage TilePyramid::tile(const TileKey& key) {
  if (!store_) return {};
  const cv::Mat ready = store_->peek(key);
  if (!ready.empty()) return imageOf(ready);
  if (!store_->has(key)) return {};  // announced when its rows are read

  if (spent_since_.nsecsElapsed() > kSpan_ns) {
    spent_since_.restart();
    spent_ns_ = 0;
  }
  if (spent_ns_ < kSpanBudget_ns || key.level + kAlwaysAtHand >= levelCount()) {
    const qint64 start = spent_since_.nsecsElapsed();
    const cv::Mat unpacked = store_->get(key);
    spent_ns_ += spent_since_.nsecsElapsed() - start;
    return imageOf(unpacked);
  }
  const std::lock_guard lock(wanted_mutex_);
  if (std::find(wanted_.rbegin(), wanted_.rend(), key) == wanted_.rend()) wanted_.push_back(key);
  if (wanted_.size() > kMostWanted) wanted_.erase(wanted_.begin(), wanted_.begin() + kMostWanted / 2);
  if (!unpacking_) {
    unpacking_ = true;
    lane_.start([this] { unpackWanted(); });
  }
  return {};
}

void TilePyramid::unpackWanted() {
  while (!stop_) {
    TileKey key;
    std::shared_ptr<TileStore> store;  // the image may turn out to have colour while a tile of it is being unpacked
    {
      const std::lock_guard lock(wanted_mutex_);
      if (wanted_.empty()) {
        unpacking_ = false;
        return;
      }
      key = wanted_.back();
      wanted_.pop_back();
      store = store_;
    }
    if (!store->get(key).empty()) announceTiles();
  }
}

QImage TilePyramid::pixels(int level, const QRect& rect) {
  if (!store_) return {};
  bool complete = false;
  const cv::Mat region = store_->region(
      level, cv::Rect(rect.x(), rect.y(), std::min(rect.width(), 512), std::min(rect.height(), 512)), 255, &complete);
  return complete ? imageOf(region) : QImage();
}

}  // namespace cad2slam

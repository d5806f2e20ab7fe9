// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QTimer>

#include <opencv2/core/mat.hpp>

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

#include "ui/services/tile_store.h"
#include "ui/views/lane.h"
#include "ui/views/raster_source.h"

namespace cad2slam {

/// The picture of one map as a pyramid of tiles, read and cut in the background; tiles can be drawn while later rows
/// are still being read. What it takes in memory is capped by TileStore.
class TilePyramid : public RasterSource {
  Q_OBJECT

 public:
  enum class State { kLoading, kReady, kFailed };

  /// Starts to read an image file. `mirrored`: left and right are swapped.
  [[nodiscard]] static std::shared_ptr<TilePyramid> load(const std::filesystem::path& image, bool mirrored = false);
  /// From pixels at hand: CV_8UC1, or CV_8UC4 in the order of QImage::Format_RGB32.
  [[nodiscard]] static std::shared_ptr<TilePyramid> fromPixels(const cv::Mat& pixels);
  ~TilePyramid() override;

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] QString error() const { return error_; }  ///< one sentence, when failed
  /// What the tiles lie in; for workers, which may keep it longer than this lives. Null until the size is known.
  [[nodiscard]] const std::shared_ptr<TileStore>& store() const { return store_; }

  [[nodiscard]] QSize size() const override;
  [[nodiscard]] int levelCount() const override;
  [[nodiscard]] QImage::Format format() const override;
  [[nodiscard]] int percentRead() const override { return state_ == State::kLoading ? percent_.load() : 100; }
  [[nodiscard]] QImage tile(const TileKey& key) override;
  [[nodiscard]] QImage pixels(int level, const QRect& rect) override;

 signals:
  void sizeKnown();
  void ready();
  void failed(const QString& sentence);

 private:
  TilePyramid();

  void read(const std::filesystem::path& image, bool mirrored);  // worker
  enum class Cut { kDone, kNeedsColor, kFailed };
  Cut cut(const std::filesystem::path& image, bool mirrored, int channels);  // worker
  void unpackWanted();                                                       // worker
  void announceStore(std::shared_ptr<TileStore> store);                      // from the worker
  void announceTiles();                                                      // from any worker
  void announceFailure(const QString& sentence);                             // from the worker

  std::shared_ptr<TileStore> store_;  // written by the GUI thread under wanted_mutex_, read by workers under it
  State state_ = State::kLoading;
  QString error_;
  QTimer tiles_timer_;  // gathers notices
  QElapsedTimer spent_since_;
  qint64 spent_ns_ = 0;  // on unpacking in the GUI thread since then

  std::atomic<bool> stop_{false};
  std::atomic<int> percent_{0};
  std::atomic<bool> tiles_announced_{false};
  std::mutex wanted_mutex_;      // of wanted_, unpacking_ and store_
  std::vector<TileKey> wanted_;  // the newest last
  bool unpacking_ = false;
  Lane lane_{2};  // one reads the image, one unpacks tiles
};

}  // namespace cad2slam

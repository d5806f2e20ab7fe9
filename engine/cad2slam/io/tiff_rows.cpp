// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/picture_decoders.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <vector>

#include <tiffio.h>

namespace cad2slam {
namespace {

/// A row of tiles, or a compressed strip, that takes more than this is better refused than tried.
constexpr std::size_t kMostBandBytes = std::size_t{1} << 30;

class TiffRows : public PictureRows {
 public:
  explicit TiffRows(const std::filesystem::path& image) : PictureRows(image) {}
  ~TiffRows() override {
    if (tiff_ != nullptr) TIFFClose(tiff_);
  }

  /// False when the file cannot be read row by row.
  bool start() {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    if (options == nullptr) return false;
    // libtiff's own handlers print.
    TIFFOpenOptionsSetErrorHandlerExtR(options, &TiffRows::onError, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options, &TiffRows::onWarning, this);
    // Not mapped into memory ("m"): a file that is shortened meanwhile would kill the program.
    tiff_ = TIFFOpenExt(image().c_str(), "rm", options);
    TIFFOpenOptionsFree(options);
    return tiff_ != nullptr && readTags();
  }

 private:
  template <class Value>
  [[nodiscard]] Value tag(std::uint32_t name, Value otherwise) const {
    Value value = otherwise;
    return TIFFGetFieldDefaulted(tiff_, name, &value) != 0 ? value : otherwise;
  }

  bool readTags() {
    const auto width = tag<std::uint32_t>(TIFFTAG_IMAGEWIDTH, 0);
    const auto height = tag<std::uint32_t>(TIFFTAG_IMAGELENGTH, 0);
    bits_ = tag<std::uint16_t>(TIFFTAG_BITSPERSAMPLE, 0);
    samples_ = tag<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL, 0);
    auto photometric = tag<std::uint16_t>(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_PALETTE);
    const bool is_jpeg = tag<std::uint16_t>(TIFFTAG_COMPRESSION, COMPRESSION_NONE) == COMPRESSION_JPEG;
    if (photometric == PHOTOMETRIC_YCBCR && is_jpeg) {
      TIFFSetField(tiff_, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
      photometric = PHOTOMETRIC_RGB;
    }
    zero_is_white_ = photometric == PHOTOMETRIC_MINISWHITE;
    const bool is_grey = zero_is_white_ || photometric == PHOTOMETRIC_MINISBLACK;
    const bool has_depth = bits_ == 8 || bits_ == 16 || (bits_ == 1 && samples_ == 1);
    const bool has_channels =
        is_grey ? samples_ == 1 || samples_ == 2 : photometric == PHOTOMETRIC_RGB && (samples_ == 3 || samples_ == 4);
    const bool is_plain = tag<std::uint16_t>(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_CONTIG &&
                          tag<std::uint16_t>(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT) == SAMPLEFORMAT_UINT &&
                          tag<std::uint16_t>(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) == ORIENTATION_TOPLEFT;
    if (!has_depth || !has_channels || !is_plain || width == 0 || height == 0) return false;
    describe(static_cast<int>(width), static_cast<int>(height),
             CV_MAKETYPE(bits_ == 16 ? CV_16U : CV_8U, samples_ == 2 ? 4 : samples_));
    return TIFFIsTiled(tiff_) != 0 ? prepareTiles() : prepareLine();
  }

  bool prepareLine() {
    const std::size_t needed = (std::size_t{bits_} * samples_ * static_cast<std::size_t>(width()) + 7) / 8;
    const tmsize_t line_bytes = TIFFScanlineSize(tiff_);
    if (line_bytes < 0 || static_cast<std::size_t>(line_bytes) < needed) return false;
    band_.resize(static_cast<std::size_t>(line_bytes));
    lies_as_needed_ = bits_ >= 8 && samples_ == 1 && !zero_is_white_ && band_.size() == needed;
    return true;
  }

  bool prepareTiles() {
    tile_width_ = tag<std::uint32_t>(TIFFTAG_TILEWIDTH, 0);
    tile_height_ = tag<std::uint32_t>(TIFFTAG_TILELENGTH, 0);
    const tmsize_t tile_bytes = TIFFTileSize(tiff_);
    const tmsize_t tile_row_bytes = TIFFTileRowSize(tiff_);
    if (tile_width_ == 0 || tile_height_ == 0 || tile_bytes <= 0 || tile_row_bytes <= 0) return false;
    if (std::size_t{bits_} * samples_ * tile_width_ != 8 * static_cast<std::size_t>(tile_row_bytes)) return false;
    if (static_cast<std::size_t>(tile_bytes) != static_cast<std::size_t>(tile_row_bytes) * tile_height_) return false;
    const std::size_t across = (static_cast<std::size_t>(width()) + tile_width_ - 1) / tile_width_;
    if (static_cast<std::size_t>(tile_bytes) > kMostBandBytes / across) return false;
    tile_.resize(static_cast<std::size_t>(tile_bytes));
    line_bytes_ = static_cast<std::size_t>(tile_row_bytes) * across;
    band_.resize(line_bytes_ * tile_height_);
    return true;
  }

  Result<void> decode(int first, cv::Mat& rows) override {
    for (int row = 0; row < rows.rows; ++row) {
      if (!decodeRow(static_cast<std::uint32_t>(first + row), rows.ptr(row))) return damaged(message_);
    }
    return {};
  }

  bool decodeRow(std::uint32_t row, std::uint8_t* to) {
    if (lies_as_needed_) return readLine(row, to);
    const std::uint8_t* line = lineAt(row);
    if (line == nullptr) return false;
    if (bits_ == 1) {
      expandBits(line, width(), !zero_is_white_, to);
    } else if (bits_ == 8) {
      decodeSamples(line, to);
    } else {
      decodeSamples(reinterpret_cast<const std::uint16_t*>(line), reinterpret_cast<std::uint16_t*>(to));
    }
    return true;
  }

  /// The samples of a row as they lie in the file, in the byte order of this machine; null when they are damaged.
  const std::uint8_t* lineAt(std::uint32_t row) {
    if (tile_height_ == 0) return readLine(row, band_.data()) ? band_.data() : nullptr;
    if (row % tile_height_ == 0 && !readTileRow(row)) return nullptr;
    return band_.data() + line_bytes_ * (row % tile_height_);
  }

  bool readLine(std::uint32_t row, std::uint8_t* line) { return TIFFReadScanline(tiff_, line, row, 0) == 1; }

  bool readTileRow(std::uint32_t first_row) {
    const std::size_t tile_row_bytes = tile_.size() / tile_height_;
    std::size_t at = 0;
    for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(width()); column += tile_width_) {
      if (TIFFReadTile(tiff_, tile_.data(), column, first_row, 0, 0) < 0) return false;
      for (std::uint32_t row = 0; row < tile_height_; ++row)
        std::memcpy(band_.data() + line_bytes_ * row + at, tile_.data() + tile_row_bytes * row, tile_row_bytes);
      at += tile_row_bytes;
    }
    return true;
  }

  template <class Sample>
  void decodeSamples(const Sample* from, Sample* to) const {
    const Sample flip = zero_is_white_ ? static_cast<Sample>(~Sample{0}) : Sample{0};
    const int channels = CV_MAT_CN(type());
    for (int column = 0; column < width(); ++column, from += samples_, to += channels) {
      if (channels == 1) {
        *to = from[0] ^ flip;
        continue;
      }
      const bool is_grey = samples_ == 2;
      to[0] = is_grey ? from[0] ^ flip : from[2];
      to[1] = is_grey ? to[0] : from[1];
      to[2] = is_grey ? to[0] : from[0];
      if (channels == 4) to[3] = from[samples_ - 1];
    }
  }

  __attribute__((format(printf, 4, 0))) static int onError(TIFF*, void* self, const char*, const char* format,
                                                           std::va_list values) {
    char text[256] = {};
    std::vsnprintf(text, sizeof text, format, values);
    static_cast<TiffRows*>(self)->message_ = text;
    return 1;  // done with: the handler that prints is not called
  }
  static int onWarning(TIFF*, void*, const char*, const char*, std::va_list) { return 1; }

  TIFF* tiff_ = nullptr;
  std::uint16_t bits_ = 0;
  std::uint16_t samples_ = 0;
  bool zero_is_white_ = false;
  bool lies_as_needed_ = false;   // lines of the file are rows of the picture
  std::uint32_t tile_width_ = 0;  // 0: the file is of strips
  std::uint32_t tile_height_ = 0;
  std::size_t line_bytes_ = 0;      // of a row of the band, for tiles
  std::vector<std::uint8_t> tile_;  // one as decoded
  std::vector<std::uint8_t> band_;  // one row, or one row of tiles
  std::string message_;
};

}  // namespace

std::unique_ptr<PictureRows> openTiffRows(const std::filesystem::path& image) {
  return startedRows<TiffRows>(image);
}

}  // namespace cad2slam

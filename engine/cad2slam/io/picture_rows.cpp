// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/picture_rows.h"

#include "cad2slam/io/image_header.h"
#include "cad2slam/io/picture_decoders.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <new>

namespace cad2slam {
namespace {

namespace fs = std::filesystem;

/// Decoded by OpenCV in one piece.
class WholePicture : public PictureRows {
 public:
  WholePicture(const fs::path& image, cv::Mat picture) : PictureRows(image), picture_(std::move(picture)) {
    describe(picture_.cols, picture_.rows, picture_.type());
  }

 private:
  Result<void> decode(int first, cv::Mat& rows) override {
    picture_.rowRange(first, first + rows.rows).copyTo(rows);
    return {};
  }

  cv::Mat picture_;
};

/// OpenCV reports some failures as an exception, some as no image.
Result<cv::Mat> decodeWhole(const fs::path& image, const ImageHeader& header) {
  cv::Mat picture;
  try {
    picture = cv::imread(image.string(), cv::IMREAD_UNCHANGED);  // which also ignores EXIF orientation
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) {
      return fail(ErrorCode::kInternal, "is too large an image for the memory of this machine", image.string());
    }
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::kInternal, "is too large an image for the memory of this machine", image.string());
  }
  if (picture.empty()) return fail(ErrorCode::kMalformed, "is a damaged image", image.string());
  const int channels = picture.channels();
  if ((picture.depth() != CV_8U && picture.depth() != CV_16U) || (channels != 1 && channels != 3 && channels != 4)) {
    return fail(ErrorCode::kMalformed, "is an image of an unusual kind: 8 or 16 bit grey or colour can be read",
                image.string());
  }
  if (static_cast<std::uint64_t>(picture.cols) != header.width_px ||
      static_cast<std::uint64_t>(picture.rows) != header.height_px) {
    return fail(ErrorCode::kMalformed, "is a damaged image: its size is not the one its header says", image.string());
  }
  return picture;
}

std::unique_ptr<PictureRows> openByRows(const fs::path& image, const ImageHeader& header) {
  switch (header.format) {
    case ImageFormat::kPng:
      return openPngRows(image);
    case ImageFormat::kJpeg:
      return openJpegRows(image);
    case ImageFormat::kTiff:
      return openTiffRows(image);
    case ImageFormat::kPnm:
      return openPnmRows(image, header);
    case ImageFormat::kBmp:
      break;
  }
  return nullptr;
}

}  // namespace

Result<std::unique_ptr<PictureRows>> PictureRows::open(const fs::path& image) {
  const Result<ImageHeader> header = readImageHeader(image, ImageCheck::kWhole);
  if (!header) return failAs(header);
  std::unique_ptr<PictureRows> rows = openByRows(image, *header);
  if (!rows) {
    Result<cv::Mat> picture = decodeWhole(image, *header);
    if (!picture) return failAs(picture);
    rows = std::make_unique<WholePicture>(image, std::move(*picture));
  }
  rows->full_brightness_ = header->full_brightness;
  return rows;
}

tl::unexpected<Error> PictureRows::damaged(const std::string& reason) const {
  return fail(ErrorCode::kMalformed,
              reason.empty() ? std::string("is a damaged image") : "is a damaged image: " + reason, image_);
}

Result<cv::Mat> PictureRows::read(int count) {
  const int rows_left = height_ - next_row_;
  if (count <= 0 || rows_left <= 0) return cv::Mat();
  cv::Mat rows;
  try {
    rows.create(std::min(count, rows_left), width_, type_);
  } catch (const cv::Exception&) {
    return fail(ErrorCode::kInternal, "is too large an image for the memory of this machine", image_);
  }
  if (const Result<void> decoded = decode(next_row_, rows); !decoded) return failAs(decoded);
  next_row_ += rows.rows;
  return rows;
}

}  // namespace cad2slam

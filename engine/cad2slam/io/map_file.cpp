// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/map_file.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/image_header.h"
#include "cad2slam/io/map_yaml.h"
#include "cad2slam/io/pixel_states.h"
#include "cad2slam/io/text.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <new>

namespace cad2slam {
namespace {

namespace fs = std::filesystem;

struct DecodedImage {
  cv::Mat picture;
  ImageHeader header;
};

/// Decodes a file whose header has been found sane. OpenCV reports some failures as an exception, some as no image.
Result<DecodedImage> decodeImage(const fs::path& image) {
  const Result<ImageHeader> header = readImageHeader(image, ImageCheck::kWhole);
  if (!header) return failAs(header);
  DecodedImage decoded;
  decoded.header = *header;
  try {
    decoded.picture = cv::imread(image.string(), cv::IMREAD_UNCHANGED);  // which also ignores EXIF orientation
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) {
      return fail(ErrorCode::kInternal, "is too large an image for the memory of this machine", image.string());
    }
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::kInternal, "is too large an image for the memory of this machine", image.string());
  }
  if (decoded.picture.empty()) return fail(ErrorCode::kMalformed, "is a damaged image", image.string());
  if (static_cast<std::uint64_t>(decoded.picture.cols) != header->width_px ||
      static_cast<std::uint64_t>(decoded.picture.rows) != header->height_px) {
    return fail(ErrorCode::kMalformed, "is a damaged image: its size is not the one its header says", image.string());
  }
  return decoded;
}

Result<MapFrame> frameOf(const MapMetadata& metadata, const ImageHeader& header) {
  const Result<MapFrame> frame = MapFrame::create(metadata.resolution_m_per_px, static_cast<int>(header.width_px),
                                                  static_cast<int>(header.height_px), metadata.metric_from_corner);
  if (frame) return frame;
  return fail(frame.error().code, frame.error().message,
              metadata.yaml.empty() ? metadata.image.string() : metadata.yaml.string());
}

std::string semanticsName(MapSemantics semantics) {
  return semantics == MapSemantics::kJazzy ? "ROS 2 jazzy and later" : "ROS 1 and ROS 2 up to humble";
}

Result<LoadedMap> loadMapWithWarnings(const MapMetadata& metadata, std::vector<std::string> warnings,
                                      const MapReadOptions& options) {
  Result<DecodedImage> decoded = decodeImage(metadata.image);
  if (!decoded) return failAs(decoded);
  const Result<MapFrame> frame = frameOf(metadata, decoded->header);
  if (!frame) return failAs(frame);

  PixelRules rules;
  rules.semantics = options.semantics;
  rules.mode = metadata.mode;
  rules.occupied_threshold = metadata.occupied_threshold;
  rules.free_threshold = metadata.free_threshold;
  rules.negate = metadata.negate;
  rules.full_brightness = decoded->header.full_brightness;
  Result<PixelStates> pixels = classifyPixels(std::move(decoded->picture), rules);
  if (!pixels) return fail(pixels.error().code, pixels.error().message, metadata.image.string());

  if (metadata.mirrored) cv::flip(pixels->states, pixels->states, 1);

  if (pixels->grey_205_is_free && !metadata.negate && metadata.mode != MapMode::kRaw) {
    warnings.push_back("Grey 205, which map_saver writes for unknown, counts as free with free_thresh " +
                       formatNumber(metadata.free_threshold) + "; 0.196 would keep it unknown.");
  }
  if (pixels->read_differently > 0) {
    const MapSemantics other = options.semantics == MapSemantics::kJazzy ? MapSemantics::kHumble : MapSemantics::kJazzy;
    warnings.push_back(std::to_string(pixels->read_differently) + " pixels were read as " +
                       semanticsName(options.semantics) + " read them; " + semanticsName(other) +
                       " would read them differently.");
  }
  return LoadedMap{metadata, OccupancyGrid(*frame, std::move(pixels->states)), std::move(warnings)};
}

}  // namespace

Result<LoadedMap> loadMap(const fs::path& yaml, const MapReadOptions& options) {
  Result<MapYaml> read = readMapYaml(yaml);
  if (!read) return failAs(read);
  return loadMapWithWarnings(read->metadata, std::move(read->warnings), options);
}

Result<LoadedMap> loadMap(const MapMetadata& metadata, const MapReadOptions& options) {
  return loadMapWithWarnings(metadata, {}, options);
}

Result<MapFrame> readMapFrame(const MapMetadata& metadata) {
  const Result<ImageHeader> header = readImageHeader(metadata.image, ImageCheck::kSize);
  if (!header) return failAs(header);
  return frameOf(metadata, *header);
}

Result<cv::Mat> loadPicture(const fs::path& image) {
  Result<DecodedImage> decoded = decodeImage(image);
  if (!decoded) return failAs(decoded);
  cv::Mat& picture = decoded->picture;
  const int channels = picture.channels();
  if ((picture.depth() != CV_8U && picture.depth() != CV_16U) || (channels != 1 && channels != 3 && channels != 4)) {
    return fail(ErrorCode::kMalformed, "is an image of an unusual kind: 8 or 16 bit grey or colour can be read",
                image.string());
  }
  const double white = picture.depth() == CV_8U ? 255.0 : 65535.0;
  const double full_brightness = decoded->header.full_brightness;
  if (full_brightness > 0.0 && full_brightness < white) picture.convertTo(picture, -1, white / full_brightness);
  return std::move(picture);
}

Result<void> writePicture(const fs::path& image, const cv::Mat& picture) {
  const std::string extension = lowerCase(image.extension().string());
  const bool is_pgm = extension == ".pgm";
  if (!is_pgm && extension != ".png") {
    return fail(ErrorCode::kUnwritable, "pictures are written as .pgm or .png, not " + excerpt(extension),
                image.string());
  }
  const int channels = picture.channels();
  const bool fits = !picture.empty() && (picture.depth() == CV_8U || picture.depth() == CV_16U) &&
                    (channels == 1 || (!is_pgm && (channels == 3 || channels == 4)));
  if (!fits) {
    return fail(ErrorCode::kUnwritable,
                is_pgm ? "a .pgm holds grey of 8 or 16 bits only; write a .png instead"
                       : "a .png holds grey or colour of 8 or 16 bits only",
                image.string());
  }
  std::vector<unsigned char> bytes;
  bool encoded = false;
  try {
    encoded = cv::imencode(extension, picture, bytes);
  } catch (const cv::Exception&) {
    encoded = false;
  }
  if (!encoded) return fail(ErrorCode::kInternal, "the image cannot be encoded", image.string());
  return writeFileAtomically(image, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

Result<void> writeMap(const fs::path& yaml, const std::string& image_name, const cv::Mat& picture,
                      const MapMetadata& metadata) {
  const fs::path image = yaml.parent_path() / image_name;
  if (image_name.empty() || fs::path(image_name).filename() != fs::path(image_name) ||
      image_name.find('\0') != std::string::npos) {
    return fail(ErrorCode::kUnwritable, "the image of a map must be a file name without folders", image.string());
  }
  // The image first: a YAML never names an image that is not there.
  if (const Result<void> wrote_image = writePicture(image, picture); !wrote_image) return wrote_image;
  return writeFileAtomically(yaml, formatMapYaml(metadata, image_name));
}

}  // namespace cad2slam

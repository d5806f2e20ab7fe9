// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/map_file.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/image_header.h"
#include "cad2slam/io/map_yaml.h"
#include "cad2slam/io/picture_rows.h"
#include "cad2slam/io/pixel_classifier.h"
#include "cad2slam/io/text.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace cad2slam {
namespace {

namespace fs = std::filesystem;

constexpr int kRowsAtOnce = 256;

Result<MapFrame> frameOf(const MapMetadata& metadata, int width_px, int height_px) {
  const Result<MapFrame> frame =
      MapFrame::create(metadata.resolution_m_per_px, width_px, height_px, metadata.metric_from_corner);
  if (frame) return frame;
  return fail(frame.error().code, frame.error().message,
              metadata.yaml.empty() ? metadata.image.string() : metadata.yaml.string());
}

std::string semanticsName(MapSemantics semantics) {
  return semantics == MapSemantics::kJazzy ? "ROS 2 jazzy and later" : "ROS 1 and ROS 2 up to humble";
}

void addWarnings(const PixelNotes& notes, const MapMetadata& metadata, MapSemantics semantics,
                 std::vector<std::string>& warnings) {
  if (notes.grey_205_is_free && !metadata.negate && metadata.mode != MapMode::kRaw) {
    warnings.push_back("Grey 205, which map_saver writes for unknown, counts as free with free_thresh " +
                       formatNumber(metadata.free_threshold) + "; 0.196 would keep it unknown.");
  }
  if (notes.read_differently > 0) {
    const MapSemantics other = semantics == MapSemantics::kJazzy ? MapSemantics::kHumble : MapSemantics::kJazzy;
    warnings.push_back(std::to_string(notes.read_differently) + " pixels were read as " + semanticsName(semantics) +
                       " read them; " + semanticsName(other) + " would read them differently.");
  }
}

Result<LoadedMap> loadMapWithWarnings(const MapMetadata& metadata, std::vector<std::string> warnings,
                                      const MapReadOptions& options) {
  Result<std::unique_ptr<PictureRows>> picture = PictureRows::open(metadata.image);
  if (!picture) return failAs(picture);
  const int width = (*picture)->width();
  const int height = (*picture)->height();
  const Result<MapFrame> frame = frameOf(metadata, width, height);
  if (!frame) return failAs(frame);

  PixelRules rules;
  rules.semantics = options.semantics;
  rules.mode = metadata.mode;
  rules.occupied_threshold = metadata.occupied_threshold;
  rules.free_threshold = metadata.free_threshold;
  rules.negate = metadata.negate;
  rules.full_brightness = (*picture)->fullBrightness();
  const Result<std::unique_ptr<PixelClassifier>> classifier = PixelClassifier::create((*picture)->type(), rules);
  if (!classifier) return fail(classifier.error().code, classifier.error().message, metadata.image.string());

  OccupancyGridBuilder grid(*frame);
  for (int row = 0; row < height;) {
    const Result<cv::Mat> rows = (*picture)->read(kRowsAtOnce);
    if (!rows) return failAs(rows);
    cv::Mat piece = (*classifier)->classify(*rows);
    if (metadata.mirrored) cv::flip(piece, piece, 1);
    grid.append(piece);
    row += piece.rows;
  }
  addWarnings((*classifier)->notes(), metadata, options.semantics, warnings);
  return LoadedMap{metadata, grid.build(), std::move(warnings)};
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
  return frameOf(metadata, static_cast<int>(header->width_px), static_cast<int>(header->height_px));
}

Result<cv::Mat> loadPicture(const fs::path& image) {
  Result<std::unique_ptr<PictureRows>> rows = PictureRows::open(image);
  if (!rows) return failAs(rows);
  Result<cv::Mat> picture = (*rows)->read((*rows)->height());
  if (!picture) return failAs(picture);
  const double white = picture->depth() == CV_8U ? 255.0 : 65535.0;
  const double full_brightness = (*rows)->fullBrightness();
  if (full_brightness > 0.0 && full_brightness < white) picture->convertTo(*picture, -1, white / full_brightness);
  return picture;
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
  std::error_code ignored;
  const bool image_is_new = !fs::exists(image, ignored);
  if (const Result<void> wrote_image = writePicture(image, picture); !wrote_image) return wrote_image;
  Result<void> wrote_yaml = writeFileAtomically(yaml, formatMapYaml(metadata, image_name));
  if (!wrote_yaml && image_is_new) fs::remove(image, ignored);
  return wrote_yaml;
}

}  // namespace cad2slam

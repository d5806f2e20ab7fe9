// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/projector_metadata.h"

#include "cad2slam/io/projector_file.h"
#include "cad2slam/io/text.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace cad2slam {
namespace {

constexpr const char* kFormat = "cad2slam-projector";

void putText(ProjectorMetadata& metadata, const std::string& key, const std::string& value) {
  if (!value.empty()) metadata[key] = value;
}

void putQuality(ProjectorMetadata& metadata, const std::string& key, double value) {
  if (std::isfinite(value)) metadata[key] = formatNumber(value);
}

void putPose(ProjectorMetadata& metadata, const std::string& prefix, const Pose2& pose) {
  metadata[prefix + "_x_m"] = formatNumber(pose.translation.x());
  metadata[prefix + "_y_m"] = formatNumber(pose.translation.y());
  metadata[prefix + "_heading_rad"] = formatNumber(pose.heading);
}

void putFrame(ProjectorMetadata& metadata, const std::string& prefix, const FrameInfo& frame) {
  putText(metadata, prefix + "_name", frame.name);
  putText(metadata, prefix + "_image_sha256", frame.image_sha256);
  metadata[prefix + "_resolution_m_per_px"] = formatNumber(frame.resolution_m_per_px);
  metadata[prefix + "_width_px"] = std::to_string(frame.width_px);
  metadata[prefix + "_height_px"] = std::to_string(frame.height_px);
  putPose(metadata, prefix + "_origin", frame.metric_from_corner);
}

/// Typed access; remembers the first thing that is wrong, so that reading is one line for each value.
class MetadataReader {
 public:
  MetadataReader(const ProjectorMetadata& metadata, std::string file_name)
      : metadata_(metadata), file_name_(std::move(file_name)) {}

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  void refuse(const std::string& key, const std::string& message) {
    if (!error_) error_ = Error{ErrorCode::kMalformed, "the metadata " + key + " " + message, file_name_};
  }
  /// Empty where it is missing.
  std::string text(const std::string& key) const {
    const auto place = metadata_.find(key);
    return place == metadata_.end() ? std::string() : place->second;
  }
  double number(const std::string& key) {
    const std::optional<double> value = parseNumber(required(key));
    if (!value) refuse(key, "is " + excerpt(text(key)) + ", not a finite number");
    return value.value_or(0.0);
  }
  double numberOrUnknown(const std::string& key) {
    return metadata_.count(key) > 0 ? number(key) : std::numeric_limits<double>::quiet_NaN();
  }
  template <class Integer>
  Integer count(const std::string& key) {
    const std::optional<Integer> value = parseInteger<Integer>(required(key));
    if (!value || *value < 0) refuse(key, "is " + excerpt(text(key)) + ", not a whole number from 0 on");
    return value.value_or(0);
  }
  std::string sha256(const std::string& key) {
    const std::string hex = text(key);
    const bool is_hex =
        std::all_of(hex.begin(), hex.end(), [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
    if (!hex.empty() && (!is_hex || hex.size() != 64)) refuse(key, "is not 64 hexadecimal digits");
    return hex;
  }
  /// One of two words.
  template <class Choice>
  Choice choice(const std::string& key, const char* first_word, Choice first, const char* second_word, Choice second) {
    const std::string word = required(key);
    if (word != first_word && word != second_word) refuse(key, "is " + excerpt(word) + ", which is not known");
    return word == second_word ? second : first;
  }
  Pose2 pose(const std::string& prefix) {
    return {{number(prefix + "_x_m"), number(prefix + "_y_m")}, number(prefix + "_heading_rad")};
  }
  FrameInfo frame(const std::string& prefix) {
    FrameInfo frame;
    frame.name = text(prefix + "_name");
    frame.image_sha256 = sha256(prefix + "_image_sha256");
    frame.resolution_m_per_px = number(prefix + "_resolution_m_per_px");
    frame.width_px = count<int>(prefix + "_width_px");
    frame.height_px = count<int>(prefix + "_height_px");
    frame.metric_from_corner = pose(prefix + "_origin");
    return frame;
  }

 private:
  std::string required(const std::string& key) {
    if (metadata_.count(key) == 0) refuse(key, "is missing");
    return text(key);
  }

  const ProjectorMetadata& metadata_;
  std::string file_name_;
  std::optional<Error> error_;
};

}  // namespace

ProjectorMetadata metadataOf(const ProjectorInfo& info) {
  ProjectorMetadata metadata;
  metadata["format"] = kFormat;
  metadata["version"] = std::to_string(kProjectorFormatMajor) + "." + std::to_string(kProjectorFormatMinor);
  metadata["model"] = info.model;
  metadata["scale"] = formatNumber(info.scale);
  metadata["weights"] = info.weights == BlendWeights::kPaper ? "paper" : "smooth";
  metadata["radius_m"] = formatNumber(info.radius_m);
  metadata["outside"] = info.outside == OutsidePolicy::kRigid ? "rigid" : "error";
  metadata["cell_size_m"] = formatNumber(info.lattice.cell_size);
  putPose(metadata, "lattice", info.lattice.blueprint_from_lattice);
  putFrame(metadata, "blueprint", info.blueprint);
  putFrame(metadata, "slam", info.slam);
  putQuality(metadata, "quality_anchor_rms_m", info.quality.anchor_rms_m);
  putQuality(metadata, "quality_anchor_max_m", info.quality.anchor_max_m);
  putQuality(metadata, "quality_leave_one_out_mean_m", info.quality.leave_one_out_mean_m);
  putQuality(metadata, "quality_leave_one_out_median_m", info.quality.leave_one_out_median_m);
  putQuality(metadata, "quality_leave_one_out_max_m", info.quality.leave_one_out_max_m);
  metadata["quality_anchors_used"] = std::to_string(info.quality.anchors_used);
  metadata["quality_folded_tiles"] = std::to_string(info.quality.folded_tiles);
  putText(metadata, "creator", info.creator);
  putText(metadata, "created", info.created);
  putText(metadata, "project", info.project);
  putText(metadata, "note", info.note);
  return metadata;
}

Result<ProjectorInfo> infoOf(const ProjectorMetadata& metadata, const std::string& file_name) {
  MetadataReader reader(metadata, file_name);
  if (reader.text("format") != kFormat) {
    return fail(ErrorCode::kMalformed, "is not a projector file of CAD2SLAM", file_name);
  }
  const std::string version = reader.text("version");
  const std::string_view major = std::string_view(version).substr(0, version.find('.'));
  const std::optional<int> major_number = parseInteger<int>(major);
  if (!major_number || *major_number < 1) return fail(ErrorCode::kMalformed, "has no known version", file_name);
  if (*major_number != kProjectorFormatMajor) {
    return fail(ErrorCode::kMalformed,
                "has format version " + excerpt(version) + "; this program reads " +
                    std::to_string(kProjectorFormatMajor) + ".x",
                file_name);
  }
  ProjectorInfo info;
  info.model = reader.text("model");
  if (info.model != "stretch" && info.model != "rigid") {
    reader.refuse("model", "is " + excerpt(info.model) + ", which is not known");
  }
  info.scale = reader.number("scale");
  info.weights = reader.choice("weights", "smooth", BlendWeights::kSmooth, "paper", BlendWeights::kPaper);
  info.radius_m = reader.number("radius_m");
  info.outside = reader.choice("outside", "error", OutsidePolicy::kError, "rigid", OutsidePolicy::kRigid);
  info.lattice.cell_size = reader.number("cell_size_m");
  info.lattice.blueprint_from_lattice = reader.pose("lattice");
  info.blueprint = reader.frame("blueprint");
  info.slam = reader.frame("slam");
  info.quality.anchor_rms_m = reader.numberOrUnknown("quality_anchor_rms_m");
  info.quality.anchor_max_m = reader.numberOrUnknown("quality_anchor_max_m");
  info.quality.leave_one_out_mean_m = reader.numberOrUnknown("quality_leave_one_out_mean_m");
  info.quality.leave_one_out_median_m = reader.numberOrUnknown("quality_leave_one_out_median_m");
  info.quality.leave_one_out_max_m = reader.numberOrUnknown("quality_leave_one_out_max_m");
  info.quality.anchors_used = reader.count<std::size_t>("quality_anchors_used");
  info.quality.folded_tiles = reader.count<std::size_t>("quality_folded_tiles");
  info.creator = reader.text("creator");
  info.created = reader.text("created");
  info.project = reader.text("project");
  info.note = reader.text("note");
  if (reader.error()) return tl::unexpected(*reader.error());
  return info;
}

}  // namespace cad2slam

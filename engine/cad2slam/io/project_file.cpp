// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/project_file.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/json_reader.h"
#include "cad2slam/io/sha256.h"
#include "cad2slam/io/strict_json.h"
#include "cad2slam/io/text.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <system_error>

namespace cad2slam {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::size_t kLargestFile = std::size_t{8} << 20;
constexpr const char* kFormat = "cad2slam-project";

/// Words for the values of an enumeration, in files and in memory.
template <class Value>
struct Word {
  const char* word;
  Value value;
};
constexpr std::array<Word<Model>, 2> kModels{{{"stretch", Model::kStretch}, {"rigid", Model::kRigid}}};
constexpr std::array<Word<Stiffness>, 5> kStiffnesses{{{"given", Stiffness::kGiven},
                                                       {"auto", Stiffness::kAutomatic},
                                                       {"smooth", Stiffness::kSmooth},
                                                       {"local", Stiffness::kLocal},
                                                       {"loose", Stiffness::kLoose}}};
constexpr std::array<Word<ScaleRule>, 3> kScaleRules{
    {{"to_scale", ScaleRule::kToScale}, {"least_squares", ScaleRule::kLeastSquares}, {"fixed", ScaleRule::kFixed}}};
constexpr std::array<Word<MapMode>, 3> kModes{
    {{"trinary", MapMode::kTrinary}, {"scale", MapMode::kScale}, {"raw", MapMode::kRaw}}};
constexpr std::array<Word<bool>, 2> kFrames{{{"blueprint", true}, {"slam", false}}};

template <class Value, std::size_t count>
Value valueOf(const JsonReader& reader, const std::array<Word<Value>, count>& words, Value otherwise) {
  if (!reader.exists()) return otherwise;
  const std::string text = reader.text();
  for (const Word<Value>& word : words) {
    if (text == word.word) return word.value;
  }
  reader.report("is not one of the words known here");
  return otherwise;
}

template <class Value, std::size_t count>
const char* wordOf(Value value, const std::array<Word<Value>, count>& words) {
  const auto place =
      std::find_if(words.begin(), words.end(), [value](const auto& word) { return word.value == value; });
  return place == words.end() ? words[0].word : place->word;
}

// --- Reading ---------------------------------------------------------------------------------------------------------

fs::path folderOf(const fs::path& project) {
  std::error_code error;
  const fs::path absolute = fs::absolute(project, error);
  return (error ? project : absolute).parent_path().lexically_normal();
}

fs::path readPath(const JsonReader& reader, const fs::path& folder) {
  const std::string text = reader.text();
  if (text.empty()) return {};
  if (text.find('\0') != std::string::npos) {
    reader.report("is no file name");
    return {};
  }
  return (folder / text).lexically_normal();
}

double numberIn(const NumberRange& range, const JsonReader& reader, double otherwise) {
  return reader.number(otherwise, range.least, range.most);
}

Eigen::Vector2d readPoint(const JsonReader& reader) {
  if (reader.required().size() != 2) {
    reader.report("must be a list of two numbers");
    return Eigen::Vector2d::Zero();
  }
  return {reader.at(0).number(0.0), reader.at(1).number(0.0)};
}

std::string readSha256(const JsonReader& reader) {
  const std::string hex = reader.text();
  const bool is_hex =
      std::all_of(hex.begin(), hex.end(), [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
  if (!hex.empty() && (hex.size() != 64 || !is_hex)) reader.report("must be 64 hexadecimal digits");
  return hex;
}

ProjectRaster readRaster(const JsonReader& reader, const fs::path& folder) {
  ProjectRaster raster;
  if (reader.isNull()) return raster;
  MapMetadata& metadata = raster.metadata;
  metadata.image = readPath(reader["image"].required(), folder);
  metadata.yaml = readPath(reader["yaml"], folder);
  metadata.resolution_m_per_px = numberIn(kResolutionRange, reader["resolution_m_per_px"].required(), 0.05);
  const JsonReader origin = reader["origin"];
  if (origin.required().size() == 3) {
    metadata.metric_from_corner = {{origin.at(0).number(0.0), origin.at(1).number(0.0)}, origin.at(2).number(0.0)};
  } else {
    origin.report("must be a list of three numbers: x, y, yaw");
  }
  metadata.occupied_threshold = reader["occupied_thresh"].number(metadata.occupied_threshold, 0.0, 1.0);
  metadata.free_threshold = reader["free_thresh"].number(metadata.free_threshold, 0.0, 1.0);
  if (metadata.free_threshold > metadata.occupied_threshold) {
    reader["free_thresh"].report("must not be above occupied_thresh");
  }
  metadata.negate = reader["negate"].flag(metadata.negate);
  metadata.mode = valueOf(reader["mode"], kModes, metadata.mode);
  metadata.mirrored = reader["mirrored"].flag(metadata.mirrored);
  raster.image_bytes = reader["image_bytes"].integer<std::uintmax_t>(0);
  raster.image_sha256 = readSha256(reader["image_sha256"]);
  return raster;
}

AnchorList readAnchorList(const JsonReader& reader) {
  AnchorList anchors;
  std::set<AnchorId> ids;
  const std::size_t count = reader.size();
  for (std::size_t k = 0; k < count; ++k) {
    const JsonReader item = reader.at(k);
    Anchor anchor;
    anchor.id = item["id"].required().integer<AnchorId>(0, 0, kLargestAnchorId);
    anchor.in_blueprint = readPoint(item["blueprint"]);
    anchor.in_slam = readPoint(item["slam"]);
    anchor.enabled = item["enabled"].flag(true);
    anchor.name = item["name"].text();
    anchor.note = item["note"].text();
    if (!ids.insert(anchor.id).second) item["id"].report("stands twice: " + std::to_string(anchor.id));
    anchors.push_back(std::move(anchor));
  }
  return anchors;
}

std::optional<PendingAnchor> readPending(const JsonReader& reader) {
  if (reader.isNull()) return std::nullopt;
  PendingAnchor pending;
  pending.in_blueprint = valueOf(reader["frame"].required(), kFrames, true);
  const Eigen::Vector2d point = readPoint(reader["point"]);
  pending.x_m = point.x();
  pending.y_m = point.y();
  return pending;
}

SolverSettings readSettings(const JsonReader& reader) {
  if (!reader.exists()) return {};
  SolverSettings settings = defaultSettings(valueOf(reader["model"], kModels, Model::kStretch));
  settings.stiffness = valueOf(reader["stiffness"], kStiffnesses, settings.stiffness);
  settings.scale.rule = valueOf(reader["scale_rule"], kScaleRules, settings.scale.rule);
  settings.scale.fixed_scale = numberIn(kFixedScaleRange, reader["fixed_scale"], settings.scale.fixed_scale);
  const auto weight = [&](const char* key, double& value) { value = numberIn(kWeightRange, reader[key], value); };
  const auto optional_weight = [&](const char* key, std::optional<double>& value) {
    if (reader[key].exists()) value = reader[key].optionalNumber(kWeightRange.least, kWeightRange.most);
  };
  weight("lambda_x", settings.lambda_x);
  weight("lambda_y", settings.lambda_y);
  optional_weight("lambda_theta", settings.lambda_theta);
  weight("lambda_stretch", settings.lambda_stretch);
  weight("prior_strength", settings.prior_strength);
  weight("anchor_information", settings.anchor_information);
  optional_weight("loss_width_m", settings.loss_width_m);
  settings.max_iterations = reader["max_iterations"].integer(settings.max_iterations, 1, 1'000'000);
  settings.gradient_tolerance = reader["gradient_tolerance"].number(settings.gradient_tolerance, 0.0, 1.0);
  return settings;
}

Result<void> checkFormat(const JsonReader& document, const std::string& file_name) {
  const bool is_project = document.value().is_object() && document.value().value("format", json()) == kFormat;
  if (!is_project) return fail(ErrorCode::kMalformed, "is not a project of CAD2SLAM", file_name);
  const int version = document["version"].required().integer<int>(0, 1);
  if (version <= kProjectFormatVersion) return {};
  return fail(ErrorCode::kMalformed,
              "was written by a newer program (format " + std::to_string(version) + "); this one reads format " +
                  std::to_string(kProjectFormatVersion),
              file_name);
}

// --- Writing ---------------------------------------------------------------------------------------------------------

std::string writtenPath(const fs::path& path, const fs::path& folder) {
  if (path.empty()) return {};
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error).lexically_normal();
  if (error) return path.generic_string();
  const fs::path relative = absolute.lexically_relative(folder);
  const bool is_below = !relative.empty() && *relative.begin() != "..";
  return (is_below ? relative : absolute).generic_string();
}

ordered_json pointJson(double x, double y) {
  return ordered_json::array({x, y});
}

template <class Number>
ordered_json optionalJson(const std::optional<Number>& number) {
  return number ? ordered_json(*number) : ordered_json();
}

ordered_json rasterJson(const ProjectRaster& raster, const fs::path& folder) {
  const MapMetadata& metadata = raster.metadata;
  if (metadata.image.empty()) return nullptr;
  const Pose2& origin = metadata.metric_from_corner;
  ordered_json text;
  text["image"] = writtenPath(metadata.image, folder);
  text["yaml"] = writtenPath(metadata.yaml, folder);
  text["image_bytes"] = raster.image_bytes;
  text["image_sha256"] = raster.image_sha256;
  text["resolution_m_per_px"] = metadata.resolution_m_per_px;
  text["origin"] = ordered_json::array({origin.translation.x(), origin.translation.y(), origin.heading});
  text["occupied_thresh"] = metadata.occupied_threshold;
  text["free_thresh"] = metadata.free_threshold;
  text["negate"] = metadata.negate;
  text["mode"] = wordOf(metadata.mode, kModes);
  text["mirrored"] = metadata.mirrored;
  return text;
}

ordered_json anchorJson(const Anchor& anchor) {
  ordered_json text;
  text["id"] = anchor.id;
  text["blueprint"] = pointJson(anchor.in_blueprint.x(), anchor.in_blueprint.y());
  text["slam"] = pointJson(anchor.in_slam.x(), anchor.in_slam.y());
  text["enabled"] = anchor.enabled;
  text["name"] = anchor.name;
  text["note"] = anchor.note;
  return text;
}

ordered_json slamMapJson(const ProjectSlamMap& map, const fs::path& folder) {
  ordered_json text;
  text["name"] = map.name;
  text["raster"] = rasterJson(map.raster, folder);
  text["anchors"] = ordered_json::array();
  for (const Anchor& anchor : map.anchors) text["anchors"].push_back(anchorJson(anchor));
  text["pending"] = nullptr;
  if (map.pending) {
    text["pending"] = {{"frame", wordOf(map.pending->in_blueprint, kFrames)},
                       {"point", pointJson(map.pending->x_m, map.pending->y_m)}};
  }
  return text;
}

ordered_json settingsJson(const SolverSettings& settings) {
  ordered_json text;
  text["model"] = wordOf(settings.model, kModels);
  text["stiffness"] = wordOf(settings.stiffness, kStiffnesses);
  text["scale_rule"] = wordOf(settings.scale.rule, kScaleRules);
  text["fixed_scale"] = settings.scale.fixed_scale;
  text["lambda_x"] = settings.lambda_x;
  text["lambda_y"] = settings.lambda_y;
  text["lambda_theta"] = optionalJson(settings.lambda_theta);
  text["lambda_stretch"] = settings.lambda_stretch;
  text["prior_strength"] = settings.prior_strength;
  text["anchor_information"] = settings.anchor_information;
  text["loss_width_m"] = optionalJson(settings.loss_width_m);
  text["max_iterations"] = settings.max_iterations;
  text["gradient_tolerance"] = settings.gradient_tolerance;
  return text;
}

void addUnknownKeys(ordered_json& text, const json& read);

/// The same for the elements of a list; those with the same name or id are the same thing.
void addUnknownKeysOfElements(ordered_json& list, const json& read, const char* identity) {
  if (!list.is_array() || !read.is_array()) return;
  std::map<std::string, const json*> read_elements;
  for (const json& element : read) {
    if (element.is_object() && element.contains(identity)) read_elements.emplace(element[identity].dump(), &element);
  }
  for (ordered_json& element : list) {
    const auto place = read_elements.find(element[identity].dump());
    if (place != read_elements.end()) addUnknownKeys(element, *place->second);
  }
}

/// Adds to `text` the keys of the document as it was read that this program knows nothing of, wherever the object they
/// stood in still exists.
void addUnknownKeys(ordered_json& text, const json& read) {
  if (!text.is_object() || !read.is_object()) return;
  auto& members = text.get_ref<ordered_json::object_t&>();
  const std::size_t known = members.size();
  const auto known_end = [&] { return members.begin() + static_cast<std::ptrdiff_t>(known); };
  for (const auto& [key, value] : read.items()) {
    const auto mine =
        std::find_if(members.begin(), known_end(), [&key = key](const auto& m) { return m.first == key; });
    if (mine == known_end()) {
      // Not members[key], which would look through all that were added before.
      static_cast<ordered_json::object_t::Container&>(members).emplace_back(key, ordered_json(value));
    } else if (key == "slam_maps" || key == "anchors") {
      addUnknownKeysOfElements(mine->second, value, key == "anchors" ? "id" : "name");
    } else if (key != "view") {
      addUnknownKeys(mine->second, value);
    }
  }
}

/// JSON is Unicode; a file name need not be.
Result<void> checkNames(const ProjectRaster& raster, const fs::path& project) {
  for (const fs::path& path : {raster.metadata.image, raster.metadata.yaml}) {
    if (!isUtf8(path.string())) {
      return fail(ErrorCode::kUnwritable, "cannot name the file " + excerpt(path.string()) + ", which is not UTF-8",
                  project.string());
    }
  }
  return {};
}

json documentOr(const std::string& text, json otherwise) {
  const Result<json> document = parseStrictJson(text, {});
  return document && document->is_object() ? *document : std::move(otherwise);
}

}  // namespace

Result<Project> parseProject(const std::string& text, const fs::path& path) {
  const std::string file_name = path.string();
  if (text.size() > kLargestFile) return fail(ErrorCode::kMalformed, "is too large for a project", file_name);
  const Result<json> document = parseStrictJson(text, file_name);
  if (!document) return failAs(document);
  JsonProblem problem(file_name);
  const JsonReader reader(&*document, {}, problem);
  if (const Result<void> known = checkFormat(reader, file_name); !known) return failAs(known);

  const fs::path folder = folderOf(path);
  Project project;
  project.name = reader["name"].text();
  project.app_version = reader["app_version"].text();
  project.blueprint = readRaster(reader["blueprint"].required(), folder);
  const JsonReader maps = reader["slam_maps"];
  std::set<std::string> names;
  const std::size_t count = maps.required().size();
  for (std::size_t k = 0; k < count; ++k) {
    const JsonReader item = maps.at(k);
    ProjectSlamMap map;
    map.name = item["name"].required().text();
    if (map.name.empty()) item["name"].report("must not be empty");
    if (!names.insert(map.name).second) item["name"].report("is the name of another map, too: " + excerpt(map.name));
    map.raster = readRaster(item["raster"].required(), folder);
    map.anchors = readAnchorList(item["anchors"]);
    map.pending = readPending(item["pending"]);
    project.slam_maps.push_back(std::move(map));
  }
  project.settings = readSettings(reader["solver"]);
  project.cell_size_m = reader["cell_size_m"].optionalNumber(kCellSizeRange.least, kCellSizeRange.most);
  const JsonReader view = reader["view"];
  if (!view.isNull()) {
    if (!view.value().is_object()) view.report("must be an object");
    project.view_state_json = view.value().dump();
  }
  if (problem.error()) return tl::unexpected(*problem.error());
  project.unknown_keys_json = document->dump();
  return project;
}

Result<Project> readProject(const fs::path& path) {
  const Result<std::string> text = readFile(path, kLargestFile);
  if (!text) return failAs(text);
  return parseProject(*text, path);
}

std::string formatProject(const Project& project, const fs::path& path) {
  const fs::path folder = folderOf(path);
  ordered_json text;
  text["format"] = kFormat;
  text["version"] = kProjectFormatVersion;
  text["app_version"] = project.app_version;
  text["name"] = project.name;
  text["blueprint"] = rasterJson(project.blueprint, folder);
  text["slam_maps"] = ordered_json::array();
  for (const ProjectSlamMap& map : project.slam_maps) text["slam_maps"].push_back(slamMapJson(map, folder));
  text["cell_size_m"] = optionalJson(project.cell_size_m);
  text["solver"] = settingsJson(project.settings);
  text["view"] = documentOr(project.view_state_json, json::object());
  addUnknownKeys(text, documentOr(project.unknown_keys_json, json::object()));
  return text.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

Result<void> writeProject(const fs::path& path, const Project& project) {
  const std::string text = formatProject(project, path);
  for (const ProjectSlamMap& map : project.slam_maps) {
    if (const Result<void> named = checkNames(map.raster, path); !named) return named;
  }
  if (const Result<void> named = checkNames(project.blueprint, path); !named) return named;
  // What cannot be read again must not replace what can.
  if (const Result<Project> read = parseProject(text, path); !read) {
    return fail(ErrorCode::kUnwritable, "cannot be written: " + read.error().message, path.string());
  }
  return writeFileAtomically(path, text);
}

Result<ProjectRaster> describeRaster(const MapMetadata& metadata) {
  const Result<std::string> hash = sha256HexOfFile(metadata.image);
  if (!hash) return failAs(hash);
  std::error_code error;
  ProjectRaster raster;
  raster.metadata = metadata;
  raster.image_bytes = fs::file_size(metadata.image, error);
  if (error) return fail(ErrorCode::kUnreadable, "cannot be read (" + error.message() + ")", metadata.image.string());
  raster.image_sha256 = *hash;
  return raster;
}

RasterState checkRaster(const ProjectRaster& raster) {
  std::error_code error;
  if (!fs::is_regular_file(raster.metadata.image, error)) return RasterState::kMissing;
  if (raster.image_sha256.empty()) return RasterState::kUnchanged;
  if (fs::file_size(raster.metadata.image, error) != raster.image_bytes || error) return RasterState::kChanged;
  const Result<std::string> hash = sha256HexOfFile(raster.metadata.image);
  if (!hash) return RasterState::kMissing;
  return *hash == raster.image_sha256 ? RasterState::kUnchanged : RasterState::kChanged;
}

}  // namespace cad2slam

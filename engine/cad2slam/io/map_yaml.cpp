// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/map_yaml.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/guarded_yaml.h"
#include "cad2slam/io/text.h"

#include <algorithm>
#include <map>
#include <optional>

namespace cad2slam {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestText = std::size_t{64} << 10;

/// What stands behind one key: one scalar, or a list of scalars, or something else that no key here means.
struct Entry {
  int line = 0;
  bool is_plain = true;  ///< only scalars, at most one list of them
  bool is_list = false;
  std::vector<std::string> values;
};

/// Collects the top-level keys straight from the parser's events: no tree is built.
class TopLevelKeys : public GuardedYamlEvents {
 public:
  [[nodiscard]] const std::map<std::string, Entry>& entries() const { return entries_; }

 private:
  void onOpen(int line, bool is_map) override {
    if (depth() == 0 && !is_map) throw YamlRefusal{line, "a map needs lines such as `image: map.pgm`"};
    if (depth() == 1 && entry_ == nullptr) throw YamlRefusal{line, "a key must be a word"};
    if (depth() == 1) {
      entry_->is_list = true;
      entry_->is_plain = !is_map;
    } else if (depth() > 1) {
      entry_->is_plain = false;
    }
  }
  void onClose() override {
    if (depth() == 1) entry_ = nullptr;
  }
  void onValue(int line, const std::string& value) override {
    if (depth() == 0) throw YamlRefusal{line, "a map needs lines such as `image: map.pgm`"};
    if (depth() == 1 && entry_ == nullptr) {
      const auto [place, is_new] = entries_.emplace(value, Entry{line, true, false, {}});
      if (!is_new) {
        throw YamlRefusal{
            line, "the key " + excerpt(value) + " already stands in line " + std::to_string(place->second.line)};
      }
      entry_ = &place->second;
      return;
    }
    entry_->values.push_back(value);
    if (depth() == 1) entry_ = nullptr;
  }

  std::map<std::string, Entry> entries_;
  Entry* entry_ = nullptr;  // whose value is being read
};

/// Typed access to the keys; every failure names file, line and key.
class KeyReader {
 public:
  KeyReader(const std::map<std::string, Entry>& entries, std::string file_name)
      : entries_(entries), file_name_(std::move(file_name)) {}

  [[nodiscard]] const Entry* find(const std::string& key) const {
    const auto place = entries_.find(key);
    return place == entries_.end() ? nullptr : &place->second;
  }
  [[nodiscard]] tl::unexpected<Error> refuse(const std::string& key, const std::string& message) const {
    const Entry* entry = find(key);
    if (entry == nullptr) return fail(ErrorCode::kMalformed, "the key " + key + " is missing", file_name_);
    return fail(ErrorCode::kMalformed, key + " " + message, file_name_ + ":" + std::to_string(entry->line));
  }
  [[nodiscard]] Result<std::string> word(const std::string& key) const {
    const Entry* entry = find(key);
    if (entry == nullptr || !entry->is_plain || entry->is_list) return refuse(key, "must be one value, not a list");
    return entry->values.empty() ? std::string() : entry->values.front();
  }
  [[nodiscard]] Result<double> number(const std::string& key, double least, double most) const {
    const Result<std::string> text = word(key);
    if (!text) return failAs(text);
    const std::optional<double> value = parseNumber(trimmed(*text));
    if (!value || *value < least || *value > most) {
      return refuse(key, "must be a number from " + formatNumber(least) + " to " + formatNumber(most) + ", not " +
                             excerpt(*text));
    }
    return *value;
  }

 private:
  const std::map<std::string, Entry>& entries_;
  std::string file_name_;
};

bool isNan(std::string_view text) {
  const std::string word = lowerCase(trimmed(text));
  return word == ".nan" || word == "-.nan" || word == "nan" || word == "-nan";
}

/// A whole number or a word of YAML 1.1, as map_server reads it.
std::optional<bool> parseNegate(std::string_view text) {
  if (const std::optional<int> number = parseInteger<int>(text)) return *number != 0;
  const std::string word = lowerCase(text);
  if (word == "true" || word == "yes" || word == "on" || word == "y") return true;
  if (word == "false" || word == "no" || word == "off" || word == "n") return false;
  return std::nullopt;
}

Result<Pose2> readOrigin(const KeyReader& keys, std::vector<std::string>& warnings) {
  const Entry* entry = keys.find("origin");
  if (entry == nullptr || !entry->is_list || !entry->is_plain || entry->values.size() != 3) {
    return keys.refuse("origin", "must be a list of three numbers [x, y, yaw]");
  }
  double numbers[3] = {};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string& text = entry->values[k];
    const std::optional<double> number = parseNumber(trimmed(text));
    if (!number && !(k == 2 && isNan(text)))
      return keys.refuse("origin", "holds " + excerpt(text) + ", no finite number");
    if (!number) warnings.emplace_back("The yaw of origin is not a number and was read as 0.");
    numbers[k] = number.value_or(0.0);
  }
  if (numbers[2] != 0.0) {
    warnings.push_back("The map is turned by a yaw of " + formatNumber(numbers[2]) +
                       " rad in origin: RViz shows that, navigation and localisation of ROS ignore it.");
  }
  return Pose2{{numbers[0], numbers[1]}, numbers[2]};
}

Result<MapYaml> readKeys(const KeyReader& keys, const fs::path& yaml) {
  MapYaml result;
  MapMetadata& metadata = result.metadata;
  metadata.yaml = yaml;

  const Result<std::string> image = keys.word("image");
  if (!image) return failAs(image);
  if (image->empty()) return keys.refuse("image", "must name an image file");
  if (image->find('\0') != std::string::npos) return keys.refuse("image", "is no file name: " + excerpt(*image));
  metadata.image = yaml.parent_path() / *image;  // an absolute name stays as it is

  const Result<double> resolution = keys.number("resolution", kResolutionRange.least, kResolutionRange.most);
  if (!resolution) return failAs(resolution);
  metadata.resolution_m_per_px = *resolution;

  const Result<Pose2> origin = readOrigin(keys, result.warnings);
  if (!origin) return failAs(origin);
  metadata.metric_from_corner = *origin;

  const Result<double> occupied_threshold = keys.number("occupied_thresh", 0.0, 1.0);
  if (!occupied_threshold) return failAs(occupied_threshold);
  const Result<double> free_threshold = keys.number("free_thresh", 0.0, 1.0);
  if (!free_threshold) return failAs(free_threshold);
  if (*free_threshold > *occupied_threshold) {
    return keys.refuse("free_thresh",
                       "must not be above occupied_thresh, which is " + formatNumber(*occupied_threshold));
  }
  metadata.occupied_threshold = *occupied_threshold;
  metadata.free_threshold = *free_threshold;

  const Result<std::string> negate = keys.word("negate");
  if (!negate) return failAs(negate);
  const std::optional<bool> is_negated = parseNegate(trimmed(*negate));
  if (!is_negated) return keys.refuse("negate", "must be 0 or 1, not " + excerpt(*negate));
  metadata.negate = *is_negated;

  if (keys.find("mode") != nullptr) {
    const Result<std::string> mode = keys.word("mode");
    if (!mode) return failAs(mode);
    if (*mode == "trinary") {
      metadata.mode = MapMode::kTrinary;
    } else if (*mode == "scale") {
      metadata.mode = MapMode::kScale;
    } else if (*mode == "raw") {
      metadata.mode = MapMode::kRaw;
    } else {
      return keys.refuse("mode", "must be trinary, scale or raw, not " + excerpt(*mode));
    }
  }
  return result;
}

/// A number that every YAML reader takes for one: YAML 1.1 wants a point before an exponent.
std::string yamlNumber(double value) {
  std::string text = formatNumber(value);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) text.insert(exponent, ".0");
  return text;
}

/// Quoted unless it is certainly a plain word.
std::string yamlWord(const std::string& word) {
  const bool is_plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '.' ||
           c == '/';
  });
  if (is_plain) return word;
  constexpr char kDigits[] = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : word) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20U || byte == 0x7fU) {
      quoted += "\\x";
      quoted += kDigits[byte >> 4];
      quoted += kDigits[byte & 15U];
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace

Result<MapYaml> parseMapYaml(const std::string& text, const fs::path& yaml) {
  const std::string name = yaml.string();
  if (text.size() > kLargestText) return fail(ErrorCode::kMalformed, "is too large for a map YAML", name);
  TopLevelKeys keys;
  if (const Result<void> read = readYamlEvents(text, name, keys); !read) return failAs(read);
  if (keys.entries().empty())
    return fail(ErrorCode::kMalformed, "holds no map: image and resolution are missing", name);
  return readKeys(KeyReader(keys.entries(), name), yaml);
}

Result<MapYaml> readMapYaml(const fs::path& yaml) {
  const Result<std::string> text = readFile(yaml, kLargestText);
  if (!text) return failAs(text);
  return parseMapYaml(*text, yaml);
}

std::string formatMapYaml(const MapMetadata& metadata, const std::string& image_name) {
  const Pose2& origin = metadata.metric_from_corner;
  const char* mode = metadata.mode == MapMode::kScale ? "scale" : metadata.mode == MapMode::kRaw ? "raw" : "trinary";
  return "image: " + yamlWord(image_name) + "\nmode: " + mode +
         "\nresolution: " + yamlNumber(metadata.resolution_m_per_px) + "\norigin: [" +
         yamlNumber(origin.translation.x()) + ", " + yamlNumber(origin.translation.y()) + ", " +
         yamlNumber(origin.heading) + "]\nnegate: " + (metadata.negate ? "1" : "0") +
         "\noccupied_thresh: " + yamlNumber(metadata.occupied_threshold) +
         "\nfree_thresh: " + yamlNumber(metadata.free_threshold) + "\n";
}

}  // namespace cad2slam

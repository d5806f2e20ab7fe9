// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/feature_csv.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/delimited_text.h"
#include "cad2slam/io/geojson_file.h"
#include "cad2slam/io/text.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace cad2slam {
namespace {

constexpr std::size_t kLargestText = std::size_t{1} << 28;
constexpr std::array<const char*, 3> kKinds = {"point", "path", "polygon"};

/// Puts the lines of a file together to features; remembers the first thing that is wrong.
class FeatureAssembly {
 public:
  FeatureAssembly(std::map<std::string, std::size_t> columns, std::string file_name)
      : columns_(std::move(columns)), file_name_(std::move(file_name)) {}

  [[nodiscard]] Result<void> add(const TextRecord& record) {
    const auto refuse = [&](const std::string& message) {
      return fail(ErrorCode::kMalformed, message, file_name_ + ":" + std::to_string(record.line));
    };
    const auto field = [&](const char* name) {
      const auto column = columns_.find(name);
      if (column == columns_.end() || column->second >= record.fields.size()) return std::string();
      return record.fields[column->second];
    };
    const std::optional<double> x = parseNumber(field("x"));
    const std::optional<double> y = parseNumber(field("y"));
    if (!x || !y) return refuse("x and y must be finite numbers in metres");
    const std::string id = field("feature");
    const std::string part = field("part");
    if (id.empty() || id != id_ || features_.empty()) {
      if (!id.empty() && seen_.count(id) > 0) {
        return refuse("the lines of feature " + excerpt(id) + " do not stand together");
      }
      const std::string kind = field("kind").empty() ? kKinds[0] : lowerCase(field("kind"));
      const auto known = std::find(kKinds.begin(), kKinds.end(), kind);
      if (known == kKinds.end()) return refuse("the kind must be point, path or polygon, not " + excerpt(kind));
      Feature feature;
      feature.kind = static_cast<FeatureKind>(known - kKinds.begin());
      feature.name = field("name");
      features_.push_back(std::move(feature));
      first_lines_.push_back(record.line);
      if (!id.empty()) seen_.insert(id);
    }
    Feature& feature = features_.back();
    if (feature.parts.empty() || part != part_ || feature.kind == FeatureKind::kPoint) feature.parts.emplace_back();
    feature.parts.back().emplace_back(*x, *y);
    if (const std::string theta = field("theta"); !theta.empty()) {
      feature.heading = parseNumber(theta);
      if (!feature.heading) return refuse("theta must be a finite number in radians");
    }
    id_ = id;
    part_ = part;
    return {};
  }

  [[nodiscard]] Result<FeatureList> finish() {
    for (std::size_t k = 0; k < features_.size(); ++k) {
      Feature& feature = features_[k];
      feature.multiple = feature.parts.size() > 1 && feature.kind != FeatureKind::kPolygon;
      if (feature.kind != FeatureKind::kPoint) feature.heading.reset();
      const std::size_t least = feature.kind == FeatureKind::kPoint ? 1 : feature.kind == FeatureKind::kPath ? 2 : 3;
      for (PointList& part : feature.parts) {
        const bool closed = feature.kind == FeatureKind::kPolygon;
        while (closed && part.size() > 1 && part.front() == part.back()) part.pop_back();
        if (part.size() >= least) continue;
        return fail(ErrorCode::kMalformed, "a part of this feature has fewer than " + std::to_string(least) + " places",
                    file_name_ + ":" + std::to_string(first_lines_[k]));
      }
    }
    return std::move(features_);
  }

 private:
  std::map<std::string, std::size_t> columns_;
  std::string file_name_;
  FeatureList features_;
  std::vector<std::size_t> first_lines_;
  std::set<std::string> seen_;
  std::string id_;
  std::string part_;
};

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r#") == std::string::npos && trimmed(text) == text) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

}  // namespace

Result<FeatureList> parseFeatureCsv(std::string_view text, const std::string& file_name) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  if (!isUtf8(text)) return fail(ErrorCode::kMalformed, "is no UTF-8 text", file_name);
  const std::string_view first_line = text.substr(0, text.find('\n'));
  const char separator = first_line.find(',') != std::string_view::npos   ? ','
                         : first_line.find(';') != std::string_view::npos ? ';'
                                                                          : '\t';
  RecordReader reader(text, separator);
  const std::optional<TextRecord> header = reader.next();
  if (!header) return fail(ErrorCode::kMalformed, "holds no features: it is empty", file_name);
  std::map<std::string, std::size_t> columns;
  for (std::size_t k = 0; k < header->fields.size(); ++k) columns.emplace(lowerCase(header->fields[k]), k);
  if (columns.count("x") == 0 || columns.count("y") == 0) {
    return fail(ErrorCode::kMalformed, "needs a header with the columns x and y",
                file_name + ":" + std::to_string(header->line));
  }
  FeatureAssembly assembly(std::move(columns), file_name);
  while (const std::optional<TextRecord> record = reader.next()) {
    if (!record->complaint.empty()) {
      return fail(ErrorCode::kMalformed, record->complaint, file_name + ":" + std::to_string(record->line));
    }
    if (const Result<void> added = assembly.add(*record); !added) return failAs(added);
  }
  return assembly.finish();
}

Result<FeatureList> readFeatureCsv(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, kLargestText);
  if (!text) return failAs(text);
  return parseFeatureCsv(*text, path.string());
}

std::string formatFeatureCsv(const FeatureList& features) {
  std::string text = "feature,kind,part,x,y,theta,name\n";
  for (std::size_t k = 0; k < features.size(); ++k) {
    const Feature& feature = features[k];
    for (std::size_t part = 0; part < feature.parts.size(); ++part) {
      for (const Eigen::Vector2d& place : feature.parts[part]) {
        text += std::to_string(k + 1) + ',' + kKinds[static_cast<std::size_t>(feature.kind)] + ',' +
                std::to_string(part + 1) + ',' + formatNumber(place.x()) + ',' + formatNumber(place.y()) + ',' +
                (feature.heading ? formatNumber(*feature.heading) : "") + ',' + quoted(feature.name) + '\n';
      }
    }
  }
  return text;
}

Result<FeatureList> readFeatures(const std::filesystem::path& path) {
  return lowerCase(path.extension().string()) == ".csv" ? readFeatureCsv(path) : readGeoJson(path);
}

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/anchors_csv.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/delimited_text.h"
#include "cad2slam/io/qgis_points.h"
#include "cad2slam/io/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace cad2slam {
namespace {

constexpr std::size_t kLargestFile = std::size_t{64} << 20;
/// More lines that are no anchors are not worth listing: it is some other file.
constexpr std::size_t kMostRejected = 10'000;

enum Column : std::size_t { kId, kBlueprintX, kBlueprintY, kSlamX, kSlamY, kEnabled, kName, kNote, kColumnCount };
constexpr std::array<std::string_view, kColumnCount> kColumnNames{"id",     "blueprint_x", "blueprint_y", "slam_x",
                                                                  "slam_y", "enabled",     "name",        "note"};
constexpr std::array<Column, 4> kCoordinates{kBlueprintX, kBlueprintY, kSlamX, kSlamY};

/// Where each column stands in a record; without a header: in the order of the format.
struct Layout {
  std::array<std::optional<std::size_t>, kColumnCount> position;

  static Layout inOrder() {
    Layout layout;
    for (std::size_t column = 0; column < kColumnCount; ++column) layout.position[column] = column;
    return layout;
  }

  /// Empty where no field names a coordinate: then the record is no header.
  static std::optional<Result<Layout>> fromHeader(const TextRecord& record, const std::string& where) {
    Layout layout;
    bool is_header = false;
    std::optional<Result<Layout>> failure;
    for (std::size_t field = 0; field < record.fields.size(); ++field) {
      const auto name = std::find(kColumnNames.begin(), kColumnNames.end(), lowerCase(record.fields[field]));
      if (name == kColumnNames.end()) continue;
      const auto column = static_cast<std::size_t>(name - kColumnNames.begin());
      is_header = is_header || std::find(kCoordinates.begin(), kCoordinates.end(), column) != kCoordinates.end();
      if (layout.position[column]) {
        failure =
            fail(ErrorCode::kMalformed, "the column " + std::string(*name) + " stands twice in the header", where);
      }
      layout.position[column] = field;
    }
    if (!is_header) return std::nullopt;
    if (failure) return failure;
    for (const Column column : kCoordinates) {
      if (!layout.position[column]) {
        return fail(ErrorCode::kMalformed,
                    "the header has no column " + std::string(kColumnNames[column]) + ", which anchors need", where);
      }
    }
    return layout;
  }

  /// Whether a '#' after a blank starts a comment in this field: not where it may be part of a name.
  [[nodiscard]] bool holdsText(std::size_t field) const { return field == position[kName] || field == position[kNote]; }
};

/// Text from a spreadsheet that does not write UTF-8: taken as Latin-1, in which every byte is a character.
std::string utf8From(std::string_view text) {
  if (isUtf8(text)) return std::string(text);
  std::string utf8;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80U) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xC0U | (byte >> 6));
      utf8 += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return utf8;
}

/// One anchor of a record, or why it is none. An absent id is left 0.
tl::expected<Anchor, std::string> parseAnchor(const TextRecord& record, const Layout& layout, char separator) {
  if (!record.complaint.empty()) return tl::unexpected(record.complaint);
  const auto field = [&](Column column) -> std::string_view {
    const std::optional<std::size_t> at = layout.position[column];
    return at && *at < record.fields.size() ? std::string_view(record.fields[*at]) : std::string_view();
  };
  std::size_t needed = layout.position[kId] ? *layout.position[kId] : 0;
  for (const Column column : kCoordinates) needed = std::max(needed, *layout.position[column]);
  if (record.fields.size() <= needed) {
    return tl::unexpected("has " + std::to_string(record.fields.size()) + " of at least " + std::to_string(needed + 1) +
                          " fields");
  }
  Anchor anchor;
  if (layout.position[kId]) {
    const std::optional<AnchorId> id = parseInteger<AnchorId>(field(kId));
    if (!id) return tl::unexpected("the id " + excerpt(field(kId)) + " is not a whole number");
    if (*id < 0 || *id > kLargestAnchorId) {
      return tl::unexpected("the id " + excerpt(field(kId)) + " is not from 0 to " + std::to_string(kLargestAnchorId));
    }
    anchor.id = *id;
  }
  std::array<double, kCoordinates.size()> coordinates{};
  for (std::size_t k = 0; k < kCoordinates.size(); ++k) {
    std::string text(field(kCoordinates[k]));
    if (separator != ',' && std::count(text.begin(), text.end(), ',') == 1 && text.find('.') == std::string::npos) {
      std::replace(text.begin(), text.end(), ',', '.');
    }
    const std::optional<double> number = parseNumber(text);
    if (!number) {
      return tl::unexpected(std::string(kColumnNames[kCoordinates[k]]) + " " + excerpt(field(kCoordinates[k])) +
                            " is not a finite number");
    }
    if (std::abs(*number) > kLargestCoordinate) {
      return tl::unexpected(std::string(kColumnNames[kCoordinates[k]]) + " " + excerpt(field(kCoordinates[k])) +
                            " is too large for a coordinate");
    }
    coordinates[k] = *number;
  }
  anchor.in_blueprint = {coordinates[0], coordinates[1]};
  anchor.in_slam = {coordinates[2], coordinates[3]};
  const std::optional<bool> enabled = parseSwitch(field(kEnabled));
  if (!enabled) return tl::unexpected("enabled is " + excerpt(field(kEnabled)) + ", not 1 or 0");
  anchor.enabled = *enabled;
  anchor.name = utf8From(field(kName));
  anchor.note = utf8From(field(kNote));
  return anchor;
}

/// The separator of the first line that makes sense with one. The order matters: `1;2,5;...` holds commas, too.
char findSeparator(std::string_view text) {
  constexpr std::array kSeparators{';', '\t', ',', ' '};
  const Layout in_order = Layout::inOrder();
  std::size_t tried = 0;
  for (std::size_t begin = 0; begin < text.size() && tried <= kMostRejected; ++tried) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    for (const char separator : kSeparators) {
      const auto record = RecordReader(text.substr(begin, end - begin), separator).next();
      if (!record) break;  // blank or comment
      if (Layout::fromHeader(*record, {}) || parseAnchor(*record, in_order, separator)) return separator;
    }
    begin = end + 1;
  }
  return ',';
}

bool hasPrefix(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

std::string quotedField(const std::string& text) {
  const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '-' ||
           c == '.' || c == ' ' || static_cast<unsigned char>(c) >= 0x80U;
  });
  if (plain && trimmed(text).size() == text.size()) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace

Result<AnchorImport> parseAnchorsCsv(std::string_view text, const std::string& file_name) {
  if (hasPrefix(text, "\xff\xfe") || hasPrefix(text, "\xfe\xff")) {
    return fail(ErrorCode::kMalformed, "is UTF-16 text; save it as UTF-8", file_name);
  }
  text = withoutByteOrderMark(text);

  const char separator = findSeparator(text);
  Layout layout = Layout::inOrder();
  RecordReader reader(text, separator);
  reader.setTextField([&layout](std::size_t field) { return layout.holdsText(field); });

  AnchorImport import;
  std::unordered_map<AnchorId, std::size_t> line_of_id;
  bool may_be_header = true;
  bool has_header = false;
  while (const std::optional<TextRecord> record = reader.next()) {
    const std::string where = file_name + ":" + std::to_string(record->line);
    if (may_be_header && record->complaint.empty()) {
      const std::optional<Result<Layout>> header = Layout::fromHeader(*record, where);
      if (header && !*header) return failAs(*header);
      may_be_header = false;
      if (header) {
        layout = **header;
        has_header = true;
        continue;
      }
    }
    if (import.rejected.size() >= kMostRejected) {
      return fail(ErrorCode::kMalformed, "more than " + std::to_string(kMostRejected) + " lines are no anchors", where);
    }
    tl::expected<Anchor, std::string> anchor = parseAnchor(*record, layout, separator);
    if (!anchor) {
      import.rejected.push_back({record->line, anchor.error()});
      continue;
    }
    if (!layout.position[kId]) anchor->id = static_cast<AnchorId>(import.anchors.size()) + 1;
    const auto [used, is_new] = line_of_id.emplace(anchor->id, record->line);
    if (!is_new) {
      import.rejected.push_back({record->line, "the id " + std::to_string(anchor->id) + " already stands in line " +
                                                   std::to_string(used->second)});
      continue;
    }
    import.anchors.push_back(std::move(*anchor));
  }
  if (import.anchors.empty() && !(has_header && import.rejected.empty())) {
    if (import.rejected.empty()) return fail(ErrorCode::kMalformed, "holds no anchors", file_name);
    return fail(ErrorCode::kMalformed, "no line can be read as an anchor; the first one " + import.rejected[0].reason,
                file_name + ":" + std::to_string(import.rejected[0].line));
  }
  return import;
}

Result<AnchorImport> readAnchorsCsv(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, kLargestFile);
  if (!text) return failAs(text);
  return parseAnchorsCsv(*text, path.string());
}

std::string formatAnchorsCsv(const AnchorList& anchors) {
  std::string text;
  for (const std::string_view name : kColumnNames) {
    if (!text.empty()) text += ',';
    text += name;
  }
  text += '\n';
  for (const Anchor& anchor : anchors) {
    text += std::to_string(anchor.id);
    for (const double number :
         {anchor.in_blueprint.x(), anchor.in_blueprint.y(), anchor.in_slam.x(), anchor.in_slam.y()}) {
      text += ',';
      text += formatNumber(number);
    }
    text += anchor.enabled ? ",1," : ",0,";
    text += quotedField(anchor.name) + ',' + quotedField(anchor.note) + '\n';
  }
  return text;
}

Result<void> writeAnchorsCsv(const std::filesystem::path& path, const AnchorList& anchors) {
  return writeFileAtomically(path, formatAnchorsCsv(anchors));
}

Result<AnchorImport> readAuthorsAnchors(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, kLargestFile);
  if (!text) return failAs(text);
  return parseAuthorsAnchors(*text, path.string());
}

Result<AnchorImport> readAnchors(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, kLargestFile);
  if (!text) return failAs(text);
  if (looksLikeQgisPoints(*text)) {
    return fail(
        ErrorCode::kMalformed,
        "holds points of QGIS, which are pixels of two images; import it in the app with both of them loaded and "
        "export the anchors from there",
        path.string());
  }
  const bool is_authors = text->find("\"CorrespondenceAnchor\"") != std::string::npos;
  return is_authors ? parseAuthorsAnchors(*text, path.string()) : parseAnchorsCsv(*text, path.string());
}

}  // namespace cad2slam

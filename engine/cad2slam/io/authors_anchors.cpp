// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cad2slam {
namespace {

constexpr std::string_view kObjectName = "\"CorrespondenceAnchor\"";
constexpr std::size_t kMostRejected = 10'000;

/// Reads the pieces of one object in turn; knows the line it is in.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

  [[nodiscard]] bool atEnd() const { return at_ == text_.size(); }
  [[nodiscard]] std::size_t line() const { return line_; }

  void skipSpace() {
    while (!atEnd() && (isBlank(text_[at_]) || text_[at_] == '\n' || text_[at_] == '\r')) advance(1);
  }
  bool take(std::string_view token) {
    skipSpace();
    if (text_.substr(at_, token.size()) != token) return false;
    advance(token.size());
    return true;
  }
  void skipTo(std::string_view token) {
    const std::size_t found = std::min(text_.find(token, at_), text_.size());
    advance(found - at_);
  }
  std::optional<double> takeNumber() {
    skipSpace();
    const std::size_t end = std::min(text_.find_first_of(", ]\t\r\n", at_), text_.size());
    const std::optional<double> number = parseNumber(text_.substr(at_, end - at_));
    if (number) advance(end - at_);
    return number;
  }
  [[nodiscard]] std::string ahead() {
    skipSpace();
    return atEnd() ? "the end of the file" : excerpt(text_.substr(at_, text_.substr(at_, 30).find_first_of("\r\n")));
  }

 private:
  void advance(std::size_t count) {
    line_ += static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                                 text_.begin() + static_cast<std::ptrdiff_t>(at_ + count), '\n'));
    at_ += count;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

tl::unexpected<std::string> expectedHere(const char* what, Cursor& cursor) {
  return tl::unexpected(std::string("expected ") + what + " instead of " + cursor.ahead());
}

tl::expected<Eigen::Vector2d, std::string> parsePoint(Cursor& cursor) {
  if (!cursor.take(":")) return expectedHere("':'", cursor);
  if (!cursor.take("[")) return expectedHere("'['", cursor);
  const std::optional<double> x = cursor.takeNumber();
  if (!x) return expectedHere("a finite number", cursor);
  if (!cursor.take(",")) return expectedHere("','", cursor);
  const std::optional<double> y = cursor.takeNumber();
  if (!y) return expectedHere("a finite number", cursor);
  if (!cursor.take("]")) return expectedHere("']'", cursor);
  for (const double number : {*x, *y})
    if (std::abs(number) > kLargestCoordinate)
      return tl::unexpected(formatNumber(number) + " is too large for a coordinate");
  return Eigen::Vector2d(*x, *y);
}

/// What stands between the name of an object and the next one.
tl::expected<Anchor, std::string> parseObject(Cursor& cursor) {
  if (!cursor.take(":")) return expectedHere("':'", cursor);
  if (!cursor.take("{")) return expectedHere("'{'", cursor);
  std::optional<Eigen::Vector2d> in_blueprint;
  std::optional<Eigen::Vector2d> in_slam;
  do {
    const bool is_blueprint = cursor.take("\"_cad_point\"");
    if (!is_blueprint && !cursor.take("\"_slam_point\"")) return expectedHere("_cad_point or _slam_point", cursor);
    std::optional<Eigen::Vector2d>& point = is_blueprint ? in_blueprint : in_slam;
    if (point) return tl::unexpected(is_blueprint ? "_cad_point stands twice" : "_slam_point stands twice");
    const tl::expected<Eigen::Vector2d, std::string> parsed = parsePoint(cursor);
    if (!parsed) return tl::unexpected(parsed.error());
    point = *parsed;
  } while (cursor.take(","));
  if (!cursor.take("}")) return expectedHere("'}'", cursor);
  if (!in_blueprint || !in_slam) return tl::unexpected(in_slam ? "_cad_point is missing" : "_slam_point is missing");
  Anchor anchor;
  anchor.in_blueprint = *in_blueprint;
  anchor.in_slam = *in_slam;
  return anchor;
}

}  // namespace

Result<AnchorImport> parseAuthorsAnchors(std::string_view text, const std::string& file_name) {
  AnchorImport import;
  Cursor cursor(text);
  AnchorId id = 0;
  for (cursor.skipTo(kObjectName); !cursor.atEnd(); cursor.skipTo(kObjectName)) {
    cursor.take(kObjectName);
    ++id;  // a rejected object keeps its number, so that the others keep theirs
    tl::expected<Anchor, std::string> anchor = parseObject(cursor);
    if (anchor) {
      anchor->id = id;
      import.anchors.push_back(std::move(*anchor));
    } else if (import.rejected.size() < kMostRejected) {
      import.rejected.push_back({cursor.line(), anchor.error()});
    } else {
      return fail(ErrorCode::kMalformed, "more than " + std::to_string(kMostRejected) + " objects are no anchors",
                  file_name + ":" + std::to_string(cursor.line()));
    }
  }
  if (import.anchors.empty()) {
    if (import.rejected.empty()) return fail(ErrorCode::kMalformed, "holds no \"CorrespondenceAnchor\"", file_name);
    return fail(ErrorCode::kMalformed, "no anchor can be read: " + import.rejected[0].reason,
                file_name + ":" + std::to_string(import.rejected[0].line));
  }
  return import;
}

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/strict_json.h"

#include "cad2slam/io/text.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

namespace cad2slam {
namespace {

using nlohmann::json;

constexpr std::size_t kDeepestNesting = 64;

/// Checks what a document tree would hide, before the tree is built.
class StructureCheck : public json::json_sax_t {
 public:
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  [[nodiscard]] std::optional<std::size_t> errorPosition() const { return error_position_; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    if (keys_.back().insert(name).second) return true;
    complaint_ = "has the key " + excerpt(name) + " twice in one object";
    return false;
  }
  bool parse_error(std::size_t position, const std::string&, const json::exception&) override {
    complaint_ = "is not valid JSON";
    error_position_ = position;
    return false;
  }

 private:
  bool open() {
    if (keys_.size() >= kDeepestNesting) {
      complaint_ = "is nested too deeply";
      return false;
    }
    keys_.emplace_back();
    return true;
  }
  bool close() {
    keys_.pop_back();
    return true;
  }

  std::vector<std::set<std::string>> keys_;  // of the objects and lists that are open
  std::string complaint_;
  std::optional<std::size_t> error_position_;
};

}  // namespace

Result<nlohmann::json> parseStrictJson(std::string_view text, const std::string& file_name) {
  // The library takes a zero byte for the end of the text.
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos) return fail(ErrorCode::kMalformed, "is no text: it holds zero bytes", file_name);
  StructureCheck check;
  if (!json::sax_parse(text.begin(), text.end(), &check)) {
    if (!check.errorPosition()) return fail(ErrorCode::kMalformed, check.complaint(), file_name);
    const std::size_t end = std::min(*check.errorPosition(), text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    return fail(ErrorCode::kMalformed, check.complaint(), file_name + ":" + std::to_string(line));
  }
  json document = json::parse(text.begin(), text.end(), nullptr, false);
  if (document.is_discarded()) return fail(ErrorCode::kMalformed, "is not valid JSON", file_name);
  return document;
}

}  // namespace cad2slam

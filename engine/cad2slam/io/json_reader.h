// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "cad2slam/core/result.h"

namespace cad2slam {

/// First thing that is wrong in a document; shared by all readers of its parts.
class JsonProblem {
 public:
  explicit JsonProblem(std::string file_name) : file_name_(std::move(file_name)) {}

  void report(const std::string& path, const std::string& message) {
    if (!error_)
      error_ = Error{ErrorCode::kMalformed, (path.empty() ? "the document" : path) + " " + message, file_name_};
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  std::string file_name_;
  std::optional<Error> error_;
};

/// Typed access to one value of a document and what it holds; a value that is missing or wrong is reported once, with
/// its path such as `slam_maps[2].anchors[0].slam`, and read as its default. So a reader is one line for each key.
class JsonReader {
 public:
  JsonReader(const nlohmann::json* value, std::string path, JsonProblem& problem)
      : value_(value), path_(std::move(path)), problem_(&problem) {}

  [[nodiscard]] bool exists() const { return value_ != nullptr; }
  [[nodiscard]] bool isNull() const { return value_ == nullptr || value_->is_null(); }
  [[nodiscard]] const nlohmann::json& value() const { return *value_; }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// A value of this object; reported when this is no object. Missing values are no failure yet.
  [[nodiscard]] JsonReader operator[](const char* key) const {
    const nlohmann::json* child = nullptr;
    if (value_ != nullptr && value_->is_object()) {
      const auto place = value_->find(key);
      if (place != value_->end()) child = &*place;
    } else if (value_ != nullptr) {
      report("must be an object");
    }
    return {child, path_.empty() ? key : path_ + "." + key, *problem_};
  }
  /// A value of this list, which must be long enough.
  [[nodiscard]] JsonReader at(std::size_t index) const {
    return {&(*value_)[index], path_ + "[" + std::to_string(index) + "]", *problem_};
  }
  /// Length of this list; missing counts as empty, anything else is reported.
  [[nodiscard]] std::size_t size() const {
    if (value_ == nullptr) return 0;
    if (!value_->is_array()) report("must be a list");
    return value_->is_array() ? value_->size() : 0;
  }

  [[nodiscard]] const JsonReader& required() const {
    if (value_ == nullptr) report("is missing");
    return *this;
  }
  [[nodiscard]] std::string text(const std::string& otherwise = {}) const {
    if (value_ == nullptr) return otherwise;
    if (!value_->is_string()) report("must be a text");
    return value_->is_string() ? value_->get<std::string>() : otherwise;
  }
  [[nodiscard]] bool flag(bool otherwise) const {
    if (value_ == nullptr) return otherwise;
    if (!value_->is_boolean()) report("must be true or false");
    return value_->is_boolean() ? value_->get<bool>() : otherwise;
  }
  /// A number from `least` to `most`. JSON has no infinities.
  [[nodiscard]] double number(double otherwise, double least = std::numeric_limits<double>::lowest(),
                              double most = std::numeric_limits<double>::max()) const {
    if (value_ == nullptr) return otherwise;
    const double number = value_->is_number() ? value_->get<double>() : std::numeric_limits<double>::quiet_NaN();
    if (number >= least && number <= most) return number;
    report("must be a finite number in its range");
    return otherwise;
  }
  [[nodiscard]] std::optional<double> optionalNumber(double least, double most) const {
    if (isNull()) return std::nullopt;
    return number(0.0, least, most);
  }
  template <class Integer>
  [[nodiscard]] Integer integer(Integer otherwise, Integer least = std::numeric_limits<Integer>::min(),
                                Integer most = std::numeric_limits<Integer>::max()) const {
    if (value_ == nullptr) return otherwise;
    if (value_->is_number_unsigned()) {
      const auto number = value_->get<std::uint64_t>();
      if (std::in_range<Integer>(number) && static_cast<Integer>(number) >= least &&
          static_cast<Integer>(number) <= most) {
        return static_cast<Integer>(number);
      }
    } else if (value_->is_number_integer()) {
      const auto number = value_->get<std::int64_t>();
      if (std::in_range<Integer>(number) && static_cast<Integer>(number) >= least &&
          static_cast<Integer>(number) <= most) {
        return static_cast<Integer>(number);
      }
    }
    report("must be a whole number in its range");
    return otherwise;
  }
  void report(const std::string& message) const { problem_->report(path_, message); }

 private:
  const nlohmann::json* value_;  // null where it is missing
  std::string path_;
  JsonProblem* problem_;
};

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/projector_header.h"

#include "cad2slam/io/sha256.h"
#include "cad2slam/io/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>

namespace cad2slam {
namespace {

using nlohmann::json;

constexpr std::size_t kLengthBytes = 8;
constexpr std::size_t kDataAlignment = 64;
constexpr std::size_t kMostArrays = 256;
constexpr std::size_t kMostDimensions = 8;
constexpr std::string_view kMetadataKey = "__metadata__";
constexpr const char* kHeaderSealKey = "header_sha256";

constexpr std::array<std::pair<std::string_view, std::uint64_t>, 13> kTypeBytes{{{"BOOL", 1},
                                                                                 {"U8", 1},
                                                                                 {"I8", 1},
                                                                                 {"I16", 2},
                                                                                 {"U16", 2},
                                                                                 {"F16", 2},
                                                                                 {"BF16", 2},
                                                                                 {"I32", 4},
                                                                                 {"U32", 4},
                                                                                 {"F32", 4},
                                                                                 {"I64", 8},
                                                                                 {"U64", 8},
                                                                                 {"F64", 8}}};

/// Takes the header's JSON event by event. The shape is fixed and two levels deep, so anything else is refused where it
/// begins, and a name that stands twice is seen (a document tree would keep the last one silently).
class HeaderReader : public json::json_sax_t {
 public:
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  [[nodiscard]] ProjectorHeader takeHeader() { return std::move(header_); }

  bool null() override { return unexpected("null"); }
  bool boolean(bool) override { return unexpected("a truth value"); }
  bool number_integer(number_integer_t) override { return unexpected("a negative number"); }
  bool number_float(number_float_t, const string_t&) override { return unexpected("a number with a fraction"); }
  bool binary(binary_t&) override { return unexpected("binary data"); }

  bool number_unsigned(number_unsigned_t value) override {
    if (place_ != Place::kNumbers) return unexpected("a number");
    if (numbers_.size() >= kMostDimensions) return refuse("has too long a list in " + excerpt(name_));
    numbers_.push_back(value);
    return true;
  }
  bool string(string_t& value) override {
    if (place_ == Place::kMetadata) {
      header_.metadata[key_] = std::move(value);
      return true;
    }
    if (place_ != Place::kArray || key_ != "dtype") return unexpected("a text");
    header_.arrays[name_].dtype = std::move(value);
    return true;
  }
  bool start_object(std::size_t) override {
    if (place_ == Place::kNowhere) {
      place_ = Place::kTop;
    } else if (place_ == Place::kTop) {
      place_ = name_ == kMetadataKey ? Place::kMetadata : Place::kArray;
      seen_.clear();
    } else {
      return unexpected("an object");
    }
    return true;
  }
  bool key(string_t& value) override {
    if (place_ == Place::kTop) {
      const bool is_new = value == kMetadataKey ? !std::exchange(has_metadata_, true)
                                                : header_.arrays.emplace(value, ArrayEntry{}).second;
      if (!is_new) return refuse("has the name " + excerpt(value) + " twice");
      if (header_.arrays.size() > kMostArrays) return refuse("has too many arrays");
      name_ = std::move(value);
      return true;
    }
    const bool is_new = place_ == Place::kMetadata ? header_.metadata.emplace(value, std::string()).second
                                                   : std::find(seen_.begin(), seen_.end(), value) == seen_.end();
    if (!is_new) return refuse("has the key " + excerpt(value) + " twice in " + excerpt(name_));
    if (place_ == Place::kArray) {
      if (value != "dtype" && value != "shape" && value != "data_offsets") {
        return refuse("has the unknown key " + excerpt(value) + " in " + excerpt(name_));
      }
      seen_.push_back(value);
    }
    key_ = std::move(value);
    return true;
  }
  bool end_object() override {
    if (place_ == Place::kArray && seen_.size() != 3) {
      return refuse("does not say dtype, shape and data_offsets of " + excerpt(name_));
    }
    place_ = place_ == Place::kTop ? Place::kNowhere : Place::kTop;
    return true;
  }
  bool start_array(std::size_t) override {
    if (place_ != Place::kArray || key_ == "dtype") return unexpected("a list");
    place_ = Place::kNumbers;
    numbers_.clear();
    return true;
  }
  bool end_array() override {
    place_ = Place::kArray;
    ArrayEntry& entry = header_.arrays[name_];
    if (key_ == "shape") {
      entry.shape = numbers_;
      return true;
    }
    if (numbers_.size() != 2) return refuse("has data_offsets that are not two numbers in " + excerpt(name_));
    entry.begin = numbers_[0];
    entry.end = numbers_[1];
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const json::exception&) override {
    return refuse("is not valid JSON at byte " + std::to_string(position));
  }

 private:
  enum class Place { kNowhere, kTop, kMetadata, kArray, kNumbers };

  bool refuse(std::string complaint) {
    complaint_ = std::move(complaint);
    return false;
  }
  bool unexpected(const char* what) {
    if (place_ == Place::kNowhere) return refuse("is no JSON object");
    return refuse(std::string("has ") + what + " where it should not, in " + excerpt(name_));
  }

  ProjectorHeader header_;
  Place place_ = Place::kNowhere;
  std::string name_;  // of the array, or kMetadataKey
  std::string key_;
  std::vector<std::string> seen_;  // keys of this array
  std::vector<std::uint64_t> numbers_;
  bool has_metadata_ = false;
  std::string complaint_;
};

/// Bytes an array needs; empty for an unknown type or where the product does not fit.
std::optional<std::uint64_t> bytesOf(const ArrayEntry& entry) {
  const auto type = std::find_if(kTypeBytes.begin(), kTypeBytes.end(),
                                 [&entry](const auto& candidate) { return candidate.first == entry.dtype; });
  if (type == kTypeBytes.end()) return std::nullopt;
  std::uint64_t bytes = type->second;
  for (const std::uint64_t length : entry.shape) {
    if (__builtin_mul_overflow(bytes, length, &bytes)) return std::nullopt;
  }
  return bytes;
}

/// Empty where the ranges cover [0, data_bytes) exactly; else what is wrong.
std::string rangeComplaint(const ProjectorHeader& header, std::uint64_t data_bytes) {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;
  for (const auto& [name, entry] : header.arrays) {
    const std::optional<std::uint64_t> bytes = bytesOf(entry);
    if (!bytes) return "has an array of unknown type or impossible size: " + excerpt(name);
    if (entry.begin > entry.end || entry.end - entry.begin != *bytes) {
      return "has an array whose range does not fit its shape: " + excerpt(name);
    }
    ranges.emplace_back(entry.begin, entry.end);
  }
  std::sort(ranges.begin(), ranges.end());
  std::uint64_t covered = 0;
  for (const auto& [begin, end] : ranges) {
    if (begin != covered) return "has arrays that overlap or leave a gap at byte " + std::to_string(covered);
    covered = end;
  }
  if (covered > data_bytes) return "is cut off: " + std::to_string(covered - data_bytes) + " bytes are missing";
  if (covered < data_bytes) return "has " + std::to_string(data_bytes - covered) + " bytes too many";
  return {};
}

}  // namespace

Result<ProjectorHeader> readProjectorHeader(ByteSource& source) {
  const auto malformed = [&source](std::string message) {
    return fail(ErrorCode::kMalformed, std::move(message), source.name());
  };
  std::array<char, kLengthBytes> prefix{};
  if (source.remaining() < prefix.size()) {
    return malformed("is no projector file: it has only " + std::to_string(source.remaining()) + " bytes");
  }
  if (const Result<void> read = source.read(prefix.data(), prefix.size()); !read) return failAs(read);
  std::uint64_t length = 0;
  for (std::size_t k = prefix.size(); k-- > 0;) length = (length << 8) | static_cast<unsigned char>(prefix[k]);
  if (length > kLargestProjectorHeader) return malformed("is no projector file: its header would be too long");
  if (length > source.remaining()) return malformed("is cut off inside its header");
  std::string text(static_cast<std::size_t>(length), '\0');
  if (const Result<void> read = source.read(text.data(), text.size()); !read) return failAs(read);
  // The parser takes a zero byte for the end of the text; nothing may hide behind it.
  if (text.find('\0') != std::string::npos) return malformed("is no projector file: zero bytes in its header");

  HeaderReader reader;
  if (!json::sax_parse(text, &reader)) return malformed("has a header that " + reader.complaint());
  ProjectorHeader header = reader.takeHeader();
  const std::string complaint = rangeComplaint(header, source.remaining());
  if (!complaint.empty()) return malformed(complaint);
  return header;
}

std::string formatProjectorHeader(const ProjectorHeader& header) {
  json text = json::object();
  for (const auto& [name, entry] : header.arrays) {
    text[name] = {{"dtype", entry.dtype}, {"shape", entry.shape}, {"data_offsets", {entry.begin, entry.end}}};
  }
  text[std::string(kMetadataKey)] = header.metadata;
  return text.dump(-1, ' ', false, json::error_handler_t::replace);
}

void sealProjectorHeader(ProjectorHeader& header, std::string_view data) {
  header.metadata.erase(kHeaderSealKey);
  header.metadata[kDataSealKey] = sha256Hex(data.data(), data.size());
  const std::string text = formatProjectorHeader(header);
  header.metadata[kHeaderSealKey] = sha256Hex(text.data(), text.size());
}

bool headerSealHolds(const ProjectorHeader& header) {
  const auto seal = header.metadata.find(kHeaderSealKey);
  if (seal == header.metadata.end()) return false;
  ProjectorHeader unsealed = header;
  unsealed.metadata.erase(kHeaderSealKey);
  const std::string text = formatProjectorHeader(unsealed);
  return seal->second == sha256Hex(text.data(), text.size());
}

std::string formatProjectorPrefix(const ProjectorHeader& header) {
  std::string text = formatProjectorHeader(header);
  const std::size_t used = (kLengthBytes + text.size()) % kDataAlignment;
  text.append((kDataAlignment - used) % kDataAlignment, ' ');
  std::string prefix;
  for (std::size_t k = 0; k < kLengthBytes; ++k) prefix += static_cast<char>((text.size() >> (8 * k)) & 0xffU);
  return prefix + text;
}

}  // namespace cad2slam

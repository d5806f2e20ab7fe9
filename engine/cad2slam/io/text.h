// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace cad2slam {

/// Small pieces that all text formats of this folder share. Nothing here depends on the locale of the process.

inline bool isBlank(char c) {
  return c == ' ' || c == '\t';
}

inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

/// ASCII only: what formats call case-insensitive.
inline std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

/// Of UTF-8, as some editors and spreadsheets put it in front.
inline std::string_view withoutByteOrderMark(std::string_view text) {
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
  return text;
}

/// On or off as people write it; an empty text is on.
inline std::optional<bool> parseSwitch(std::string_view text) {
  const std::string word = lowerCase(text);
  if (word.empty() || word == "1" || word == "true" || word == "yes" || word == "on") return true;
  if (word == "0" || word == "false" || word == "no" || word == "off") return false;
  return std::nullopt;
}

/// A whole text as a number; empty unless all of it is one finite number.
inline std::optional<double> parseNumber(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// A whole text as an integer of type `Integer`, decimal.
template <class Integer>
std::optional<Integer> parseInteger(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  Integer value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The shortest decimal text that reads back as exactly this number.
inline std::string formatNumber(double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return error == std::errc() ? std::string(text, end) : std::string("nan");
}

/// Length of the UTF-8 sequence at the start of `text` (1 to 4), or 0 where it is none. Refuses overlong forms,
/// surrogates and code points beyond Unicode.
inline std::size_t utf8SequenceLength(std::string_view text) {
  const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U; };
  const auto follows = [&](std::size_t at) { return (byte(at) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (text.empty()) return 0;
  if (first < 0x80U) return 1;
  if (first >= 0xC2U && first <= 0xDFU) return follows(1) ? 2 : 0;
  if (first >= 0xE0U && first <= 0xEFU) {
    const bool in_range = (first != 0xE0U || byte(1) >= 0xA0U) && (first != 0xEDU || byte(1) < 0xA0U);
    return in_range && follows(1) && follows(2) ? 3 : 0;
  }
  if (first >= 0xF0U && first <= 0xF4U) {
    const bool in_range = (first != 0xF0U || byte(1) >= 0x90U) && (first != 0xF4U || byte(1) < 0x90U);
    return in_range && follows(1) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

inline bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8SequenceLength(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

/// A piece of a file as it may stand in an error message: short, on one line, and safe for a terminal.
inline std::string excerpt(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown = "'";
  while (!text.empty() && shown.size() < kLongest) {
    const std::size_t length = utf8SequenceLength(text);
    const bool printable = length > 1 || (length == 1 && text.front() >= ' ' && text.front() != '\x7f');
    if (printable) {
      shown += text.substr(0, length);
    } else {
      shown += '?';
    }
    text.remove_prefix(length > 0 ? length : 1);
  }
  return shown + (text.empty() ? "'" : "...'");
}

}  // namespace cad2slam

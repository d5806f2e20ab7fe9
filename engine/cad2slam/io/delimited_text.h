// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cad2slam {

/// One record of a delimited text.
struct TextRecord {
  std::size_t line = 0;             ///< 1-based, of its first character
  std::vector<std::string> fields;  ///< unquoted fields are trimmed
  std::string complaint;            ///< why it could not be split, or empty
};

/// Splits CSV-like text as people and spreadsheets write it: quoted fields with doubled quotes, which may span lines;
/// blank lines; `#` comments on their own line or behind a blank; any kind of line end. With the separator ' ' any
/// run of blanks separates. Text that cannot be split is complained of by line, and reading goes on at the next line:
/// a quote that is never closed costs one line, not the rest of the file. Linear in the size of the text.
class RecordReader {
 public:
  RecordReader(std::string_view text, char separator) : text_(text), separator_(separator) {}

  /// Tells the fields in which a '#' behind a blank is part of the text.
  void setTextField(std::function<bool(std::size_t field)> is_text) { is_text_ = std::move(is_text); }

  /// The next record that is not blank; empty at the end.
  [[nodiscard]] std::optional<TextRecord> next();

 private:
  enum class AfterField { kField, kLineEnd };

  [[nodiscard]] bool atLineEnd() const { return at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }
  void skipBlanks();
  void skipLine();
  void skipLineEnd();
  [[nodiscard]] bool atComment(std::size_t field) const;
  void splitRecord(TextRecord& record);
  [[nodiscard]] bool readQuoted(TextRecord& record);
  void readPlain(TextRecord& record);
  [[nodiscard]] AfterField finishField(std::size_t next_field);

  std::string_view text_;
  char separator_;
  std::function<bool(std::size_t)> is_text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  /// A quoted field that begins before this place must end on its line: an attempt to read on has failed already.
  std::size_t single_line_until_ = 0;
};

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/delimited_text.h"

#include "cad2slam/io/text.h"

#include <algorithm>

namespace cad2slam {

void RecordReader::skipBlanks() {
  while (at_ < text_.size() && isBlank(text_[at_]) && text_[at_] != separator_) ++at_;
}

void RecordReader::skipLine() {
  at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
}

void RecordReader::skipLineEnd() {
  if (at_ == text_.size()) return;
  at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
  ++line_;
}

bool RecordReader::atComment(std::size_t field) const {
  if (text_[at_] != '#' || (is_text_ && is_text_(field))) return false;
  return at_ == 0 || isBlank(text_[at_ - 1]) || text_[at_ - 1] == separator_ || text_[at_ - 1] == '\n' ||
         text_[at_ - 1] == '\r';
}

std::optional<TextRecord> RecordReader::next() {
  while (at_ < text_.size()) {
    const std::size_t line_begin = at_;
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
    if (atLineEnd()) {
      skipLineEnd();
      continue;
    }
    if (text_[at_] == '#') {
      skipLine();
      skipLineEnd();
      continue;
    }
    // A leading tab is an empty first field where tabs separate.
    if (separator_ == '\t') at_ = line_begin;
    TextRecord record;
    record.line = line_;
    splitRecord(record);
    skipLineEnd();
    return record;
  }
  return std::nullopt;
}

void RecordReader::splitRecord(TextRecord& record) {
  const std::size_t begin = at_;
  do {
    skipBlanks();
    if (!atLineEnd() && text_[at_] == '"') {
      if (!readQuoted(record)) {
        single_line_until_ = std::max(single_line_until_, at_);
        at_ = begin;
        line_ = record.line;
        skipLine();
        return;
      }
    } else if (!atLineEnd() && atComment(record.fields.size())) {
      skipLine();
      record.fields.emplace_back();
      return;
    } else {
      readPlain(record);
    }
  } while (finishField(record.fields.size()) == AfterField::kField);
}

bool RecordReader::readQuoted(TextRecord& record) {
  const bool single_line = at_ < single_line_until_;
  std::string field;
  ++at_;
  while (true) {
    if (at_ == text_.size() || (single_line && atLineEnd())) {
      record.complaint = "has a quote that is never closed";
      return false;
    }
    const char c = text_[at_];
    if (c == '"' && at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
      field += '"';
      at_ += 2;
    } else if (c == '"') {
      ++at_;
      break;
    } else {
      if (c == '\n' || (c == '\r' && text_.substr(at_, 2) != "\r\n")) ++line_;
      field += c;
      ++at_;
    }
  }
  const bool blank_follows = at_ < text_.size() && isBlank(text_[at_]);
  skipBlanks();
  const bool ended = atLineEnd() || text_[at_] == separator_ || (separator_ == ' ' && blank_follows) ||
                     (blank_follows && text_[at_] == '#');
  if (!ended) {
    record.complaint = "has text behind a closing quote";
    return false;
  }
  record.fields.push_back(std::move(field));
  return true;
}

void RecordReader::readPlain(TextRecord& record) {
  const std::size_t begin = at_;
  while (!atLineEnd() && text_[at_] != separator_ && !(separator_ == ' ' && isBlank(text_[at_])) &&
         !atComment(record.fields.size())) {
    ++at_;
  }
  record.fields.emplace_back(trimmed(text_.substr(begin, at_ - begin)));
}

RecordReader::AfterField RecordReader::finishField(std::size_t next_field) {
  const bool blank_separates = separator_ == ' ';
  while (blank_separates && at_ < text_.size() && isBlank(text_[at_])) ++at_;
  if (atLineEnd()) return AfterField::kLineEnd;
  if (text_[at_] == '#' && (!blank_separates || atComment(next_field))) {
    skipLine();
    return AfterField::kLineEnd;
  }
  if (!blank_separates) ++at_;  // over the separator
  return AfterField::kField;
}

}  // namespace cad2slam

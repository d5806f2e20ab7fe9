// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/engine_sentences.h"

#include "ui/convert.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace cad2slam {
namespace {

constexpr int kNested = 2;  // a reason in a reason, and a word in that

struct Pattern {
  const char* english = nullptr;
  QStringList literals;  ///< before, between and behind what is inserted
};

/// Those with the most to recognise them by first. How they begin counts before the rest: a reason may stand at the end
/// of a sentence.
const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> kSorted = [] {
    std::vector<Pattern> sorted;
    const QRegularExpression inserted(QStringLiteral("%[1-9]"));
    for (const char* english : enginePatterns())
      sorted.push_back({english, QString::fromUtf8(english).split(inserted)});
    const auto rank = [](const Pattern& pattern) {
      return std::pair(pattern.literals.front().size(), pattern.literals.join(QString()).size());
    };
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Pattern& a, const Pattern& b) { return rank(a) > rank(b); });
    return sorted;
  }();
  return kSorted;
}

/// What stands in `text` where the pattern has %1, %2, ...; empty where they do not agree. In one pass, as the texts
/// may come from a file: each literal but the last is taken where it comes first.
std::optional<QStringList> insertedInto(const Pattern& pattern, const QString& text) {
  const QStringList& literals = pattern.literals;
  if (literals.size() == 1) return text == literals.front() ? std::optional(QStringList()) : std::nullopt;
  if (!text.startsWith(literals.front())) return std::nullopt;
  QStringList inserted;
  qsizetype at = literals.front().size();
  for (qsizetype k = 1; k + 1 < literals.size(); ++k) {
    const qsizetype found = text.indexOf(literals[k], at);
    if (found < 0) return std::nullopt;
    inserted += text.mid(at, found - at);
    at = found + literals[k].size();
  }
  const qsizetype end = text.size() - literals.back().size();
  if (end < at || !text.endsWith(literals.back())) return std::nullopt;
  inserted += text.mid(at, end - at);
  return inserted;
}

/// Not QString::arg(): what is inserted may hold a %1 of its own.
QString filled(const QString& text, const QStringList& values) {
  QString result;
  for (qsizetype at = 0; at < text.size(); ++at) {
    const int number = text[at] == QLatin1Char('%') && at + 1 < text.size() ? text[at + 1].digitValue() : 0;
    if (number < 1 || number > values.size()) {
      result += text[at];
      continue;
    }
    result += values[number - 1];
    ++at;
  }
  return result;
}

QString translated(const QString& text, int nested) {
  for (const Pattern& pattern : patterns()) {
    std::optional<QStringList> values = insertedInto(pattern, text);
    if (!values) continue;
    if (nested > 0)
      for (QString& value : *values) value = translated(value, nested - 1);
    return filled(QCoreApplication::translate("Engine", pattern.english), *values);
  }
  return text;
}

QString capitalized(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

QString toSentence(const Error& error) {
  const QString message = translated(toQString(error.message), kNested);
  if (error.where.empty()) return capitalized(message);
  const QString place = toQString(error.where);
  // The name of a file may read like a sentence.
  const bool is_path = place.contains(QLatin1Char('/'));
  return (is_path ? place : capitalized(translated(place, 0))) + QStringLiteral(": ") + message;
}

QString translatedSentence(const std::string& english) {
  return translated(toQString(english), kNested);
}

}  // namespace cad2slam

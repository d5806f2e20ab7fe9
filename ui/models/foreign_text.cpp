// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/models/foreign_text.h"

#include <QTextDocument>

namespace cad2slam {
namespace {

constexpr qsizetype kMostLetters = 60;

}  // namespace

QString asPlainText(const QString& text) {
  if (!Qt::mightBeRichText(text)) return text;
  return QStringLiteral("<span style=\"white-space: pre-wrap\">") + text.toHtmlEscaped() + QStringLiteral("</span>");
}

QString shortened(const QString& text) {
  if (text.size() <= kMostLetters) return text;
  const bool splits_a_letter = text[kMostLetters - 1].isHighSurrogate();
  return text.left(splits_a_letter ? kMostLetters - 1 : kMostLetters) + QChar(0x2026);
}

}  // namespace cad2slam

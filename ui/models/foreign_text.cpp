// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/models/foreign_text.h"

#include <QTextDocument>

namespace cad2slam {

QString asPlainText(const QString& text) {
  if (!Qt::mightBeRichText(text)) return text;
  return QStringLiteral("<span style=\"white-space: pre-wrap\">") + text.toHtmlEscaped() + QStringLiteral("</span>");
}

QString shortened(const QString& text, qsizetype most_letters) {
  if (text.size() <= most_letters) return text;
  const bool splits_a_letter = text[most_letters - 1].isHighSurrogate();
  return text.left(splits_a_letter ? most_letters - 1 : most_letters) + QChar(0x2026);
}

}  // namespace cad2slam

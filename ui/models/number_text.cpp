// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/models/number_text.h"

#include "cad2slam/anchors/anchor.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace cad2slam {
namespace {

const QChar kArabicDecimalSign(0x066b);

/// Digits and minus of a language can be others than a keyboard has, and some minus signs come with marks that do not
/// show; of the language is the decimal sign alone.
QString withDecimalSign(QString text) {
  if (QLocale().decimalPoint() == QLatin1String(",")) text.replace(QLatin1Char('.'), QLatin1Char(','));
  return text;
}

}  // namespace

QString numberText(double value, int decimals) {
  // "-0.000" is only a rounded zero.
  const bool is_zero = std::abs(value) < 0.5 * std::pow(10.0, -decimals);
  return withDecimalSign(QString::number(is_zero ? 0.0 : value, 'f', decimals));
}

QString pairText(double first, double second, int decimals) {
  const bool comma_in_numbers = QLocale().decimalPoint() == QLatin1String(",");
  return numberText(first, decimals) + (comma_in_numbers ? QStringLiteral("; ") : QStringLiteral(", ")) +
         numberText(second, decimals);
}

QString shortNumberText(double value) {
  return withDecimalSign(QString::number(value, 'g', QLocale::FloatingPointShortest));
}

std::optional<double> parseNumber(const QString& text) {
  QString plain = text.trimmed();
  if (plain.endsWith(QLatin1Char('m'))) plain = plain.chopped(1).trimmed();
  if (plain.contains(QLatin1Char(',')) && plain.contains(QLatin1Char('.'))) return std::nullopt;  // ambiguous
  for (QChar& letter : plain) {
    if (letter == QLatin1Char(',') || letter == kArabicDecimalSign) letter = QLatin1Char('.');
    if (letter.isDigit()) letter = QLatin1Char(static_cast<char>('0' + letter.digitValue()));
  }
  plain.replace(QChar(0x2212), QLatin1Char('-'));
  bool ok = false;
  const double value = QLocale::c().toDouble(plain, &ok);
  if (!ok || !std::isfinite(value) || std::abs(value) > kLargestCoordinate) return std::nullopt;
  return value;
}

QString metresText(double value_m) {
  return numberText(value_m, 3);
}

QString centimetresText(double value_m) {
  return numberText(100.0 * value_m, std::abs(value_m) < 10.0 ? 1 : 0);
}

QString lengthText(double value_m) {
  if (std::abs(value_m) < 1.0) return QCoreApplication::translate("units", "%1 cm").arg(centimetresText(value_m));
  return QCoreApplication::translate("units", "%1 m").arg(numberText(value_m, 2));
}

}  // namespace cad2slam

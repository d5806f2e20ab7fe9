// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <optional>

namespace cad2slam {

/// Numbers as the installer types them: the decimal sign of the language, else digits and minus of any keyboard, no
/// group separators. parseNumber() reads them back in every language.
[[nodiscard]] QString numberText(double value, int decimals);
/// Two numbers that belong together, told apart by what is no decimal sign here.
[[nodiscard]] QString pairText(double first, double second, int decimals);
/// As short as it can be and still read back as the same number.
[[nodiscard]] QString shortNumberText(double value);
/// Accepts decimal point and decimal comma and digits of any script whatever the language, and a unit "m" behind;
/// nothing else.
[[nodiscard]] std::optional<double> parseNumber(const QString& text);

[[nodiscard]] QString metresText(double value_m);       ///< "12.345"
[[nodiscard]] QString centimetresText(double value_m);  ///< "4.2"; from 10 m on without decimals
[[nodiscard]] QString lengthText(double value_m);       ///< with unit: "4.2 cm", "1.25 m"

}  // namespace cad2slam

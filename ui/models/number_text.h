// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <optional>

namespace cad2slam {

/// Numbers as the installer writes them: the decimal sign of the language, no group separators.
[[nodiscard]] QString numberText(double value, int decimals);
/// Accepts decimal point and decimal comma whatever the language, and a unit "m" behind; nothing else.
[[nodiscard]] std::optional<double> parseNumber(const QString& text);

[[nodiscard]] QString metresText(double value_m);       ///< "12.345"
[[nodiscard]] QString centimetresText(double value_m);  ///< "4.2"; from 10 m on without decimals
[[nodiscard]] QString lengthText(double value_m);       ///< with unit: "4.2 cm", "1.25 m"

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace cad2slam {

enum class Theme { kSystem, kLight, kDark, kHighContrast };

/// How the program looks on this computer; kept in the user's settings, not in projects.
struct Appearance {
  Theme theme = Theme::kSystem;
  QString language;  ///< "en", "de", "es"; empty follows the system

  friend bool operator==(const Appearance&, const Appearance&) = default;
};

[[nodiscard]] Appearance readAppearance();
void writeAppearance(const Appearance& appearance);
/// Colours take effect at once.
void applyTheme(Theme theme);
/// Texts and number formats; only what is built afterwards shows them, so before the first window.
void applyLanguage(const QString& language);

}  // namespace cad2slam

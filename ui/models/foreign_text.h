// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace cad2slam {

// Names and paths come from files of other people and may hold anything. Labels get Qt::PlainText; what has no such
// switch goes through here.

/// For tool tips and questions, which Qt takes for HTML where it looks like it: shown letter by letter all the same.
/// HTML could have any file read, even one that never ends.
[[nodiscard]] QString asPlainText(const QString& text);

/// The start of a text that may be far too long to draw, with an ellipsis where something is missing.
[[nodiscard]] QString shortened(const QString& text, qsizetype most_letters = 60);

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>
#include <QString>

namespace cad2slam {

/// An icon of ours (resources/icons/<name>.svg), sharp at every size. Its lines take the text colour of the palette at
/// the time of painting, so that light, dark and high-contrast themes need one drawing. An unknown name gives a null
/// icon.
[[nodiscard]] QIcon icon(const QString& name);

}  // namespace cad2slam

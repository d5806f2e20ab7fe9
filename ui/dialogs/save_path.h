// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace cad2slam {

/// Asks for the name of a file to write; empty when the user gives up. `suffix`, with its dot, is added where it was
/// left out, and a file that only then turns out to be there is not replaced without a question.
[[nodiscard]] QString askSavePath(QWidget* parent, const QString& title, const QString& proposal, const QString& filter,
                                  const QString& suffix);

/// Asks for each of the files that is there already; false as soon as one is to stay.
[[nodiscard]] bool mayReplace(QWidget* parent, const QString& title, const QStringList& paths);

}  // namespace cad2slam

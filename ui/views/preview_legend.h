// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QFont>
#include <QPixmap>
#include <QString>

#include <optional>
#include <vector>

namespace cad2slam {

/// What the colours of a preview mean, in words of the user's language.
struct PreviewLegend {
  struct Row {
    QColor color;  ///< invalid: the row is text only
    QString text;
  };
  /// The colours of heat maps and strain, from end to end.
  struct Ramp {
    bool one_sided = false;  ///< from nothing to the strongest colour; else from one strongest to the other
    QString low;
    QString middle;  ///< empty when one-sided
    QString high;
  };

  QString title;
  std::optional<Ramp> ramp;
  std::vector<Row> rows;
  QString hint;

  /// A panel of its natural width, or of `most_width` logical pixels with its texts cut short.
  [[nodiscard]] QPixmap picture(const QFont& font, double most_width, double device_ratio) const;
};

}  // namespace cad2slam

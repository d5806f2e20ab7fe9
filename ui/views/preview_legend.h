// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QCoreApplication>
#include <QFont>
#include <QPixmap>
#include <QString>

#include <optional>
#include <vector>

namespace cad2slam {

/// What the colours of a preview mean, in words of the user's language.
struct PreviewLegend {
  Q_DECLARE_TR_FUNCTIONS(cad2slam::PreviewLegend)

 public:
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

  /// Of a mesh drawn in colours of strain; `full_color` is the strain of the strongest.
  [[nodiscard]] static PreviewLegend ofMesh(double full_color);
  /// Of something that is both more and less: from -`most` to +`most`, a number with its unit.
  [[nodiscard]] static Ramp bothWays(const QString& most);

  /// A panel of its natural width, or of `most_width` logical pixels with its texts cut short.
  [[nodiscard]] QPixmap picture(const QFont& font, double most_width, double device_ratio) const;
};

}  // namespace cad2slam

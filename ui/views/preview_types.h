// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QImage>
#include <QMetaType>
#include <QSize>
#include <QString>

#include <vector>

#include "ui/views/view_state.h"

namespace cad2slam {

/// How the two maps are compared, in the order in which a key steps through them.
enum class PreviewMode {
  kOverlay,    ///< one over the other, half transparent
  kTwoInk,     ///< blueprint magenta, SLAM map green, agreement dark
  kSwipe,      ///< a bar with one map on each side
  kBlink,      ///< one or the other
  kLens,       ///< the other map under the cursor
  kMesh,       ///< the warped mesh with its strain
  kResiduals,  ///< what each anchor misses
  kStretch,    ///< heat map: local scale against the mean
  kRotation,   ///< heat map: local turn against the mean
  kCoverage,   ///< heat map: how far the nearest anchor is
  kAllMaps,    ///< all SLAM maps over the blueprint, each in its ink
};
inline constexpr int kPreviewModeCount = 11;

/// What a worker has to draw for a mode.
enum class PreviewKind { kWarped, kInks, kStretch, kRotation, kCoverage };

[[nodiscard]] constexpr PreviewKind previewKind(PreviewMode mode) {
  switch (mode) {
    case PreviewMode::kTwoInk:
    case PreviewMode::kAllMaps:
      return PreviewKind::kInks;
    case PreviewMode::kStretch:
      return PreviewKind::kStretch;
    case PreviewMode::kRotation:
      return PreviewKind::kRotation;
    case PreviewMode::kCoverage:
      return PreviewKind::kCoverage;
    default:
      return PreviewKind::kWarped;
  }
}

/// A picture made for a part of a map; stays where it belongs while the view moves on.
struct PreviewPicture {
  QImage image;  ///< device pixels; transparent where there is nothing, opaque for kInks
  ViewState state;
  QSize size;  ///< logical pixels, margin included
  PreviewKind kind = PreviewKind::kWarped;
  /// Value of the strongest colour: a part for kStretch, radians for kRotation, metres for kCoverage.
  double full_color = 0.0;
  double seconds = 0.0;  ///< to make it
};

/// A line of the legend.
struct InkEntry {
  QColor color;
  QString name;
};

}  // namespace cad2slam

Q_DECLARE_METATYPE(cad2slam::PreviewPicture)

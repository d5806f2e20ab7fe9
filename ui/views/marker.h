// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>
#include <QVector>

#include <cstdint>
#include <vector>

namespace cad2slam {

/// Identity of something drawn that can be pressed; anchors use their AnchorId.
using MarkerId = std::int64_t;
inline constexpr MarkerId kNoMarker = -1;

/// How a marker is judged; shape and colour follow from it, so that both tell the same without the other.
enum class MarkerClass {
  kPlain,     ///< blue circle: no number to judge by yet
  kOk,        ///< teal circle
  kLook,      ///< amber diamond
  kBad,       ///< magenta square
  kPending,   ///< hollow and dashed: one half of a pair
  kDisabled,  ///< hollow and grey
};

/// One half of an anchor as one view shows it.
struct Marker {
  MarkerId id = kNoMarker;
  QString text;     ///< the number (and the name, if wanted); drawn beside the shape
  QPointF point_m;  ///< in the frame of the view
  MarkerClass judged = MarkerClass::kPlain;
  bool selected = false;  ///< thick ring
  bool snapped = false;   ///< corner tick
};

/// Where the counterpart of a pending point is expected.
struct Ghost {
  QPointF point_m;
  double radius_m = 0.0;  ///< of the uncertainty ring; 0 draws none
  QString text;
};

/// What an anchor misses: drawn from the projected place to `magnification` times the way to the clicked one.
struct ResidualVector {
  QPointF projected_m;
  QPointF clicked_m;
  MarkerClass judged = MarkerClass::kPlain;
};

/// A pose with a heading: test pose, start, goal, or one of a list of poses.
struct PoseGlyph {
  MarkerId id = kNoMarker;  ///< kNoMarker: cannot be pressed
  QPointF point_m;
  double heading_rad = 0.0;  ///< counter-clockwise from the x axis of the frame
  double radius_m = 0.25;    ///< of the robot; never drawn smaller than a few pixels
  QColor color;
  QString text;
  bool turnable = false;  ///< has a handle that turns it
  bool hollow = false;    ///< dashed outline, e.g. for an extrapolated pose
};

/// A polyline over the map: a planned path, a measured length.
struct PathGlyph {
  std::vector<QPointF> points_m;
  QColor color;
  double width_px = 2.5;
  QString text;  ///< drawn at the end of the line
  bool dashed = false;
};

/// The nodes and edges of a mesh in the frame of a view.
struct MeshOverlay {
  struct Edge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
  };
  std::vector<QPointF> nodes_m;
  std::vector<Edge> edges;
  std::vector<float> strain;         ///< one for each edge: length over rest length minus one; empty draws one colour
  std::vector<std::uint32_t> folds;  ///< nodes whose tile is folded
  double full_color_strain = 0.0;    ///< strain drawn in the strongest colour; 0 fits it to what the mesh has
};

}  // namespace cad2slam

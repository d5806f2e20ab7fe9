// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QPainter>

#include <functional>
#include <memory>

#include "ui/views/latest_job.h"
#include "ui/views/marker.h"
#include "ui/views/view_state.h"

namespace cad2slam {

/// Of the strongest colour, where no mesh tells it.
inline constexpr double kUsualStrain = 0.05;

/// Colour of a strain: blue where shorter than at rest, grey at rest, orange to red where longer.
[[nodiscard]] QColor strainColor(double strain, double full_color_strain);

/// The strain that gets the strongest colour: as the mesh says, or a round number that 95 % of its edges stay below.
[[nodiscard]] double fullColorStrain(const MeshOverlay& mesh);

/// Draws a mesh of any size over a map. The picture is made by a worker for the part in view and a margin; until a new
/// one is there the last one is drawn where it belongs now, so panning and zooming stay smooth.
class MeshLayer {
 public:
  /// `repaint` is called when a new picture is ready.
  explicit MeshLayer(std::function<void()> repaint);

  void setMesh(std::shared_ptr<const MeshOverlay> mesh);
  [[nodiscard]] bool isEmpty() const { return mesh_ == nullptr; }
  void paint(QPainter& painter, const ViewState& state, const QSize& size);
  /// Whether the picture shows the mesh and the view as last painted.
  [[nodiscard]] bool isCurrent() const { return !job_.isBusy(); }

  struct Request {
    std::shared_ptr<const MeshOverlay> mesh;
    ViewState state;
    QSize size;  ///< logical pixels, with the margin
    double ratio = 1.0;
  };
  struct Picture {
    Request of;
    QImage image;
  };
  [[nodiscard]] static Picture draw(const Request& request);  ///< any thread

 private:
  std::function<void()> repaint_;
  std::shared_ptr<const MeshOverlay> mesh_;
  Picture picture_;
  Request requested_;
  LatestJob<Request, Picture> job_;
};

}  // namespace cad2slam

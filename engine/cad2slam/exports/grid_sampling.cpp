// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/grid_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace cad2slam {
namespace {

using Eigen::Vector2d;

constexpr double kMostSamples = 25e6;

/// Largest error of bilinear interpolation in the middles of the grid's cells; empty where no cell lies on the mesh.
std::optional<double> deviationOf(const PoseGrid& grid, const Projector& projector, WarpDirection direction) {
  std::optional<double> largest;
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
      const Vector2d mean = 0.25 * (grid.at(row, column).translation + grid.at(row, column + 1).translation +
                                    grid.at(row + 1, column).translation + grid.at(row + 1, column + 1).translation);
      if (!mean.allFinite()) continue;
      const Vector2d middle =
          grid.first + grid.step_m * Vector2d(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
      const Projection exact = direction == WarpDirection::kToSlam
                                   ? projector.slamFromBlueprint({middle, 0.0}, OutsidePolicy::kError)
                                   : projector.blueprintFromSlam({middle, 0.0}, OutsidePolicy::kError);
      if (exact.ok()) largest = std::max(largest.value_or(0.0), (exact.pose.translation - mean).norm());
    }
  }
  return largest;
}

}  // namespace

Result<PoseGrid> sampleGrid(const Projector& projector, WarpDirection direction, double step_m) {
  if (!(step_m > 0.0)) return fail(ErrorCode::kOutOfDomain, "the step of a grid must be above 0 m");
  const double reach_m = 1.5 * projector.info().lattice.cell_size;
  const bool forward = direction == WarpDirection::kToSlam;
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high = -low;
  for (const Vector2d& middle : projector.tileMiddles()) {
    const Vector2d place =
        forward ? middle : projector.slamFromBlueprint({middle, 0.0}, OutsidePolicy::kRigid).pose.translation;
    if (!place.allFinite()) continue;
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  const double border_m = 2.0 * (forward ? reach_m : reach_m * projector.info().scale);
  PoseGrid grid;
  grid.step_m = step_m;
  // Whole multiples of the step: grids of the same building with the same step coincide.
  grid.first = ((low.array() - border_m) / step_m).floor() * step_m;
  const Vector2d size = ((high.array() + border_m - grid.first.array()) / step_m).ceil() + 1.0;
  if (!(size.x() * size.y() <= kMostSamples)) {
    return fail(ErrorCode::kOutOfDomain, "a grid with this step has more than " +
                                             std::to_string(static_cast<int>(kMostSamples / 1e6)) +
                                             " million samples; take a larger one");
  }
  grid.columns = static_cast<std::size_t>(size.x());
  grid.rows = static_cast<std::size_t>(size.y());
  grid.images.reserve(grid.rows * grid.columns);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const Vector2d place = grid.first + step_m * Vector2d(static_cast<double>(column), static_cast<double>(row));
      const Projection image = forward ? projector.slamFromBlueprint({place, 0.0}, OutsidePolicy::kRigid)
                                       : projector.blueprintFromSlam({place, 0.0}, OutsidePolicy::kRigid);
      const bool near = image.ok() && projector.distanceToMesh(forward ? place : image.pose.translation) <= reach_m;
      grid.images.push_back(near ? image.pose : Pose2{{kNaN, kNaN}, kNaN});
    }
  }
  const std::optional<double> deviation = deviationOf(grid, projector, direction);
  if (!deviation) {
    return fail(ErrorCode::kOutOfDomain, "no cell of a grid with this step lies on the mesh; take a smaller one");
  }
  grid.max_deviation_m = *deviation;
  return grid;
}

}  // namespace cad2slam

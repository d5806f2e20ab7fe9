// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/mesh/mesh.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/solver/mesh_solver.h"
#include "cad2slam/solver/solver_settings.h"

namespace cad2slam {

/// The ways to get from blueprint to SLAM map that are compared.
enum class AlignmentMethod {
  kSimilarity,       ///< least squares with scale
  kAffine,           ///< least squares
  kThinPlateSpline,  ///< exact interpolation
  kRigid,            ///< the paper: mesh of poses, scale 1
  kRigidScaled,      ///< the same with the scale of the global fit
  kStretch,          ///< ours
};

inline constexpr std::array<AlignmentMethod, 6> kAllMethods = {
    AlignmentMethod::kSimilarity, AlignmentMethod::kAffine,      AlignmentMethod::kThinPlateSpline,
    AlignmentMethod::kRigid,      AlignmentMethod::kRigidScaled, AlignmentMethod::kStretch};

[[nodiscard]] std::string methodKey(AlignmentMethod method);    ///< as in reports: `thin_plate_spline`
[[nodiscard]] std::string methodLabel(AlignmentMethod method);  ///< as in tables: `thin-plate spline`

/// A fitted function blueprint [m] -> SLAM [m]; NaN where it gives no answer.
using PointFunction = std::function<Eigen::Vector2d(const Eigen::Vector2d& point_in_blueprint)>;

/// Fits any of the methods to one mesh. Keeps a solver: one fitter belongs to one thread.
class MethodFitter {
 public:
  /// `stretch`: settings of our method, so that others than the defaults can be compared.
  explicit MethodFitter(std::shared_ptr<const Mesh> mesh, SolverSettings stretch = defaultSettings(Model::kStretch));

  /// Affine and thin-plate spline fall back to the similarity where the anchors lie on one line, as a user would.
  /// Other errors are those of MeshSolver::solve() and fitSimilarity().
  [[nodiscard]] Result<PointFunction> fit(AlignmentMethod method, const AnchorList& anchors);

  /// The projector of a method with a mesh. kDegenerate for the others.
  [[nodiscard]] Result<Projector> fitProjector(AlignmentMethod method, const AnchorList& anchors);

  [[nodiscard]] SolverSettings settings(AlignmentMethod method) const;

 private:
  std::shared_ptr<const Mesh> mesh_;
  SolverSettings stretch_;
  MeshSolver solver_;
};

}  // namespace cad2slam

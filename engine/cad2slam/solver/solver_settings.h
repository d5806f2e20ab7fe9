// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace cad2slam {

/// What a node may do. kRigid is the paper's model; kStretch adds a log-stretch along the node's own two axes.
enum class Model { kRigid, kStretch };

/// Where the scale of the global fit comes from.
enum class ScaleRule {
  kToScale,       ///< the plan claims to be to scale: least squares shrunk towards 1
  kLeastSquares,  ///< nothing is known of the plan's scale
  kFixed,         ///< a number the installer gives
};

struct ScaleSettings {
  ScaleRule rule = ScaleRule::kToScale;
  double fixed_scale = 1.0;  ///< SLAM metres per blueprint metre; used with kFixed
};

/// Weights of the objective in DESIGN.md section 3. Defaults of both models come from defaultSettings().
struct SolverSettings {
  Model model = Model::kStretch;
  ScaleSettings scale;
  double lambda_x = 1.0;               ///< edge, along the edge
  double lambda_y = 10.0;              ///< edge, across the edge
  std::optional<double> lambda_theta;  ///< [m^2] edge heading; empty: 1.5 m x diagonal of the mesh in SLAM metres
  double lambda_stretch = 1.0;         ///< [m^2] smoothness of the stretch; stretch model only
  double prior_strength = 3.0;  ///< mu_iso = mu_0 = prior_strength / n per square metre of tile; stretch model only
  double anchor_information = 100.0;   ///< k
  std::optional<double> loss_width_m;  ///< width of the Cauchy loss on anchors; empty: squared loss
  int max_iterations = 100;
  double gradient_tolerance = 1e-9;  ///< stop when |gradient| falls below this part of the gradient at the start
};

/// kRigid: the paper (lambda 1, 10, 10, scale fixed at 1, squared loss). kStretch: our default.
[[nodiscard]] SolverSettings defaultSettings(Model model);

}  // namespace cad2slam

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

  friend bool operator==(const ScaleSettings&, const ScaleSettings&) = default;
};

/// How the stretch model shares a deformation between nodes. No single set of weights is best for every building: a
/// hall that is bent smoothly wants another than corridors that drifted each by themselves. kAutomatic tries them all
/// on a coarse mesh and takes the one whose leave-one-out residuals are smallest.
enum class Stiffness {
  kGiven,      ///< lambda_x, lambda_y and lambda_stretch as they stand in the settings
  kAutomatic,  ///< the best of the following; kLocal below nine anchors
  kLocal,      ///< lets each corridor be as long as its anchors say; DESIGN.md section 3
  kSmooth,     ///< bends and shears the building as a whole
  kLoose,      ///< as kSmooth, but passes by its anchors: for clicks noisier than the map is bent
};

/// Weights of the objective in DESIGN.md section 3. The members' own values are the defaults of the stretch model.
struct SolverSettings {
  Model model = Model::kStretch;
  Stiffness stiffness = Stiffness::kAutomatic;  ///< of the stretch model
  ScaleSettings scale;
  double lambda_x = 1.0;               ///< edge, along the edge
  double lambda_y = 10.0;              ///< edge, across the edge
  std::optional<double> lambda_theta;  ///< [m^2] edge heading; empty: 1.5 m (kSmooth, kLoose: 0.6 m) x diagonal of the
                                       ///< mesh in SLAM metres
  double lambda_stretch = 1.0;         ///< [m^2] smoothness of the stretch; stretch model only
  double prior_strength = 3.0;  ///< mu_iso = mu_0 = prior_strength / n per square metre of tile; stretch model only
  double anchor_information = 100.0;         ///< k
  std::optional<double> loss_width_m = 1.0;  ///< width of the Cauchy loss on anchors; empty: squared loss
  int max_iterations = 100;
  double gradient_tolerance = 1e-9;  ///< stop when |gradient| falls below this part of the gradient at the start

  friend bool operator==(const SolverSettings&, const SolverSettings&) = default;
};

/// kRigid: the paper (lambda 1, 10, 10, scale fixed at 1, squared loss). kStretch: our default.
[[nodiscard]] SolverSettings defaultSettings(Model model);

/// The same settings with the weights of one stiffness; kGiven and kAutomatic change nothing.
[[nodiscard]] SolverSettings withStiffness(SolverSettings settings, Stiffness stiffness);

}  // namespace cad2slam

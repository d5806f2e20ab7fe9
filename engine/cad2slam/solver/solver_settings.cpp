// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/solver_settings.h"

namespace cad2slam {

SolverSettings defaultSettings(Model model) {
  SolverSettings settings;
  settings.model = model;
  if (model == Model::kRigid) {
    settings.scale = {ScaleRule::kFixed, 1.0};
    settings.lambda_theta = 10.0;
    settings.lambda_stretch = 0.0;
    settings.prior_strength = 0.0;
  } else {
    settings.loss_width_m = 1.0;
  }
  return settings;
}

}  // namespace cad2slam

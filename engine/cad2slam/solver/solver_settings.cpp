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
    settings.stiffness = Stiffness::kGiven;
    settings.lambda_stretch = 0.0;
    settings.prior_strength = 0.0;
    settings.loss_width_m.reset();
  }
  return settings;
}

SolverSettings withStiffness(SolverSettings settings, Stiffness stiffness) {
  switch (stiffness) {
    case Stiffness::kGiven:
    case Stiffness::kAutomatic:
      return settings;
    case Stiffness::kSmooth:
      settings.lambda_x = 130.0;
      settings.lambda_y = 3.6;
      settings.lambda_stretch = 50.0;
      break;
    case Stiffness::kLocal:
      settings.lambda_x = 1.0;
      settings.lambda_y = 10.0;
      settings.lambda_stretch = 1.0;
      break;
    case Stiffness::kLoose:
      settings.lambda_x = 300.0;
      settings.lambda_y = 3.0;
      settings.lambda_stretch = 100.0;
      settings.anchor_information = 10.0;
      break;
  }
  settings.stiffness = stiffness;
  return settings;
}

}  // namespace cad2slam

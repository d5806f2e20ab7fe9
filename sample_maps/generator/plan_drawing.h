// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <string>

#include "cad2slam/simulation/site_generator.h"

namespace cad2slam::samples {

/// The blueprint as an architect prints it: white rooms, black walls, grey outside; door swings and room numbers in a
/// grey so light that it still reads as free, dimension lines outside in a darker one that reads as unknown.
[[nodiscard]] cv::Mat drawBlueprint(const Building& building, const std::string& title);

}  // namespace cad2slam::samples

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "app/feature_input.h"

#include <iostream>

#include "cad2slam/io/feature_csv.h"

namespace cad2slam::cli {

Result<WarpedFeatures> readWarpedFeatures(const std::string& file, const Projector& projector,
                                          const FeatureWarpOptions& options) {
  const Result<FeatureList> features = readFeatures(file);
  if (!features) return failAs(features);
  Result<WarpedFeatures> warped = warpFeatures(projector, *features, options);
  if (!warped) {
    Error error = warped.error();
    error.where = error.where.empty() ? file : file + ": " + error.where;
    return tl::unexpected(error);
  }
  for (const std::string& warning : warped->warnings) {
    std::cerr << "cad2slam-cli: warning: " << file << ": " << warning << '\n';
  }
  return warped;
}

}  // namespace cad2slam::cli

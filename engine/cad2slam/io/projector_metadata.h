// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "cad2slam/core/result.h"
#include "cad2slam/projection/projector_data.h"

namespace cad2slam {

using ProjectorMetadata = std::map<std::string, std::string>;

/// `__metadata__` of a projector file, without the hashes. Numbers in the shortest form that reads back exactly; empty
/// texts and quality numbers that are not known (not finite) are left out.
[[nodiscard]] ProjectorMetadata metadataOf(const ProjectorInfo& info);

/// kMalformed: another format, an unknown major version, a key that is missing or does not say what it should. Keys
/// that are not known are left alone: a newer minor version may have written them.
[[nodiscard]] Result<ProjectorInfo> infoOf(const ProjectorMetadata& metadata, const std::string& file_name);

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "cad2slam/io/projector_file.h"
#include "cad2slam/io/projector_header.h"
#include "fuzz/property.h"

namespace {

/// The same file with hashes that fit, so that mutations get past them.
std::string sealed(std::string_view bytes) {
  auto layout = cad2slam::parseProjectorLayout(bytes, "fuzz.c2s");
  if (!layout) return std::string(bytes);
  cad2slam::sealProjectorHeader(layout->header, layout->data);
  return cad2slam::formatProjectorPrefix(layout->header) + std::string(layout->data);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cad2slam;
  const std::string bytes = sealed({reinterpret_cast<const char*>(data), size});
  const auto read = parseProjectorFile(bytes, "fuzz.c2s");
  const auto loaded = loadProjector(bytes, "fuzz.c2s");
  if (!read) return 0;
  const auto written = formatProjectorFile(*read);
  fuzzing::expect(written.has_value(), "what was read can be written");
  fuzzing::expect(parseProjectorFile(*written, "fuzz.c2s").has_value(), "what was written can be read");
  if (!loaded) return 0;
  for (const double place : {0.0, 1.0, -3.5, 1e9, std::nan("")}) {
    const Projection projection = loaded->slamFromBlueprint(Pose2{{place, 0.5 * place}, 0.1});
    fuzzing::expect(!projection.ok() || projection.pose.translation.allFinite(), "an answer is finite");
    const Projection back = loaded->blueprintFromSlam(Pose2{{place, 0.5 * place}, 0.1});
    fuzzing::expect(!back.ok() || back.pose.translation.allFinite(), "an answer is finite");
  }
  return 0;
}

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "cad2slam/io/projector_file.h"
#include "fuzz/require.h"
#include "support/projector_parts.h"
#include "support/projector_samples.h"

using namespace cad2slam;

namespace {

void readAndUse(std::string_view bytes) {
  const Result<Projector> loaded = loadProjector(bytes, "a.c2s");
  const Result<ProjectorData> read = parseProjectorFile(bytes, "a.c2s");
  fuzz::require(loaded.has_value() == read.has_value(), "both readers must agree");
  if (!read) {
    fuzz::require(!read.error().message.empty() && read.error().where == "a.c2s", "error without place");
    return;
  }
  for (std::size_t k = 0; k < read->node_blueprint.size() && k < 16; ++k) {
    const Pose2 pose{read->node_blueprint[k], 0.5};
    const Projection there = loaded->slamFromBlueprint(pose, OutsidePolicy::kRigid);
    if (there.ok()) static_cast<void>(loaded->blueprintFromSlam(there.pose, OutsidePolicy::kRigid));
  }
  const Result<std::string> written = formatProjectorFile(*read);
  fuzz::require(written.has_value(), written ? "" : "read but not written: " + written.error().sentence());
  const Result<ProjectorData> again = parseProjectorFile(*written, "a.c2s");
  fuzz::require(again.has_value() && test::sameProjector(*again, *read), "the projector changes");
  fuzz::require(*formatProjectorFile(*again) == *written, "no fixed point");
}

}  // namespace

/// The hashes stop nearly every change, so the input is also read with its seals put right.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string_view input(reinterpret_cast<const char*>(bytes), count);
  readAndUse(input);
  Result<test::ProjectorParts> parts = test::partsOf(input);
  if (!parts) return 0;
  sealProjectorHeader(parts->header, parts->data);
  readAndUse(formatProjectorPrefix(parts->header) + parts->data);
  return 0;
}

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/hints.h"

#include "ui/convert.h"
#include "ui/main_window/session.h"
#include "ui/models/number_text.h"

#include <QCoreApplication>

namespace cad2slam {
namespace {

QString tr(const char* source) {
  return QCoreApplication::translate("Hints", source);
}

}  // namespace

QString hintOf(Session& session) {
  ProjectDocument& document = session.document();
  if (!document.hasBlueprint()) return tr("Choose the blueprint: drop its YAML or image into the left view");
  if (!document.currentMap()) return tr("Choose the SLAM map: drop its YAML or image into the right view");
  if (session.rasters().isLoading()) return tr("Loading the images...");
  if (!session.isReady()) return tr("An image is missing; see the message above");
  if (document.isLocked()) return tr("Anchors are locked for looking only (K unlocks)");
  if (const auto half = session.flow().half()) {
    const bool in_blueprint = half->side == Side::kBlueprint;
    if (session.flow().prediction())
      return in_blueprint
                 ? tr("Click the same place in the SLAM map, or press Enter to take the dashed ring (Esc cancels)")
                 : tr("Click the same place in the blueprint, or press Enter to take the dashed ring (Esc cancels)");
    return in_blueprint ? tr("Now click the same place in the SLAM map (Esc cancels)")
                        : tr("Now click the same place in the blueprint (Esc cancels)");
  }
  const std::size_t used = session.summary().used;
  if (document.anchors().empty()) return tr("Click a corner or pillar in either view");
  if (used <= 1) return tr("Rotation unknown: add another anchor far away from the first");
  if (used == 2) return tr("Rough alignment; add more anchors, best in rooms that have none yet");
  if (used == 3) return tr("Add a fourth anchor, then each one is checked by the others");
  return tr("Add anchors where the overlay is off; look at the worst one with N");
}

ChipState chipOf(Session& session) {
  Alignment& alignment = session.alignment();
  switch (alignment.status()) {
    case AlignmentStatus::kNotReady:
      return {tr("no alignment"), ChipLook::kIdle, tr("Both images are needed")};
    case AlignmentStatus::kNoAnchors:
      return {tr("no anchors"), ChipLook::kIdle, tr("Nothing to solve yet")};
    case AlignmentStatus::kSolving:
      return {tr("solving..."), ChipLook::kBusy, tr("Click to stop (Ctrl+.)")};
    case AlignmentStatus::kUpToDate: {
      const SolveResult& result = *alignment.result();
      return {tr("up to date, %1 s").arg(numberText(result.seconds, 2)), ChipLook::kGood,
              tr("%1 nodes, %2 iterations").arg(result.mesh->nodeCount()).arg(result.solution.iterations)};
    }
    case AlignmentStatus::kFailed:
      return {tr("failed"), ChipLook::kBad, alignment.error() ? toQString(alignment.error()->sentence()) : QString()};
    case AlignmentStatus::kCancelled:
      return {tr("stopped"), ChipLook::kBad, tr("Click to solve again (F5)")};
  }
  return {};
}

}  // namespace cad2slam

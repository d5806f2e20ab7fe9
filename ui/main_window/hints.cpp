// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/hints.h"

#include "ui/engine_sentences.h"
#include "ui/main_window/session.h"
#include "ui/models/foreign_text.h"
#include "ui/models/number_text.h"

#include <QCoreApplication>

namespace cad2slam {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Hints)
};

}  // namespace

QString hintOf(Session& session) {
  ProjectDocument& document = session.document();
  if (!document.hasBlueprint()) return Text::tr("Choose the blueprint: drop its YAML or image into the left view");
  if (!document.currentMap()) return Text::tr("Choose the SLAM map: drop its YAML or image into the right view");
  if (session.rasters().isLoading()) return Text::tr("Loading the images...");
  if (!session.isReady()) return Text::tr("An image is missing; see the message above");
  if (document.isLocked()) return Text::tr("Anchors are locked for looking only (K unlocks)");
  if (const auto half = session.flow().half()) {
    const bool in_blueprint = half->side == Side::kBlueprint;
    if (session.flow().prediction())
      return in_blueprint
                 ? Text::tr(
                       "Click the same place in the SLAM map, or press Enter to take the predicted place (Esc cancels)")
                 : Text::tr(
                       "Click the same place in the blueprint, or press Enter to take the predicted place (Esc "
                       "cancels)");
    return in_blueprint ? Text::tr("Now click the same place in the SLAM map (Esc cancels)")
                        : Text::tr("Now click the same place in the blueprint (Esc cancels)");
  }
  const std::size_t used = session.summary().used;
  if (document.anchors().empty()) return Text::tr("Click a corner or pillar in either view");
  if (session.alignment().status() == AlignmentStatus::kFailed)
    return Text::tr("The alignment could not be solved; see the message above");
  if (session.alignment().status() == AlignmentStatus::kCancelled)
    return Text::tr("The alignment was stopped: F5 solves it again");
  if (used == 0 && session.alignment().status() == AlignmentStatus::kSolving)
    return Text::tr("Solving the alignment...");
  if (used == 0) return Text::tr("No anchor is used: switch some on in the table, or place new ones");
  if (used == 1) return Text::tr("Rotation unknown: add another anchor far away from the first");
  if (used == 2) return Text::tr("Rough alignment; add more anchors, best in rooms that have none yet");
  if (used == 3) return Text::tr("Add a fourth anchor, then each one is checked by the others");
  return Text::tr("Add anchors where the overlay is off; look at the worst one with N");
}

ChipState chipOf(Session& session) {
  Alignment& alignment = session.alignment();
  switch (alignment.status()) {
    case AlignmentStatus::kNotReady:
      return {Text::tr("no alignment"), ChipLook::kIdle, Text::tr("Both images are needed")};
    case AlignmentStatus::kNoAnchors:
      return {Text::tr("no anchors"), ChipLook::kIdle, Text::tr("Nothing to solve yet")};
    case AlignmentStatus::kSolving:
      return {Text::tr("solving..."), ChipLook::kBusy, Text::tr("Click to stop (Ctrl+.)")};
    case AlignmentStatus::kUpToDate: {
      if (alignment.areOthersBusy())
        return {Text::tr("solving the others..."), ChipLook::kBusy,
                Text::tr("The other SLAM maps are solved for the preview; click to stop (Ctrl+.)")};
      const SolveResult& result = *alignment.result();
      return {Text::tr("up to date, %1 s").arg(numberText(result.seconds, 2)), ChipLook::kGood,
              Text::tr("%1 nodes, %2 iterations").arg(result.mesh->nodeCount()).arg(result.solution.iterations)};
    }
    case AlignmentStatus::kFailed: {
      const QString reason = alignment.error() ? toSentence(*alignment.error()) : QString();
      if (reason.isEmpty()) return {Text::tr("failed"), ChipLook::kBad, reason};
      return {Text::tr("failed: %1").arg(shortened(reason)), ChipLook::kBad, asPlainText(reason)};
    }
    case AlignmentStatus::kCancelled:
      return {Text::tr("stopped"), ChipLook::kBad, Text::tr("Click to solve again (F5)")};
  }
  return {};
}

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/status_strip.h"

#include <QString>

namespace cad2slam {

class Session;

/// The one sentence that tells the installer what to do next.
[[nodiscard]] QString hintOf(Session& session);

struct ChipState {
  QString text;
  ChipLook look = ChipLook::kIdle;
  QString tooltip;
};
[[nodiscard]] ChipState chipOf(Session& session);

}  // namespace cad2slam

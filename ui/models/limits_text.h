// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/document_state.h"

#include <QString>

namespace cad2slam {

// How judgeAnchors() judges, in lines that are short enough for a tool tip.

/// Up to where an anchor is OK, or worth a look.
[[nodiscard]] QString limitsText(const ClassLimits& limits);
/// What makes a bad anchor of one that is beyond the limits, or within them.
[[nodiscard]] QString badRuleText();

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/judgement.h"
#include "ui/views/marker.h"

namespace cad2slam {

/// How the views draw a verdict.
[[nodiscard]] inline MarkerClass markerClass(AnchorClass judged) {
  switch (judged) {
    case AnchorClass::kPlain:
      return MarkerClass::kPlain;
    case AnchorClass::kOk:
      return MarkerClass::kOk;
    case AnchorClass::kLook:
      return MarkerClass::kLook;
    case AnchorClass::kBad:
      return MarkerClass::kBad;
    case AnchorClass::kDisabled:
      return MarkerClass::kDisabled;
  }
  return MarkerClass::kPlain;
}

}  // namespace cad2slam

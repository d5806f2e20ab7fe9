// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cad2slam {

/// QUndoCommand::id() of every command that may merge with its predecessor.
enum CommandId : int {
  kEditAnchorsCommandId = 1,
};

}  // namespace cad2slam

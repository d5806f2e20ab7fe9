// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cad2slam {

/// What is being typed into a cell of a table counts: it goes into the document before that is saved or exported.
void finishTyping();

}  // namespace cad2slam

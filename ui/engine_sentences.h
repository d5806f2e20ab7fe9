// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/core/result.h"

#include <QString>

#include <span>
#include <string>

namespace cad2slam {

// The engine knows no Qt and makes its sentences in English. Here they get the language of the application: each is
// recognised by the words that it always holds. What is not recognised stays as it is. From any thread.

/// What Error::sentence() says, as a sentence of its own with a capital letter. File names stay as they are.
[[nodiscard]] QString toSentence(const Error& error);
/// A warning of the engine, or why it left out a line.
[[nodiscard]] QString translatedSentence(const std::string& english);

/// All sentences that are recognised, with %1, %2, ... in this order where texts are inserted; the translations are in
/// the context "Engine".
[[nodiscard]] std::span<const char* const> enginePatterns();

}  // namespace cad2slam

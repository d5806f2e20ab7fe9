// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <string>

namespace cad2slam::test {

/// A text with some bytes changed, taken out, doubled or cut off.
inline std::string damaged(const std::string& text, std::mt19937& random) {
  std::string copy = text;
  for (unsigned k = 0; k < 1 + random() % 4; ++k) {
    const std::size_t place = random() % copy.size();
    switch (random() % 4) {
      case 0:
        copy[place] = static_cast<char>(random());
        break;
      case 1:
        copy[place] = "{}[]\",:-0eE.\n &*"[random() % 16];
        break;
      case 2:
        copy.erase(place, random() % 20);
        break;
      default:
        copy.insert(place, copy.substr(random() % copy.size(), random() % 20));
    }
    if (copy.empty()) copy = " ";
  }
  return random() % 4 == 0 ? copy.substr(0, random() % copy.size()) : copy;
}

}  // namespace cad2slam::test

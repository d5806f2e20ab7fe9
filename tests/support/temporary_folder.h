// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTemporaryDir>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace cad2slam::test {

/// A folder that disappears with the object, and short words for what tests do in it.
class TemporaryFolder {
 public:
  [[nodiscard]] std::filesystem::path path(const std::string& name = {}) const {
    const std::filesystem::path folder = folder_.path().toStdString();
    return name.empty() ? folder : folder / name;
  }
  /// Writes a file and returns its path.
  std::filesystem::path write(const std::string& name, std::string_view content) const {
    std::filesystem::remove(path(name));  // truncating a file in place makes some file systems wait for the disk
    std::ofstream file(path(name), std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    return path(name);
  }
  [[nodiscard]] std::string read(const std::string& name) const { return readAll(path(name)); }
  /// Names of everything in the folder.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path())) names.push_back(entry.path().filename());
    return names;
  }
  static std::string readAll(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace cad2slam::test

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <string>
#include <vector>

#include "cad2slam/core/result.h"

namespace cad2slam {

/// One HTML page that needs no other file: style, pictures and charts are inside. Readable on a phone, printable, light
/// or dark as the reader's system is. All text is escaped.
class HtmlReport {
 public:
  HtmlReport(std::string title, std::string subtitle);

  void addHeading(const std::string& text);
  void addParagraph(const std::string& text);
  /// The first column is left-aligned, the others are numbers. `best_per_column`: the least number of each column is
  /// set in bold, within groups of rows that share `group_column` (-1: all rows are one group).
  void addTable(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                bool best_per_column = false, int group_column = -1);
  /// kInternal when the picture cannot be encoded.
  [[nodiscard]] Result<void> addPicture(const cv::Mat& picture, const std::string& caption);
  void addSvg(const std::string& svg, const std::string& caption);

  [[nodiscard]] std::string page() const;

 private:
  std::string title_;
  std::string subtitle_;
  std::string body_;
};

[[nodiscard]] std::string escapeHtml(const std::string& text);
[[nodiscard]] std::string encodeBase64(const std::vector<unsigned char>& bytes);

}  // namespace cad2slam

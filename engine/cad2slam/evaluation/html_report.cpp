// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/html_report.h"

#include <opencv2/imgcodecs.hpp>

#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace cad2slam {
namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --ink: #1b1f24; --soft: #57606a; --line: #d0d7de; --paper: #ffffff; --accent: #0b6e4f; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6edf3; --soft: #9aa5b1; --line: #39424d; --paper: #14181d; --accent: #58c9a3; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 62rem; padding: 1.2rem; background: var(--paper); color: var(--ink);
       font: 16px/1.5 system-ui, sans-serif; }
h1 { margin: 0; font-size: 1.7rem; line-height: 1.2; }
h2 { margin: 2.2rem 0 .4rem; font-size: 1.2rem; border-bottom: 1px solid var(--line); padding-bottom: .2rem; }
p { margin: .4rem 0 .8rem; max-width: 46rem; }
p.subtitle, figcaption { color: var(--soft); }
.table { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .9rem .25rem 0; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
th { color: var(--soft); font-weight: 500; border-bottom: 1px solid var(--line); }
tr.group td { border-top: 1px solid var(--line); }
b { color: var(--accent); }
figure { margin: 1rem 0; break-inside: avoid; }
figure img, figure svg { max-width: 100%; height: auto; }
figcaption { font-size: .9rem; }
@media print {
  :root { --ink: #000; --soft: #444; --line: #bbb; --paper: #fff; --accent: #000; }
  body { max-width: none; padding: 0; font-size: 10pt; }
  .table { overflow: visible; }
  h2 { break-after: avoid; }
}
)";

std::optional<double> asNumber(const std::string& cell) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size()) return {};
  return value;
}

using Rows = std::vector<std::vector<std::string>>;

bool sameGroup(const Rows& rows, std::size_t a, std::size_t b, int group_column) {
  return group_column < 0 ||
         rows[a][static_cast<std::size_t>(group_column)] == rows[b][static_cast<std::size_t>(group_column)];
}

/// Whether a cell holds the least number of its column and group.
bool isBest(const Rows& rows, std::size_t row, std::size_t column, int group_column) {
  const std::optional<double> own = asNumber(rows[row][column]);
  if (!own || column == 0 || static_cast<int>(column) == group_column) return false;
  for (std::size_t other = 0; other < rows.size(); ++other) {
    const std::optional<double> value = asNumber(rows[other][column]);
    if (value && *value < *own && sameGroup(rows, row, other, group_column)) return false;
  }
  return true;
}

}  // namespace

std::string escapeHtml(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string encodeBase64(const std::vector<unsigned char>& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

HtmlReport::HtmlReport(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

void HtmlReport::addHeading(const std::string& text) {
  body_ += "<h2>" + escapeHtml(text) + "</h2>\n";
}

void HtmlReport::addParagraph(const std::string& text) {
  body_ += "<p>" + escapeHtml(text) + "</p>\n";
}

void HtmlReport::addTable(const std::vector<std::string>& header, const Rows& rows, bool best_per_column,
                          int group_column) {
  body_ += "<div class=\"table\"><table>\n<tr>";
  for (const std::string& cell : header) body_ += "<th>" + escapeHtml(cell) + "</th>";
  body_ += "</tr>\n";
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const bool starts_group = row > 0 && !sameGroup(rows, row - 1, row, group_column);
    body_ += starts_group ? "<tr class=\"group\">" : "<tr>";
    for (std::size_t column = 0; column < rows[row].size(); ++column) {
      const std::string cell = escapeHtml(rows[row][column]);
      const bool bold = best_per_column && isBest(rows, row, column, group_column);
      body_ += "<td>" + (bold ? "<b>" + cell + "</b>" : cell) + "</td>";
    }
    body_ += "</tr>\n";
  }
  body_ += "</table></div>\n";
}

Result<void> HtmlReport::addPicture(const cv::Mat& picture, const std::string& caption) {
  std::vector<unsigned char> png;
  try {
    if (!cv::imencode(".png", picture, png, {cv::IMWRITE_PNG_COMPRESSION, 9})) png.clear();
  } catch (const cv::Exception&) {
    png.clear();
  }
  if (png.empty()) return fail(ErrorCode::kInternal, "A picture of the report could not be encoded");
  body_ += "<figure><img alt=\"" + escapeHtml(caption) + "\" src=\"data:image/png;base64," + encodeBase64(png) +
           "\"><figcaption>" + escapeHtml(caption) + "</figcaption></figure>\n";
  return {};
}

void HtmlReport::addSvg(const std::string& svg, const std::string& caption) {
  body_ += "<figure>" + svg + "<figcaption>" + escapeHtml(caption) + "</figcaption></figure>\n";
}

std::string HtmlReport::page() const {
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  page += "<title>" + escapeHtml(title_) + "</title>\n<style>" + std::string(kStyle) + "</style>\n</head>\n<body>\n";
  page += "<h1>" + escapeHtml(title_) + "</h1>\n<p class=\"subtitle\">" + escapeHtml(subtitle_) + "</p>\n";
  return page + body_ + "</body>\n</html>\n";
}

}  // namespace cad2slam

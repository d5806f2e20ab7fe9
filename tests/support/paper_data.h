// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>

#include <filesystem>
#include <string>

#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/map_file.h"

namespace cad2slam::testing {

/// One data set of the paper's authors, which is not part of this project.
struct PaperSite {
  LoadedMap blueprint;
  AnchorList anchors;
  double cell_size_m = 0.0;
  std::size_t nodes = 0;
  std::size_t edges = 0;
};

inline std::filesystem::path paperFolder(const QString& site) {
  return std::filesystem::path(CAD2SLAM_SHARED_DATA) / site.toStdString();
}

inline bool hasPaperSite(const QString& site) {
  return std::filesystem::exists(paperFolder(site) / "blueprint.yaml");
}

inline Result<PaperSite> loadPaperSite(const QString& site) {
  const std::filesystem::path folder = paperFolder(site);
  Result<LoadedMap> blueprint = loadMap(folder / "blueprint.yaml");
  if (!blueprint) return failAs(blueprint);
  Result<AnchorImport> anchors = readAnchors(folder / "anchors.csv");
  if (!anchors) return failAs(anchors);
  QFile file(QString::fromStdString((folder / "params.json").string()));
  if (!file.open(QIODevice::ReadOnly)) return fail(ErrorCode::kUnreadable, "cannot be opened", "params.json");
  const QJsonObject params = QJsonDocument::fromJson(file.readAll()).object();
  return PaperSite{*blueprint, anchors->anchors, params["cell_size_m"].toDouble(),
                   static_cast<std::size_t>(params["nodes"].toInt()),
                   static_cast<std::size_t>(params["edges"].toInt())};
}

}  // namespace cad2slam::testing

#define CAD2SLAM_SKIP_WITHOUT_PAPER_SITE(site)                                             \
  if (!cad2slam::testing::hasPaperSite(site)) {                                            \
    QSKIP("the data of the paper's authors is not beside this project: nothing to check"); \
  }                                                                                        \
  static_cast<void>(0)

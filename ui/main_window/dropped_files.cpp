// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/dropped_files.h"

#include "ui/main_window/exports.h"
#include "ui/main_window/project_files.h"

#include <algorithm>
#include <utility>

namespace cad2slam {
namespace {

bool endsWithAny(const QString& path, const QStringList& endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&](const QString& ending) { return path.endsWith(ending, Qt::CaseInsensitive); });
}

}  // namespace

DroppedFiles::DroppedFiles(Session& session, ProjectFiles& files, Exports& exports, QObject* parent)
    : QObject(parent), session_(session), files_(files), exports_(exports) {
  // Queued: an import is an edit, which may not come in between while a change is being told.
  connect(&session_.rasters(), &RasterStore::changed, this, &DroppedFiles::importWhenLoaded, Qt::QueuedConnection);
  connect(&session_.document(), &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.what & Change::kEverything) anchors_.clear();  // they were meant for another project
  });
}

void DroppedFiles::take(Side side, const QStringList& paths) {
  QStringList anchors;
  QStringList others;
  for (const QString& path : paths) {
    if (endsWithAny(path, {QStringLiteral(".csv"), QStringLiteral(".data"), QStringLiteral(".points")})) {
      anchors += path;
    } else if (endsWithAny(path, {QStringLiteral(".c2s")})) {
      exports_.inspectProjector(path);
    } else {
      others += path;
    }
  }
  files_.takeDropped(side, others);
  anchors_ += anchors;
  importWhenLoaded();
}

void DroppedFiles::importWhenLoaded() {
  if (session_.rasters().isLoading()) return;
  for (const QString& path : std::exchange(anchors_, {})) exports_.importAnchors(path);
}

}  // namespace cad2slam

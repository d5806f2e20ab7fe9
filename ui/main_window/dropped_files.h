// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/main_window/session.h"

#include <QObject>
#include <QStringList>

namespace cad2slam {

class Exports;
class ProjectFiles;

/// Whatever belongs to a site can be dropped anywhere, all of it together: the images first, then the anchors, which
/// need them.
class DroppedFiles : public QObject {
  Q_OBJECT

 public:
  DroppedFiles(Session& session, ProjectFiles& files, Exports& exports, QObject* parent = nullptr);

  void take(Side side, const QStringList& paths);

 private:
  void importWhenLoaded();

  Session& session_;
  ProjectFiles& files_;
  Exports& exports_;
  QStringList anchors_;  // files that wait for the images
};

}  // namespace cad2slam

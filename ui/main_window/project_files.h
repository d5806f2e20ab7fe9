// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/io/map_file.h"
#include "ui/main_window/session.h"

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <functional>
#include <optional>
#include <string>

class QMenu;
class QWidget;

namespace cad2slam {

class MessageBar;

/// New, open, save and what comes with them: recent projects, dropped files, missing images. Functions with a path do
/// the work and never ask; the others show the dialogs.
class ProjectFiles : public QObject {
  Q_OBJECT

 public:
  ProjectFiles(Session& session, MessageBar& messages, QWidget& window, QMenu& recent_menu);
  ~ProjectFiles() override;

  /// Called before a save, to bring the view state of the document up to date.
  void setBeforeSave(std::function<void()> before_save) { before_save_ = std::move(before_save); }

  bool openProject(const QString& path);
  bool saveProjectTo(const QString& path);
  /// A map YAML or a bare image. For an image the scale is asked for, unless `resolution_m_per_px` gives it.
  bool setImage(Side side, const QString& path, std::optional<double> resolution_m_per_px = std::nullopt);
  /// The image as it is now becomes that of the project; the next opening finds nothing wrong with it.
  void acceptChanged(const RasterProblem& problem);
  bool relocate(const RasterProblem& problem, const QString& path);

  void askNew();
  void askOpen();
  /// False where the installer changed their mind, or it failed. Asks where another program has saved into the file.
  bool askSave();
  bool askSaveAs();
  void askImage(Side side);
  /// Save / Discard / Cancel where there is something to save; false on Cancel.
  [[nodiscard]] bool mayClose();
  /// Where a project of images in `images` is proposed to be saved: not where they were installed with the program.
  [[nodiscard]] static QString folderToSaveIn(const QString& images, const std::optional<QString>& sample);
  void takeDropped(Side side, const QStringList& paths);

 signals:
  void savedOrOpened();

 private:
  [[nodiscard]] const ProjectRaster* rasterOf(const RasterProblem& problem) const;
  void putRaster(const RasterProblem& problem, const ProjectRaster& raster);
  void lookAtFile();
  [[nodiscard]] bool isFileReplaced() const;
  void remember(const QString& path);
  void writeRemembered();
  void fillRecentMenu();
  void showProblem(const RasterProblem& problem);
  void showError(const QString& id, const Error& error,
                 std::vector<std::pair<QString, std::function<void()>>> cures = {});
  [[nodiscard]] QString folder() const;

  Session& session_;
  MessageBar& messages_;
  QWidget& window_;
  QMenu& recent_menu_;
  std::function<void()> before_save_;
  std::string file_sha256_;  // of the project's file as this window read or wrote it; empty: there was none
  QStringList to_remember_;  // paths, the newest last
  QTimer remember_timer_;
};

}  // namespace cad2slam

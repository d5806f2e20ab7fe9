// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/project_document.h"
#include "ui/views/lane.h"

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QString>

#include <atomic>
#include <memory>
#include <vector>

namespace cad2slam {

/// What a program that ended without closing has left behind.
struct Recoverable {
  QString folder;        ///< of its journal
  QString project_path;  ///< where the project was saved, or empty
  QDateTime last_edit;
  Project project;
  QString unreadable;  ///< why there is no project, where its file cannot be read

  /// The project was saved after the last edit here, by another run.
  [[nodiscard]] bool isOvertaken() const;
};

/// Writes the project into a journal after every edit, on another thread, so that a crash loses at most the gesture
/// that was going on. The journal is a folder for each run of the program: the newest versions as complete project
/// files, and a lock that tells whether the program still lives. It goes away when everything is saved or given up.
class Autosave : public QObject {
  Q_OBJECT

 public:
  static constexpr int kVersions = 10;

  /// `root`: holds the journals of all runs.
  Autosave(ProjectDocument& document, const QString& root, QObject* parent = nullptr);
  ~Autosave() override;

  /// In the user's data folder.
  [[nodiscard]] static QString defaultRoot();
  /// Journals under `root` whose programs are dead, newest first. Of each the newest version that can be read; where
  /// none can, it says why, and stays: a newer program may know better.
  [[nodiscard]] static std::vector<Recoverable> findRecoverable(const QString& root);
  static void discard(const Recoverable& recoverable);

  /// Removes the journal of this run: there is nothing to recover any more.
  void clear();
  /// Waits until everything asked for so far is on disk; false where it could not be written.
  bool flush();
  [[nodiscard]] const QString& folder() const { return folder_; }

 signals:
  void written();
  void failed(const QString& sentence);

 private:
  bool prepare();
  void write();
  void tell(const Result<void>& outcome);

  ProjectDocument& document_;
  QString root_;
  QString folder_;
  std::shared_ptr<QLockFile> lock_;
  bool failure_told_ = false;
  std::atomic<int> newest_ = 0;  // version asked for; older ones that still wait are skipped
  Lane lane_;                    // writes and removals keep their order
};

}  // namespace cad2slam

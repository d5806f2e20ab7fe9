// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/projection/make_projector.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/main_window/session.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QProgressDialog;
class QWidget;

namespace cad2slam {

class MessageBar;

/// What speaks for and against writing a projector now. `findings`: what the diagnosis warns of.
[[nodiscard]] std::vector<ExportCheck> exportChecks(Session& session, const QStringList& findings = {});

/// Import and export of anchors, export and inspection of projectors. Functions with a path do the work and never ask.
class Exports : public QObject {
  Q_OBJECT

 public:
  Exports(Session& session, MessageBar& messages, QWidget& window);

  /// Asked before an export for what the diagnosis warns of.
  void setFindings(std::function<QStringList()> findings) { findings_ = std::move(findings); }

  bool importAnchors(const QString& path);
  bool exportAnchors(const QString& path);
  /// Writes the projector, reads it again and compares. `overridden`: warnings the installer exported in spite of.
  /// `map_yaml`: where the blueprint goes as a map in the frame of the SLAM map, with a PNG beside it; empty: nowhere.
  bool exportProjector(const QString& path, const QString& overridden = {}, const QString& map_yaml = {});
  /// Tells what a projector was made from, and whether that is what the project holds now.
  bool inspectProjector(const QString& path);

  /// A path beside the project to propose in a dialog.
  [[nodiscard]] QString suggestion(const QString& extension) const;

  void askImportAnchors();
  void askExportAnchors();
  void askExportProjector();
  void askInspectProjector();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Solved from nothing and aside of the window: the same document gives the same projector to the last bit, whatever
  /// was edited before. The installer can cancel it.
  [[nodiscard]] Result<SolveResultPtr> solveAfresh(const SolveRequest& request);
  [[nodiscard]] Result<void> writeMap(const QString& yaml, const SolveRequest& request, const Projector& projector);
  using IsStopped = std::function<bool()>;
  /// What becomes of work that was done before it noticed that it was cancelled.
  enum class LateCancel { kDropsOutcome, kKeepsOutcome };
  /// Waits for `work` in a dialog that can cancel it; empty where that was done.
  template <class Outcome>
  [[nodiscard]] std::optional<Outcome> inWorker(const QString& label, LateCancel late,
                                                std::function<Outcome(const IsStopped&)> work);
  [[nodiscard]] ProjectorOptions projectorOptions(const QString& overridden) const;
  /// Any file of anchors; `how`: what to add to the message about it.
  [[nodiscard]] Result<AnchorImport> readAnchorFile(const QString& path, QString& how) const;
  void showError(const QString& id, const Error& error);

  Session& session_;
  MessageBar& messages_;
  QWidget& window_;
  std::function<QStringList()> findings_;
  bool exporting_ = false;
  QProgressDialog* progress_ = nullptr;  // of the export that runs
};

}  // namespace cad2slam

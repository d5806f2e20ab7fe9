// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QString>

#include <vector>

class QCheckBox;

namespace cad2slam {

/// One line of the list that is shown before a projector is written.
struct ExportCheck {
  enum class Verdict { kGood, kNote, kWarning, kRefused };
  Verdict verdict = Verdict::kGood;
  QString sentence;
  bool solving_helps = false;
};

/// The check-list before a projector is written. A refusal has no way around but to solve again where that helps, a
/// warning has "export anyway", which is never what Enter does.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  static constexpr int kSolveAgain = QDialog::Accepted + 1;  ///< result() where that was chosen

  ExportDialog(QWidget* parent, const std::vector<ExportCheck>& checks);

  /// Whether the blueprint is to be written as a map as well.
  [[nodiscard]] bool isMapWanted() const;

 private:
  QCheckBox* map_wanted_ = nullptr;  // none where nothing can be exported
};

}  // namespace cad2slam

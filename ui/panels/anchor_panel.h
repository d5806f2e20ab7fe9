// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/anchor_selection.h"
#include "ui/document/judgement.h"
#include "ui/models/anchor_table_model.h"

#include <QSortFilterProxyModel>
#include <QWidget>

#include <array>
#include <optional>

class QLabel;
class QTableView;
class QToolBar;

namespace cad2slam {

/// The anchor table with its footer. Selection is shared with the views.
class AnchorPanel : public QWidget {
  Q_OBJECT

 public:
  AnchorPanel(ProjectDocument& document, AnchorSelection& selection, QWidget* parent = nullptr);

  /// Where the window puts the buttons that act on anchors.
  [[nodiscard]] QToolBar* toolBar() const { return tool_bar_; }
  [[nodiscard]] AnchorTableModel& model() { return model_; }
  [[nodiscard]] QTableView* table() const { return table_; }

  void setSummary(const AlignmentSummary& summary, bool stale);
  /// The anchor after or before this one when sorted by error, worst first; empty where there are none.
  [[nodiscard]] std::optional<AnchorId> nextByError(std::optional<AnchorId> after, bool forward) const;

 signals:
  void jumpRequested(cad2slam::AnchorId id);  ///< a row was chosen: show its anchor
  void toggleRequested();                     ///< Space in the table

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct ColumnWidth {
    int wanted = 0;
    int least = 0;
  };
  void fitColumns();
  void takeSelection();
  void showSelection();

  ProjectDocument& document_;
  AnchorSelection& selection_;
  AnchorTableModel model_;
  QSortFilterProxyModel sorted_;
  QToolBar* tool_bar_;
  QTableView* table_;
  std::array<ColumnWidth, AnchorTableModel::kColumnCount> widths_;
  bool fitting_ = false;
  bool sized_by_hand_ = false;
  QLabel* hint_;
  QLabel* count_;
  QLabel* rms_;
  QLabel* max_;
  QLabel* leave_one_out_;
  bool syncing_ = false;
};

}  // namespace cad2slam

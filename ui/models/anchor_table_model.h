// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/map/map_frame.h"
#include "ui/document/judgement.h"
#include "ui/document/project_document.h"

#include <QAbstractTableModel>
#include <QColor>

#include <array>
#include <map>
#include <optional>

namespace cad2slam {

/// The anchors of the current SLAM map, one a row, in the order of the document. Edits go through commands.
class AnchorTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    kEnabled,
    kNumber,
    kName,
    kBlueprintX,
    kBlueprintY,
    kSlamX,
    kSlamY,
    kResidual,
    kLeaveOneOut,
    kFlag,
    kNote,
    kColumnCount,
  };
  static constexpr int kSortRole = Qt::UserRole;
  static constexpr int kClassRole = Qt::UserRole + 1;  ///< AnchorClass as int, while it is known and current

  explicit AnchorTableModel(ProjectDocument& document, QObject* parent = nullptr);

  /// Numbers of the last solve. `stale`: they belong to an older state, so they are shown grey.
  void setJudgements(std::map<AnchorId, AnchorJudgement> judgements, bool stale);

  /// Of an image, so that pixels can be told; empty while it is not known.
  void setFrame(Side side, const std::optional<MapFrame>& frame);

  [[nodiscard]] AnchorId idOfRow(int row) const;
  [[nodiscard]] std::optional<int> rowOf(AnchorId id) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  void onChanged(const ChangeEvent& event);
  [[nodiscard]] const AnchorJudgement* judgementOf(AnchorId id) const;
  [[nodiscard]] QVariant display(const Anchor& anchor, int column) const;
  [[nodiscard]] QVariant sortValue(const Anchor& anchor, int column) const;
  [[nodiscard]] QString flagText(const Anchor& anchor) const;
  [[nodiscard]] QString tooltip(const Anchor& anchor, int column) const;
  [[nodiscard]] QString judgingText() const;
  [[nodiscard]] QString lengthAndPixels(double length_m) const;  // pixels of the SLAM map

  ProjectDocument& document_;
  std::array<std::optional<MapFrame>, 2> frames_;  // blueprint, SLAM map
  std::map<AnchorId, AnchorJudgement> judgements_;
  bool stale_ = false;
  int row_count_ = 0;  // as announced to the views of this model
};

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/project_document.h"

#include <QObject>

#include <algorithm>
#include <optional>
#include <vector>

namespace cad2slam {

/// Which anchors are selected, the same for the table and both views. The current one is what keys act on; it is the
/// one selected last. Anchors that vanish leave the selection; anchors that undo or redo brings back enter it. Another
/// project or SLAM map begins with none.
class AnchorSelection : public QObject {
  Q_OBJECT

 public:
  explicit AnchorSelection(ProjectDocument& document, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<AnchorId>& ids() const { return ids_; }  ///< in the order of selection
  [[nodiscard]] std::optional<AnchorId> current() const;
  [[nodiscard]] bool contains(AnchorId id) const { return std::find(ids_.begin(), ids_.end(), id) != ids_.end(); }

  void set(std::vector<AnchorId> ids);  ///< those of them that the document has
  void toggle(AnchorId id);
  void clear() { set({}); }

 signals:
  void changed();

 private:
  ProjectDocument& document_;
  std::vector<AnchorId> ids_;
};

}  // namespace cad2slam

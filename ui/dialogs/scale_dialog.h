// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/document_state.h"
#include "ui/views/map_view.h"

#include <QDialog>

#include <filesystem>
#include <memory>
#include <optional>

class QLabel;
class QLineEdit;
class QPushButton;

namespace cad2slam {

class TilePyramid;

/// Asks for the scale of a bare image: typed as metres for each pixel, or by a length drawn on the picture that the
/// installer knows (a wall, a door). Nothing is assumed silently.
class ScaleDialog : public QDialog {
  Q_OBJECT

 public:
  ScaleDialog(QWidget* parent, const std::filesystem::path& image, Side side);
  ~ScaleDialog() override;

  /// Empty when cancelled.
  [[nodiscard]] static std::optional<double> ask(QWidget* parent, const std::filesystem::path& image, Side side);

  [[nodiscard]] std::optional<double> metresPerPixel() const;

 private:
  void onClicked(const QPointF& point);
  void moveEnd(MarkerId id, const QPointF& point);
  void refresh();

  std::shared_ptr<TilePyramid> picture_;
  MapView* view_;
  QLineEdit* resolution_;
  QLineEdit* length_;
  QLabel* measured_;
  QLabel* extent_;
  QPushButton* ok_;
  std::vector<QPointF> ends_px_;  // at most two, pixels of the picture with y up
  std::vector<QPointF> ends_before_drag_px_;
};

}  // namespace cad2slam

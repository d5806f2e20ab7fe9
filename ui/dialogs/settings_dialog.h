// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/project_commands.h"
#include "ui/main_window/appearance.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QTabWidget;

namespace cad2slam {

/// Settings of the project (solver, limits of the anchor classes) and of the program (colours, language).
class SettingsDialog : public QDialog {
  Q_OBJECT

 public:
  SettingsDialog(QWidget* parent, const ProjectSettings& settings, const Appearance& appearance);

  [[nodiscard]] ProjectSettings settings() const;
  [[nodiscard]] Appearance appearance() const;

 private:
  QWidget* solverPage();
  QWidget* limitsPage();
  QWidget* appearancePage();
  QLineEdit* numberField(QFormLayout& form, const QString& label, const QString& tip, const QString& object_name);
  void fill(const SolverSettings& solver);
  void refresh();
  [[nodiscard]] Stiffness stiffness() const;
  void showStiffness();

  ProjectSettings before_;
  QComboBox* model_;
  QComboBox* stiffness_;
  QComboBox* scale_rule_;
  QLineEdit* fixed_scale_;
  QLineEdit* cell_size_;
  QLineEdit* anchor_information_;
  QLineEdit* loss_width_;
  QLineEdit* lambda_x_;
  QLineEdit* lambda_y_;
  QLineEdit* lambda_theta_;
  QLineEdit* lambda_stretch_;
  QLineEdit* prior_;
  QLineEdit* ok_m_;
  QLineEdit* ok_cells_;
  QLineEdit* look_m_;
  QLineEdit* look_cells_;
  QComboBox* theme_;
  QComboBox* language_ = nullptr;
  QPushButton* ok_ = nullptr;
};

}  // namespace cad2slam

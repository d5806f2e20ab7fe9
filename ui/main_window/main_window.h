// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/main_window/actions.h"
#include "ui/main_window/busy_delay.h"
#include "ui/main_window/session.h"

#include <QMainWindow>

#include <memory>

class QComboBox;
class QDockWidget;

namespace cad2slam {

class AnchorEditing;
class AnchorPanel;
class DiagnosisMessages;
class Exports;
class MapView;
class MessageBar;
class PreviewPanel;
class PreviewWiring;
class ProjectFiles;
class Recovery;
class StatusStrip;
class TestPoses;
class ViewPair;

/// The window: puts the parts together and connects them. What the parts do is theirs.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] const Actions& actionTable() const { return *actions_; }
  [[nodiscard]] ViewPair& views() { return *views_; }
  [[nodiscard]] MapView& view(Side side);
  [[nodiscard]] AnchorPanel& anchorPanel() { return *anchor_panel_; }
  [[nodiscard]] PreviewPanel& preview() { return *preview_; }
  [[nodiscard]] MessageBar& messages() { return *messages_; }
  [[nodiscard]] DiagnosisMessages& diagnosis() { return *diagnosis_; }
  [[nodiscard]] Recovery& recovery() { return *recovery_; }
  [[nodiscard]] TestPoses& testPoses() { return *test_poses_; }
  [[nodiscard]] StatusStrip& status() { return *status_; }
  [[nodiscard]] ProjectFiles& files() { return *files_; }
  [[nodiscard]] Exports& exports() { return *exports_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void layOut();
  void connectFileActions();
  void connectViewActions();
  void connectSession();
  void connectTestPoses();
  void refreshTitle();
  void refreshActions();
  [[nodiscard]] MapView& activeView();  ///< the one with the focus, the preview among them
  void refreshHint();
  void refreshStatus();
  void refreshDropZones();
  void refreshTable();
  void refreshMapChoice();
  void showReadout(Side side, const QPointF& point_m, const QPointF& image_px);
  void rotateActiveView(double by_rad);
  void goToNextPart();
  void storeViewState();
  void restoreViewState();

  Session session_;
  Actions* actions_;
  MapView* blueprint_view_;
  MapView* slam_view_;
  ViewPair* views_;
  AnchorPanel* anchor_panel_;
  AnchorEditing* anchor_editing_;
  MessageBar* messages_;
  QComboBox* map_choice_;
  QDockWidget* anchor_dock_;
  PreviewPanel* preview_;
  PreviewWiring* preview_wiring_;
  QDockWidget* preview_dock_;
  std::unique_ptr<StatusStrip> status_;
  ProjectFiles* files_ = nullptr;
  Exports* exports_ = nullptr;
  DiagnosisMessages* diagnosis_ = nullptr;
  Recovery* recovery_ = nullptr;
  TestPoses* test_poses_ = nullptr;
  BusyDelay busy_;
  bool views_restored_ = false;
};

}  // namespace cad2slam

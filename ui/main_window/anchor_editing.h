// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/main_window/actions.h"
#include "ui/main_window/session.h"
#include "ui/panels/message_bar.h"

#include <QObject>

class QWidget;

namespace cad2slam {

class AnchorPanel;
class ViewPair;

/// The actions that edit anchors, connected to commands on the selection.
class AnchorEditing : public QObject {
  Q_OBJECT

 public:
  AnchorEditing(Session& session, const Actions& actions, ViewPair& views, AnchorPanel& panel, MessageBar& messages,
                QWidget& window);

  void refreshActions();
  void deleteSelected();
  void toggleSelected();

 private:
  /// Of a toast about the step that was just made.
  [[nodiscard]] Cure undoCure();
  void renameSelected();
  void typeCoordinates();
  void swapSelected();
  void disableWorst();
  void rescale();
  void flip();
  void copyAnchors();
  void goToNextWorst(bool forward);

  Session& session_;
  const Actions& actions_;
  ViewPair& views_;
  AnchorPanel& panel_;
  MessageBar& messages_;
  QWidget& window_;
};

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

class QMainWindow;
class QMenu;

namespace cad2slam {

class Actions;
class AnchorPanel;

/// Menus whose content somebody else fills.
struct Menus {
  QMenu* recent = nullptr;
  QMenu* slam_maps = nullptr;
  QMenu* docks = nullptr;
};

[[nodiscard]] Menus buildMenus(QMainWindow& window, const Actions& actions);
void buildToolBar(QMainWindow& window, const Actions& actions);
void fillAnchorToolBar(AnchorPanel& panel, const Actions& actions);
/// What a right click on an anchor offers.
void fillAnchorMenu(QMenu& menu, const Actions& actions);
/// What a right click on an empty place offers.
void fillViewMenu(QMenu& menu, const Actions& actions);

}  // namespace cad2slam

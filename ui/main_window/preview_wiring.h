// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/main_window/session.h"
#include "ui/panels/preview_panel.h"
#include "ui/services/preview_service.h"

#include <QObject>
#include <QPointer>

#include <map>
#include <memory>
#include <string>

namespace cad2slam {

/// Keeps the preview showing the last good result of the session. Does nothing while the preview is hidden.
class PreviewWiring : public QObject {
  Q_OBJECT

 public:
  PreviewWiring(Session& session, PreviewPanel& panel, QObject* parent = nullptr);

  [[nodiscard]] PreviewService& service() { return service_; }

 signals:
  void failed(const QString& sentence);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] Side baseSide() const { return panel_.isBlueprintBelow() ? Side::kBlueprint : Side::kSlam; }
  void showBase();
  void refresh();          // scene, inks, reasons
  void refreshOverlays();  // anchors, mesh, residuals
  void askForPicture();
  void addOtherMaps(PreviewScene& scene, std::vector<InkEntry>& inks);
  [[nodiscard]] QString reason() const;
  [[nodiscard]] QString notCurrent() const;
  void follow(const std::shared_ptr<TilePyramid>& picture);
  void onTilesChanged();

  Session& session_;
  PreviewPanel& panel_;
  PreviewService service_;
  bool stale_ = true;
  std::shared_ptr<TilePyramid> base_picture_;
  std::map<std::string, std::shared_ptr<TilePyramid>> other_pictures_;  // by image file
};

}  // namespace cad2slam

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
#include <optional>
#include <string>

namespace cad2slam {

inline const QColor kBlueprintInk(0xe0, 0x00, 0x84);
inline const QColor kSlamInk(0x00, 0x9a, 0x44);

/// What a worker draws one of the two maps from, once its picture is there.
[[nodiscard]] PreviewRaster previewRaster(const RasterStore& rasters, Side side);

/// Keeps the preview showing the last good result of the session. Does nothing while the preview is hidden.
class PreviewWiring : public QObject {
  Q_OBJECT

 public:
  PreviewWiring(Session& session, PreviewPanel& panel, QObject* parent = nullptr);

  [[nodiscard]] PreviewService& service() { return service_; }

 signals:
  void failed(const QString& sentence);
  void centeringWanted(cad2slam::AnchorId id);  ///< a marker was double-clicked

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] Side baseSide() const { return panel_.isBlueprintBelow() ? Side::kBlueprint : Side::kSlam; }
  void showBase();
  void refresh();          // scene, inks, reasons
  void refreshOverlays();  // anchors, mesh, residuals
  void askForPicture();
  struct OtherMap {
    MapMetadata metadata;
    std::optional<MapFrame> frame;  // empty: its image cannot be read
    std::shared_ptr<TilePyramid> picture;
  };
  [[nodiscard]] OtherMap& otherMap(const ProjectSlamMap& map);
  void addAllMaps(PreviewScene& scene, std::vector<InkEntry>& inks);
  [[nodiscard]] QString nameInLegend(const std::string& map) const;
  [[nodiscard]] bool hasOtherResults() const;
  [[nodiscard]] QString reason() const;
  [[nodiscard]] bool isRough() const;  // one anchor only
  [[nodiscard]] QString notCurrent() const;
  void follow(const std::shared_ptr<TilePyramid>& picture);
  void onTilesChanged();

  Session& session_;
  PreviewPanel& panel_;
  PreviewService service_;
  bool stale_ = true;
  std::shared_ptr<TilePyramid> base_picture_;
  std::map<std::string, OtherMap> other_maps_;  // by name, for two may share an image; those that are not being edited
};

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/preview_wiring.h"

#include "ui/document/project_commands.h"
#include "ui/panels/preview_panel.h"
#include "ui/services/preview_service.h"
#include "ui/support/office_window.h"

using namespace cad2slam;
using test::OfficeWindow;

class PreviewWiringTest : public QObject {
  Q_OBJECT

 private slots:
  /// Each would throw away what the other has loaded, for ever.
  void mapsThatShareAnImageAreLoadedOnce() {
    const test::Sandbox sandbox;
    OfficeWindow office;
    const std::string first = office.document().currentMapName();
    office.addExact(5);
    QVERIFY(office.waitUntilSolved());
    ProjectRaster raster = office.document().currentMap()->raster;
    for (const double stretched : {1.0, 1.1, 1.2}) {
      raster.metadata.resolution_m_per_px *= stretched;
      edit::addSlamMap(office.document(), "again", raster);
      QVERIFY(office.waitUntilReady());
      office.addExact(5);
      QVERIFY(office.waitUntilSolved());
    }
    office.document().setCurrentMap(first);
    QVERIFY(office.waitUntilReady());
    QVERIFY(office.waitUntilSolved());
    office.window.preview().setMode(PreviewMode::kAllMaps);
    auto* wiring = office.window.findChild<PreviewWiring*>();
    QVERIFY(wiring);
    const auto scene = [&] { return wiring->service().scene(); };
    const auto isLoaded = [&] {
      if (!scene() || scene()->layers.size() != 4) return false;
      for (const PreviewLayer& layer : scene()->layers)
        if (!layer.raster.isUsable()) return false;
      return true;
    };
    QVERIFY(QTest::qWaitFor(isLoaded, test::kPatience));
    // Nothing is left to load: the same tiles are shown, however often the preview is made anew.
    const auto tiles = [&] {
      std::vector<std::shared_ptr<TileStore>> of_layers;
      for (const PreviewLayer& layer : scene()->layers) of_layers.push_back(layer.raster.tiles);
      return of_layers;
    };
    const auto loaded = tiles();
    for (int i = 0; i < 3; ++i) {
      const auto before = scene();
      emit office.window.preview().modeChanged(PreviewMode::kAllMaps);
      QVERIFY(scene() != before);
      QVERIFY(tiles() == loaded);
    }
  }
};

QTEST_MAIN(PreviewWiringTest)
#include "preview_wiring_test.moc"

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
    QVERIFY(QTest::qWaitFor([&] { return scene() && scene()->layers.size() == 4; }, test::kPatience));
    // Nothing is left to do: the same tiles are shown from now on.
    const auto isQuiet = [&] {
      const auto before = scene();
      QTest::qWait(400);
      return before == scene();
    };
    QTRY_VERIFY_WITH_TIMEOUT(isQuiet(), test::kPatience);
    for (const PreviewLayer& layer : scene()->layers) QVERIFY(layer.raster.isUsable());
  }
};

QTEST_MAIN(PreviewWiringTest)
#include "preview_wiring_test.moc"

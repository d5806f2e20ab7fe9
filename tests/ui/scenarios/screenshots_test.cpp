// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/cheat_sheet.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/scale_dialog.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/document/project_commands.h"
#include "ui/main_window/appearance.h"
#include "ui/main_window/exports.h"
#include "ui/main_window/program_actions.h"
#include "ui/panels/preview_panel.h"
#include "ui/support/documents.h"
#include "ui/support/office_window.h"

#include <QFileInfo>
#include <QTabWidget>

using namespace cad2slam;
using test::OfficeWindow;

/// Pictures of the main states, in CAD2SLAM_SCREENSHOTS or in "screenshots" beside the program, to be looked at.
class ScreenshotsTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;
  QString folder_;

  void shoot(QWidget& widget, const char* name) {
    QTest::qWait(400);  // whatever is drawn in the background
    const QString path = folder_ + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png");
    QVERIFY(widget.grab().save(path));
    QVERIFY(QFileInfo(path).size() > 4000);
  }

 private slots:
  void initTestCase() {
    folder_ = qEnvironmentVariable("CAD2SLAM_SCREENSHOTS",
                                   QCoreApplication::applicationDirPath() + QStringLiteral("/screenshots"));
    QVERIFY(QDir().mkpath(folder_));
  }
  void init() {
    sandbox_.emplace();
    applyTheme(Theme::kLight);
  }
  void cleanup() {
    applyLanguage(QStringLiteral("en"));
    applyTheme(Theme::kSystem);
  }

  void empty() {
    OfficeWindow office(false);
    shoot(office.window, "01-empty");
  }

  void working() {
    OfficeWindow office;
    shoot(office.window, "02-no-anchors");
    office.addExact(8);
    QVERIFY(office.waitUntilSolved());
    office.click(Side::kBlueprint, toQPointF(office.pairs[12].in_blueprint));
    QTRY_VERIFY_WITH_TIMEOUT(office.session().flow().prediction().has_value(), test::kPatience);
    shoot(office.window, "03-predicted-counterpart");
    office.key(Side::kSlam, Qt::Key_Return);
    office.addExact(17, 13);
    QVERIFY(office.waitUntilSolved());
    office.window.preview().setMode(PreviewMode::kTwoInk);
    office.session().selection().set({5});
    shoot(office.window, "04-two-inks");
    office.window.actionTable()[ActionId::kMesh]->setChecked(true);
    office.window.preview().setMode(PreviewMode::kStretch);
    shoot(office.window, "05-mesh-and-stretch");
    office.window.actionTable()[ActionId::kMesh]->setChecked(false);
    office.window.actionTable()[ActionId::kPlanPath]->setChecked(true);
    office.window.preview().setMode(PreviewMode::kOverlay);
    shoot(office.window, "06-test-pose-and-path");
    office.window.actionTable()[ActionId::kTestPose]->setChecked(false);
    office.window.actionTable()[ActionId::kPlanPath]->setChecked(false);
    edit::swapCounterparts(office.document(), 3, 9);
    QVERIFY(office.waitForFinding(Finding::Kind::kSwapped));
    shoot(office.window, "07-swapped");
    ExportDialog gate(&office.window, exportChecks(office.session()));
    gate.show();
    shoot(gate, "08-export-checks");
    office.document().undoStack().undo();
    QVERIFY(office.waitUntilSolved());
    QVERIFY(saveReport(office.window, folder_ + QStringLiteral("/report.pdf")));
    applyTheme(Theme::kDark);
    shoot(office.window, "09-dark");
    applyTheme(Theme::kHighContrast);
    shoot(office.window, "10-high-contrast");
  }

  void dialogs() {
    OfficeWindow office;
    SettingsDialog settings(&office.window, {defaultSettings(Model::kStretch), std::nullopt, {}}, {});
    settings.show();
    shoot(settings, "11-settings");
    settings.findChild<QTabWidget*>()->setCurrentIndex(1);
    shoot(settings, "11-settings-limits");
    CheatSheet keys(&office.window, office.window.actionTable());
    keys.show();
    shoot(keys, "12-keys");
    ScaleDialog scale(&office.window, toPath(OfficeWindow::sample("blueprint.png")), Side::kBlueprint);
    scale.show();
    shoot(scale, "13-scale");
  }

  void everyMode() {
    OfficeWindow office(false);
    QVERIFY(office.openSolved(OfficeWindow::sample("office.c2sproj")));
    static constexpr const char* kNames[kPreviewModeCount] = {"overlay", "two-inks", "swipe",     "blink",
                                                              "lens",    "mesh",     "residuals", "stretch",
                                                              "turn",    "coverage", "all-maps"};
    PreviewPanel& preview = office.window.preview();
    for (int mode = 0; mode < kPreviewModeCount; ++mode) {
      preview.setMode(static_cast<PreviewMode>(mode));
      if (preview.mode() == PreviewMode::kLens) QTest::mouseMove(&preview.view(), QPoint(260, 120));
      if (preview.mode() == PreviewMode::kAllMaps)
        QTRY_VERIFY_WITH_TIMEOUT(!office.session().alignment().areOthersBusy(), test::kPatience);
      shoot(preview, qPrintable(QStringLiteral("20-mode-%1-%2").arg(mode).arg(QLatin1String(kNames[mode]))));
    }
    preview.setMode(PreviewMode::kOverlay);
    const Actions& actions = office.window.actionTable();
    actions[ActionId::kExaggerate]->setChecked(true);
    actions[ActionId::kLink]->setChecked(true);
    office.window.view(Side::kBlueprint).setRotation(kPi / 6.0);
    office.window.view(Side::kBlueprint).zoomBy(1.6);
    shoot(office.window, "21-linked-and-exaggerated");
    actions[ActionId::kLoupe]->setChecked(true);
    QTest::mouseMove(&office.window.view(Side::kBlueprint), QPoint(300, 200));
    shoot(office.window, "22-loupe-and-mirrored-cursor");
  }

  void realBuildings_data() {
    QTest::addColumn<QString>("site");
    QTest::newRow("diag") << QStringLiteral("diag");
    QTest::newRow("eiii-0") << QStringLiteral("eiii-0");
  }
  void realBuildings() {
    QFETCH(QString, site);
    const QString folder = QStringLiteral(CAD2SLAM_SHARED_DATA "/") + site;
    if (!QFileInfo::exists(folder)) QSKIP("Needs the published data");
    OfficeWindow office(false);
    // The whole way of an installer: both maps, the anchors, a project, the file for the robots, and open it again.
    QVERIFY(office.setMaps(folder + QStringLiteral("/blueprint.yaml"), folder + QStringLiteral("/slam.yaml")));
    QVERIFY(office.window.exports().importAnchors(folder + QStringLiteral("/correspondences.data")));
    QVERIFY(office.waitUntilSolved());
    QTest::qWait(1500);  // diagnosis, tiles
    shoot(office.window, qPrintable(QStringLiteral("30-") + site));
    office.window.preview().setMode(PreviewMode::kTwoInk);
    shoot(office.window.preview(), qPrintable(QStringLiteral("31-%1-two-inks").arg(site)));
    office.window.preview().setMode(PreviewMode::kMesh);
    shoot(office.window.preview(), qPrintable(QStringLiteral("32-%1-mesh").arg(site)));
    const QString project = sandbox_->path(QStringLiteral("site.c2sproj"));
    const QString projector = sandbox_->path(QStringLiteral("site.c2s"));
    QVERIFY(office.window.files().saveProjectTo(project));
    QVERIFY(office.window.exports().exportProjector(projector, QStringLiteral("a try")));
    QVERIFY(saveReport(office.window, folder_ + QStringLiteral("/report-%1.pdf").arg(site)));
    const std::size_t anchors = office.document().anchors().size();
    OfficeWindow again(false);
    QVERIFY(again.openSolved(project));
    QCOMPARE(again.document().anchors().size(), anchors);
    QVERIFY(again.window.exports().inspectProjector(projector));
    shoot(again.window, qPrintable(QStringLiteral("33-%1-opened-again").arg(site)));
  }

  void problems() {
    OfficeWindow office;
    office.addExact(3);
    const std::filesystem::path image = office.document().project().blueprint.metadata.image;
    office.window.files().relocate({RasterProblem::Kind::kMissing, Side::kBlueprint, {}, image, {}, 0, {}},
                                   sandbox_->path(QStringLiteral("nowhere.png")));
    QTRY_VERIFY_WITH_TIMEOUT(office.hasMessage(QStringLiteral("image-0")), test::kPatience);
    shoot(office.window, "40-missing-image");
    office.document().reset(Project{}, {});
    office.document().reset(test::smallProject(), "/nowhere/site.c2sproj", true);
    shoot(office.window, "41-missing-images");
  }

  void spanish() {
    applyLanguage(QStringLiteral("es"));
    OfficeWindow office;
    office.addExact(12);
    QVERIFY(office.waitUntilSolved());
    QTest::qWait(600);
    shoot(office.window, "15-spanish");
    SettingsDialog settings(&office.window, {defaultSettings(Model::kStretch), std::nullopt, {}}, {});
    settings.show();
    shoot(settings, "16-spanish-settings");
  }

  void german() {
    applyLanguage(QStringLiteral("de"));
    OfficeWindow office;
    office.addExact(12);
    QVERIFY(office.waitUntilSolved());
    shoot(office.window, "14-german");
    SettingsDialog settings(&office.window, {defaultSettings(Model::kStretch), std::nullopt, {}}, {});
    settings.show();
    shoot(settings, "17-german-settings");
    CheatSheet keys(&office.window, office.window.actionTable());
    keys.show();
    shoot(keys, "18-german-keys");
  }
};

QTEST_MAIN(ScreenshotsTest)
#include "screenshots_test.moc"

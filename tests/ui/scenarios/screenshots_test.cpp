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
#include "ui/support/office_window.h"

#include <QFileInfo>

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
    CheatSheet keys(&office.window, office.window.actionTable());
    keys.show();
    shoot(keys, "12-keys");
    ScaleDialog scale(&office.window, toPath(OfficeWindow::sample("blueprint.png")), Side::kBlueprint);
    scale.show();
    shoot(scale, "13-scale");
  }

  void german() {
    applyLanguage(QStringLiteral("de"));
    OfficeWindow office;
    office.addExact(12);
    QVERIFY(office.waitUntilSolved());
    shoot(office.window, "14-german");
  }
};

QTEST_MAIN(ScreenshotsTest)
#include "screenshots_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/program_actions.h"

#include "cad2slam/geometry/angle.h"
#include "cad2slam/io/atomic_file.h"
#include "ui/convert.h"
#include "ui/dialogs/cheat_sheet.h"
#include "ui/dialogs/numbers_dialog.h"
#include "ui/dialogs/save_path.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/document/project_commands.h"
#include "ui/engine_sentences.h"
#include "ui/main_window/appearance.h"
#include "ui/main_window/diagnosis_messages.h"
#include "ui/main_window/exports.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/report.h"
#include "ui/main_window/tour.h"
#include "ui/main_window/view_pair.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/preview_panel.h"
#include "ui/tools/test_poses.h"
#include "ui/views/map_view.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QInputDialog>
#include <QMessageBox>
#include <QSettings>

namespace cad2slam {
namespace {

constexpr std::size_t kLargestPoseFile = std::size_t{64} << 20;

struct Text {
  Q_DECLARE_TR_FUNCTIONS(ProgramActions)
};

/// All of it, whatever part is on the screen.
QImage wholeMap(MapView& view) {
  const ViewState before = view.viewState();
  const bool was_fitted = view.isFitted();
  const QSignalBlocker quiet(view);  // linked views stay where they are
  view.fit();
  const QImage picture = view.grab().toImage();
  if (!was_fitted) view.setViewState(before);
  return picture;
}

void askSettings(MainWindow& window) {
  ProjectDocument& document = window.session().document();
  const Appearance before = readAppearance();
  SettingsDialog dialog(&window, {document.project().settings, document.project().cell_size_m, document.state().limits},
                        before);
  if (dialog.exec() != QDialog::Accepted) return;
  edit::changeSettings(document, dialog.settings());
  const Appearance after = dialog.appearance();
  if (after == before) return;
  writeAppearance(after);
  applyTheme(after.theme);
  window.actionTable()[ActionId::kHighContrast]->setChecked(after.theme == Theme::kHighContrast);
  if (after.language != before.language)
    window.messages().show({QStringLiteral("language"),
                            Severity::kNote,
                            Text::tr("The language changes at the next start of the program"),
                            {},
                            6000});
}

void showPoses(MainWindow& window, const QByteArray& text, const QString& from) {
  bool ok = false;
  const QStringList sides{Text::tr("SLAM map"), Text::tr("Blueprint")};
  const QString side = QInputDialog::getItem(&window, Text::tr("Show poses"),
                                             Text::tr("The poses are in the frame of the:"), sides, 0, false, &ok);
  if (!ok) return;
  const TestPoses::PoseImport import =
      window.testPoses().loadPoses(text, side == sides[0] ? Side::kSlam : Side::kBlueprint);
  Message message{QStringLiteral("poses"), Severity::kNote, Text::tr("%1 poses shown").arg(import.shown), {}, 5000};
  if (import.skipped > 0)
    message.text += QStringLiteral(", ") + Text::tr("%1 lines without two numbers left out").arg(import.skipped);
  if (import.cut) {
    message.text += QStringLiteral(". ") + Text::tr("There are more: only the first are shown");
    message.vanishes_after_ms = 0;
  }
  if (import.shown == 0)
    message = {message.id, Severity::kWarning, Text::tr("No line of %1 starts with two numbers x, y").arg(from), {}, 0};
  window.messages().show(std::move(message));
}

}  // namespace

void connectProgramActions(MainWindow& window) {
  const Actions& actions = window.actionTable();
  const auto on = [&](ActionId id, auto work) { QObject::connect(actions[id], &QAction::triggered, &window, work); };
  on(ActionId::kSettings, [&window] { askSettings(window); });
  on(ActionId::kCheatSheet, [&window] {
    CheatSheet sheet(&window, window.actionTable());
    sheet.exec();
  });
  on(ActionId::kExportReport, [&window] {
    const QString path =
        askSavePath(&window, Text::tr("Save report"), window.exports().suggestion(QStringLiteral("-report.pdf")),
                    Text::tr("PDF (*.pdf)"), QStringLiteral(".pdf"));
    if (!path.isEmpty()) saveReport(window, path);
  });
  QAction* report = actions[ActionId::kExportReport];
  const auto refresh_report = [&window, report, tip = report->toolTip()] {
    const bool ready = window.session().isReady();
    report->setEnabled(ready);
    report->setToolTip(ready ? tip : Text::tr("A report is about a blueprint and a SLAM map: load both first"));
    report->setStatusTip(report->toolTip());
  };
  QObject::connect(&window.session().rasters(), &RasterStore::changed, &window, refresh_report);
  refresh_report();
  on(ActionId::kTypePose, [&window] { askTestPose(window); });
  on(ActionId::kTour, [&window] { startTour(window); });
  on(ActionId::kAbout, [&window] {
    QMessageBox::about(
        &window, Text::tr("About CAD2SLAM"),
        Text::tr("<h3>CAD2SLAM %1</h3><p>Projects poses between building blueprints and robot SLAM maps.</p>"
                 "<p>Apache License 2.0. Uses Qt, Ceres, SuiteSparse, OpenCV and Eigen.</p>")
            .arg(QCoreApplication::applicationVersion()));
  });
  QAction* contrast = actions[ActionId::kHighContrast];
  contrast->setChecked(readAppearance().theme == Theme::kHighContrast);
  on(ActionId::kHighContrast, [contrast] {
    Appearance appearance = readAppearance();
    QSettings settings;
    const QString before = QStringLiteral("theme_before_high_contrast");
    if (contrast->isChecked()) {
      settings.setValue(before, static_cast<int>(appearance.theme));
      appearance.theme = Theme::kHighContrast;
    } else {
      const int theme = settings.value(before, static_cast<int>(Theme::kSystem)).toInt();
      const bool known = theme == static_cast<int>(Theme::kLight) || theme == static_cast<int>(Theme::kDark);
      appearance.theme = known ? static_cast<Theme>(theme) : Theme::kSystem;
    }
    writeAppearance(appearance);
    applyTheme(appearance.theme);
  });
}

bool saveReport(MainWindow& window, const QString& path) {
  ReportExtras extras;
  if (const QImage both = picturesOverEachOther(window.session()); !both.isNull())
    extras.pictures.push_back({Text::tr("Both maps: blueprint magenta, SLAM map green, dark where they agree"), both});
  extras.pictures.push_back({Text::tr("Blueprint"), wholeMap(window.view(Side::kBlueprint))});
  extras.pictures.push_back({Text::tr("SLAM map"), wholeMap(window.view(Side::kSlam))});
  extras.findings = window.diagnosis().sentences(Severity::kNote);
  const QString id = QStringLiteral("report");
  if (const Result<void> written = writeReport(path, window.session(), extras); !written) {
    window.messages().show({id, Severity::kError, toSentence(written.error()), {}, 0});
    return false;
  }
  window.messages().show({id, Severity::kNote, Text::tr("Report written to %1").arg(path), {}, 6000});
  return true;
}

void askTestPose(MainWindow& window) {
  constexpr double kDegree = kPi / 180.0;
  const Side side = window.views().activeSide();
  TestPoses& poses = window.testPoses();
  const std::optional<Pose2> now = poses.isRobotVisible() ? poses.robotIn(side) : std::nullopt;
  NumbersDialog dialog(
      &window,
      side == Side::kBlueprint ? Text::tr("Test pose in the blueprint") : Text::tr("Test pose in the SLAM map"),
      {{Text::tr("&x (m):"), now ? std::optional(now->translation.x()) : std::nullopt},
       {Text::tr("&y (m):"), now ? std::optional(now->translation.y()) : std::nullopt},
       {Text::tr("&Heading (degrees):"), now ? now->heading / kDegree : 0.0}});
  if (dialog.exec() != QDialog::Accepted) return;
  const Pose2 pose{{dialog.value(0), dialog.value(1)}, wrapAngle(dialog.value(2) * kDegree)};
  if (!poses.setRobotIn(side, pose)) {
    window.messages().show({QStringLiteral("poses"),
                            Severity::kWarning,
                            Text::tr("A pose of the SLAM map can be shown once there is an alignment"),
                            {},
                            6000});
    return;
  }
  window.actionTable()[ActionId::kTestPose]->setChecked(true);
  for (const Side each : {Side::kBlueprint, Side::kSlam}) {
    const std::optional<Pose2> there = poses.robotIn(each);
    if (there) window.views().bringIntoView(each, toQPointF(there->translation));
  }
}

void askPoses(MainWindow& window) {
  const QString path = QFileDialog::getOpenFileName(&window, Text::tr("Show poses from file"), QString(),
                                                    Text::tr("Poses (*.csv *.txt);;All files (*)"));
  if (path.isEmpty()) return;
  const Result<std::string> text = readFile(toPath(path), kLargestPoseFile);
  if (!text) {
    window.messages().show({QStringLiteral("poses"), Severity::kError, toSentence(text.error()), {}, 0});
    return;
  }
  showPoses(window, QByteArray::fromStdString(*text), QFileInfo(path).fileName());
}

void pastePoses(MainWindow& window) {
  showPoses(window, QGuiApplication::clipboard()->text().toUtf8(), Text::tr("the clipboard"));
}

void startTour(MainWindow& window) {
  (new Tour(window))->start();
}

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/io/anchors_csv.h"
#include "ui/convert.h"
#include "ui/document/anchor_commands.h"
#include "ui/main_window/diagnosis_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/project_files.h"
#include "ui/main_window/tips.h"
#include "ui/main_window/view_pair.h"
#include "ui/panels/message_bar.h"
#include "ui/services/autosave.h"
#include "ui/views/map_view.h"

#include <QApplication>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <optional>

namespace cad2slam::test {

inline constexpr int kPatience = 60'000;  // [ms] a machine under load is no failure

/// Settings and journals of a test stay in a folder of its own.
class Sandbox {
 public:
  Sandbox() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("cad2slam-test"));
    QCoreApplication::setApplicationName(QStringLiteral("test-%1").arg(QCoreApplication::applicationPid()));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
    QLocale::setDefault(QLocale::c());
    Tips::setWanted(false);
  }
  ~Sandbox() { QDir(Autosave::defaultRoot()).removeRecursively(); }
  [[nodiscard]] QString path(const QString& name) const { return folder_.filePath(name); }

 private:
  QTemporaryDir folder_;
};

/// The real window with the sample office, and hands that click in it.
class OfficeWindow {
 public:
  explicit OfficeWindow(bool with_maps = true) {
    window.resize(1400, 900);
    window.show();
    (void)QTest::qWaitForWindowExposed(&window);
    pairs = readAnchors(toPath(sample("anchors_1.csv"))).value().anchors;
    if (with_maps) loadMaps();
  }

  [[nodiscard]] static QString sample(const char* name) {
    return QStringLiteral(CAD2SLAM_SAMPLE_MAPS "/office/") + QLatin1String(name);
  }

  void loadMaps() {
    setMaps(sample("blueprint.yaml"), sample("slam_1.yaml"));
    for (const Side side : {Side::kBlueprint, Side::kSlam}) window.view(side).setSnapping(false);
    window.actionTable()[ActionId::kSnap]->setChecked(false);
  }

  bool setMaps(const QString& blueprint, const QString& slam) {
    return window.files().setImage(Side::kBlueprint, blueprint) && window.files().setImage(Side::kSlam, slam) &&
           waitUntilReady();
  }
  bool openSolved(const QString& project) {
    return window.files().openProject(project) && waitUntilReady() && waitUntilSolved();
  }

  bool waitUntilReady() {
    return QTest::qWaitFor([&] { return session().isReady() && session().rasters().grid(Side::kBlueprint); },
                           kPatience);
  }
  bool waitUntilSolved() {
    return QTest::qWaitFor([&] { return session().alignment().status() == AlignmentStatus::kUpToDate; }, kPatience);
  }
  bool waitForFinding(Finding::Kind kind) {
    return QTest::qWaitFor([&] { return finding(kind) != nullptr; }, kPatience);
  }
  [[nodiscard]] const Finding* finding(Finding::Kind kind) {
    for (const Finding& each : window.diagnosis().findings())
      if (each.kind == kind) return &each;
    return nullptr;
  }
  /// Presses the cure of a message as its button would.
  bool pressCure(const QString& id_start, const QString& label_start) {
    for (const Message& message : window.messages().messages()) {
      if (!message.id.startsWith(id_start)) continue;
      for (const Cure& cure : message.cures) {
        if (!cure.label.startsWith(label_start)) continue;
        const auto run = cure.run;  // the message may go away while it runs
        run();
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool hasMessage(const QString& id_start) {
    for (const Message& message : window.messages().messages())
      if (message.id.startsWith(id_start)) return true;
    return false;
  }

  void click(Side side, const QPointF& point_m, Qt::KeyboardModifiers modifiers = {}) {
    MapView& v = window.view(side);
    QTest::mouseClick(&v, Qt::LeftButton, modifiers, v.widgetFromMetres(point_m).toPoint());
  }
  void key(Side side, Qt::Key which, Qt::KeyboardModifiers modifiers = {}) {
    window.view(side).setFocus();
    QTest::keyClick(&window.view(side), which, modifiers);
  }
  /// Places the sample's anchor number `at` by two clicks.
  void place(std::size_t at) {
    click(Side::kBlueprint, toQPointF(pairs[at].in_blueprint));
    click(Side::kSlam, toQPointF(pairs[at].in_slam));
  }
  /// Adds exact anchors of the sample without clicking.
  void addExact(std::size_t count, std::size_t from = 0) {
    for (std::size_t i = from; i < from + count && i < pairs.size(); ++i)
      edit::addAnchor(document(), pairs[i].in_blueprint, pairs[i].in_slam);
  }

  [[nodiscard]] Session& session() { return window.session(); }
  [[nodiscard]] ProjectDocument& document() { return window.session().document(); }
  /// What one click can be off by in metres: rounding to whole pixels of the view.
  [[nodiscard]] double clickError(Side side) { return window.view(side).viewState().m_per_px; }

  MainWindow window;
  AnchorList pairs;
};

}  // namespace cad2slam::test

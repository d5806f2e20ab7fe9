// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "app/version.h"
#include "ui/main_window/appearance.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/process_setup.h"
#include "ui/main_window/program_actions.h"
#include "ui/main_window/project_files.h"
#include "ui/main_window/recovery.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>

int main(int argc, char** argv) {
  cad2slam::setUpProcess();
  QApplication app(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("cad2slam"));
  QApplication::setApplicationName(QStringLiteral("cad2slam"));
  QApplication::setApplicationDisplayName(QStringLiteral("CAD2SLAM"));
  QApplication::setApplicationVersion(QString::fromLatin1(cad2slam::kVersion));
  // Names the desktop entry, by which a Wayland desktop finds the icon of the window.
  QGuiApplication::setDesktopFileName(QStringLiteral("org.cad2slam.cad2slam"));

  QCommandLineParser arguments;
  arguments.setApplicationDescription(
      QCoreApplication::translate("main", "Joins the blueprint of a building with a robot's SLAM map."));
  arguments.addHelpOption();
  arguments.addVersionOption();
  arguments.addPositionalArgument(QStringLiteral("project"),
                                  QCoreApplication::translate("main", "Project to open (.c2sproj)."),
                                  QStringLiteral("[PROJECT.c2sproj]"));
  arguments.process(app);

  const cad2slam::Appearance appearance = cad2slam::readAppearance();
  cad2slam::applyLanguage(appearance.language);
  cad2slam::applyTheme(appearance.theme);

  cad2slam::MainWindow window;
  window.show();
  const bool can_recover = window.recovery().offer();
  QSettings settings;
  if (const QStringList projects = arguments.positionalArguments(); !projects.isEmpty()) {
    window.files().openProject(projects.constFirst());
  } else if (!can_recover && !settings.value(QStringLiteral("tour_shown")).toBool()) {
    settings.setValue(QStringLiteral("tour_shown"), true);
    cad2slam::startTour(window);
  }
  return QApplication::exec();
}

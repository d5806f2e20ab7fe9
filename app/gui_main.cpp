// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "app/version.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/project_files.h"

#include <QApplication>

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("cad2slam"));
  QApplication::setApplicationName(QStringLiteral("cad2slam"));
  QApplication::setApplicationDisplayName(QStringLiteral("CAD2SLAM"));
  QApplication::setApplicationVersion(QString::fromLatin1(cad2slam::kVersion));

  cad2slam::MainWindow window;
  window.show();
  if (const QStringList arguments = QApplication::arguments(); arguments.size() > 1)
    window.files().openProject(arguments.at(1));
  return QApplication::exec();
}

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/save_path.h"

#include "ui/models/foreign_text.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include <algorithm>

namespace cad2slam {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(SavePath)
};

}  // namespace

QString askSavePath(QWidget* parent, const QString& title, const QString& proposal, const QString& filter,
                    const QString& suffix) {
  QString path = proposal;
  for (;;) {
    path = QFileDialog::getSaveFileName(parent, title, path, filter);
    if (path.isEmpty() || path.endsWith(suffix, Qt::CaseInsensitive)) return path;
    path += suffix;
    if (mayReplace(parent, title, {path})) return path;
  }
}

bool mayReplace(QWidget* parent, const QString& title, const QStringList& paths) {
  return std::all_of(paths.begin(), paths.end(), [&](const QString& path) {
    if (!QFileInfo::exists(path)) return true;
    const QString question = Text::tr("%1 already exists. Replace it?").arg(QFileInfo(path).fileName());
    return QMessageBox::question(parent, title, asPlainText(question)) == QMessageBox::Yes;
  });
}

}  // namespace cad2slam

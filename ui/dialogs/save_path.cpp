// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/save_path.h"

#include "ui/models/foreign_text.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

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
    if (!QFileInfo::exists(path)) return path;
    const QString question = Text::tr("%1 already exists. Replace it?").arg(QFileInfo(path).fileName());
    if (QMessageBox::question(parent, title, asPlainText(question)) == QMessageBox::Yes) return path;
  }
}

}  // namespace cad2slam

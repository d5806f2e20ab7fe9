// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/support/office_window.h"

#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

using namespace cad2slam;
using test::OfficeWindow;

/// Dialogs that ask for files, driven as somebody at the keyboard would.
class DialogsTest : public QObject {
  Q_OBJECT

 private slots:
  void aFileWhoseSuffixWasLeftOutIsNotReplacedUnasked() {
    const test::Sandbox sandbox;
    const QString path = sandbox.path(QStringLiteral("site.c2sproj"));
    {
      QFile other(path);
      QVERIFY(other.open(QIODevice::WriteOnly));
      other.write("somebody's work");
    }
    OfficeWindow office;
    int names_given = 0;
    QTimer driver;  // types the name, says no, gives up
    connect(&driver, &QTimer::timeout, &driver, [&] {
      QWidget* modal = QApplication::activeModalWidget();
      if (auto* question = qobject_cast<QMessageBox*>(modal)) return question->button(QMessageBox::No)->click();
      auto* dialog = qobject_cast<QFileDialog*>(modal);
      if (!dialog) return;
      if (names_given++ > 0) return dialog->reject();
      dialog->setDirectory(QFileInfo(path).absolutePath());
      dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(QStringLiteral("site"));
      QMetaObject::invokeMethod(dialog, "accept");
    });
    driver.start(50);
    QVERIFY(!office.window.files().askSaveAs());
    QVERIFY(names_given >= 2);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("somebody's work"));
  }
};

QTEST_MAIN(DialogsTest)
#include "dialogs_test.moc"

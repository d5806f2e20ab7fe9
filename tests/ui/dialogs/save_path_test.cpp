// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/save_path.h"

#include <QApplication>
#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace cad2slam;

class SavePathTest : public QObject {
  Q_OBJECT

 private:
  int questions_ = 0;

  void answer(QMessageBox::StandardButton button) {
    QTimer::singleShot(0, qApp, [this, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box) return;
      ++questions_;
      box->button(button)->click();
    });
  }

 private slots:
  void whatIsThereIsReplacedOnlyWhenThatIsAllowed() {
    const QTemporaryDir folder;
    const QString there = folder.filePath(QStringLiteral("there.yaml"));
    const QString missing = folder.filePath(QStringLiteral("missing.png"));
    QFile file(there);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(mayReplace(nullptr, QStringLiteral("Write"), {missing}));
    QCOMPARE(questions_, 0);
    answer(QMessageBox::No);
    QVERIFY(!mayReplace(nullptr, QStringLiteral("Write"), {missing, there}));
    answer(QMessageBox::Yes);
    QVERIFY(mayReplace(nullptr, QStringLiteral("Write"), {missing, there}));
    QCOMPARE(questions_, 2);
  }
};

QTEST_MAIN(SavePathTest)
#include "save_path_test.moc"

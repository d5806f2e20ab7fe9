// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export_dialog.h"

#include <QCheckBox>
#include <QPushButton>
#include <QTest>

using namespace cad2slam;
using Verdict = ExportCheck::Verdict;

class ExportDialogTest : public QObject {
  Q_OBJECT

 private slots:
  void enterExportsOnlyWhereNothingSpeaksAgainstIt_data() {
    QTest::addColumn<Verdict>("verdict");
    QTest::addColumn<bool>("exported");
    QTest::newRow("good") << Verdict::kGood << true;
    QTest::newRow("note") << Verdict::kNote << true;
    QTest::newRow("warning") << Verdict::kWarning << false;
    QTest::newRow("refused") << Verdict::kRefused << false;
  }
  void enterExportsOnlyWhereNothingSpeaksAgainstIt() {
    QFETCH(Verdict, verdict);
    QFETCH(bool, exported);
    ExportDialog dialog(nullptr, {{Verdict::kGood, QStringLiteral("fine")}, {verdict, QStringLiteral("and this")}});
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    QWidget* focused = dialog.focusWidget();
    QTest::keyClick(focused ? focused : &dialog, Qt::Key_Return);
    QVERIFY(dialog.isHidden());
    QCOMPARE(dialog.result(), int(exported ? QDialog::Accepted : QDialog::Rejected));
  }

  void aMapIsWrittenOnlyWhereItWasAskedFor() {
    ExportDialog refused(nullptr, {{Verdict::kRefused, QStringLiteral("nothing")}});
    QVERIFY(!refused.isMapWanted());
    ExportDialog dialog(nullptr, {{Verdict::kGood, QStringLiteral("fine")}});
    QVERIFY(!dialog.isMapWanted());
    dialog.findChild<QCheckBox*>(QStringLiteral("mapWanted"))->click();
    QVERIFY(dialog.isMapWanted());
  }

  void aWarningCanBeOverruled() {
    ExportDialog dialog(nullptr, {{Verdict::kWarning, QStringLiteral("wrong")}});
    dialog.show();
    for (QPushButton* button : dialog.findChildren<QPushButton*>())
      if (button->text().contains(QStringLiteral("anyway"))) button->click();
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
  }
};

QTEST_MAIN(ExportDialogTest)
#include "export_dialog_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/settings_dialog.h"

#include "ui/models/limits_text.h"
#include "ui/support/office_window.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTimer>

using namespace cad2slam;
using test::OfficeWindow;

namespace {

QPushButton* okOf(const QDialog& dialog) {
  return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
}

QLineEdit* field(const QDialog& dialog, const char* name) {
  return dialog.findChild<QLineEdit*>(QLatin1String(name));
}

/// As somebody does who goes down the list with the keyboard.
void chooseRigid(const QDialog& dialog) {
  auto* model = dialog.findChild<QComboBox*>(QStringLiteral("model"));
  model->setFocus();
  QTest::keyClick(model, Qt::Key_Down);
}

}  // namespace

class SettingsDialogTest : public QObject {
  Q_OBJECT

 private slots:
  void theRigidModelCanBeChosen() {
    SettingsDialog dialog(nullptr, {defaultSettings(Model::kStretch), {}, {}}, {});
    dialog.show();
    QVERIFY(okOf(dialog)->isEnabled());
    chooseRigid(dialog);
    QVERIFY(okOf(dialog)->isEnabled());
    QCOMPARE(dialog.settings().solver, defaultSettings(Model::kRigid));
    auto* model = dialog.findChild<QComboBox*>(QStringLiteral("model"));
    QTest::keyClick(model, Qt::Key_Up);
    QVERIFY(okOf(dialog)->isEnabled());
    QCOMPARE(dialog.settings().solver, defaultSettings(Model::kStretch));
  }

  void theDefaultsOfTheModelStandWithTheModel() {
    SolverSettings solver = defaultSettings(Model::kStretch);
    solver.anchor_information *= 3.0;
    ClassLimits limits;
    limits.ok_m = 0.7;
    SettingsDialog dialog(nullptr, {solver, {}, limits}, {});
    dialog.show();
    auto* defaults = dialog.findChild<QPushButton*>(QStringLiteral("defaults"));
    auto* tabs = dialog.findChild<QTabWidget*>();
    QVERIFY(defaults && tabs);
    for (int page = 0; page < tabs->count(); ++page) {
      tabs->setCurrentIndex(page);
      QCOMPARE(defaults->isVisible(), page == 0);
    }
    tabs->setCurrentIndex(0);
    defaults->click();
    QCOMPARE(dialog.settings().solver, defaultSettings(Model::kStretch));
    QCOMPARE(dialog.settings().limits.ok_m, 0.7);
  }

  void theLimitsAreToldWithTheRuleForBadOnes() {
    const SettingsDialog dialog(nullptr, {defaultSettings(Model::kStretch), {}, {}}, {});
    QCOMPARE(dialog.findChild<QLabel*>(QStringLiteral("badRule"))->text(), badRuleText());
  }

  void aRigidProjectCanBeChanged() {
    SettingsDialog dialog(nullptr, {defaultSettings(Model::kRigid), {}, {}}, {});
    QVERIFY(okOf(dialog)->isEnabled());
    field(dialog, "okMetres")->setText(QStringLiteral("0.5"));
    QVERIFY(okOf(dialog)->isEnabled());
    QCOMPARE(dialog.settings().limits.ok_m, 0.5);
    QCOMPARE(dialog.settings().solver, defaultSettings(Model::kRigid));
  }

  void aFieldThatTakesPartNeedsANumberAboveZero() {
    SettingsDialog dialog(nullptr, {defaultSettings(Model::kStretch), {}, {}}, {});
    for (const char* text : {"0", "-1", "", "three"}) {
      field(dialog, "prior")->setText(QLatin1String(text));
      QVERIFY2(!okOf(dialog)->isEnabled(), text);
    }
    field(dialog, "prior")->setText(QStringLiteral("2"));
    QVERIFY(okOf(dialog)->isEnabled());
    // The scale is to be found: what stands in the field of the known one does not matter.
    field(dialog, "fixedScale")->setText(QStringLiteral("none"));
    QCOMPARE(okOf(dialog)->isEnabled(), !field(dialog, "fixedScale")->isEnabled());
  }

  void whatCouldNotBeSavedCannotBeChosen() {
    SolverSettings solver = defaultSettings(Model::kStretch);
    solver.scale.rule = ScaleRule::kFixed;
    for (const char* name : {"fixedScale", "cellSize", "anchorInformation", "prior"}) {
      SettingsDialog dialog(nullptr, {solver, {}, {}}, {});
      field(dialog, name)->setText(QStringLiteral("2e15"));
      QVERIFY2(!okOf(dialog)->isEnabled(), name);
      field(dialog, name)->setText(QStringLiteral("1000000"));
      QVERIFY2(okOf(dialog)->isEnabled(), name);
    }
    SettingsDialog dialog(nullptr, {solver, {}, {}}, {});
    for (const char* name : {"fixedScale", "cellSize"}) {
      for (const char* text : {"1000001", "0.0000001"}) {
        field(dialog, name)->setText(QLatin1String(text));
        QVERIFY2(!okOf(dialog)->isEnabled(), name);
      }
      field(dialog, name)->setText(QStringLiteral("2"));
    }
    QVERIFY(okOf(dialog)->isEnabled());
  }

  void theRigidModelIsSolvedAndKept() {
    const test::Sandbox sandbox;
    const QString path = sandbox.path(QStringLiteral("rigid.c2sproj"));
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    QTimer::singleShot(0, qApp, [] {
      auto* dialog = qobject_cast<SettingsDialog*>(QApplication::activeModalWidget());
      QVERIFY(dialog);
      chooseRigid(*dialog);
      okOf(*dialog)->click();
      if (dialog->isVisible()) dialog->reject();
    });
    office.window.actionTable()[ActionId::kSettings]->trigger();
    QCOMPARE(office.document().project().settings, defaultSettings(Model::kRigid));
    QVERIFY(office.waitUntilSolved());
    QCOMPARE(office.session().alignment().result()->settings.model, Model::kRigid);
    QVERIFY(office.session().summary().rms_residual_m.value() < 1.0);
    QVERIFY(office.window.files().saveProjectTo(path));
    OfficeWindow again(false);
    QVERIFY(again.openSolved(path));
    QCOMPARE(again.document().project().settings, defaultSettings(Model::kRigid));
    QCOMPARE(again.session().alignment().result()->settings.model, Model::kRigid);
  }
};

QTEST_MAIN(SettingsDialogTest)
#include "settings_dialog_test.moc"

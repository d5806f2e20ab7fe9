// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/anchor_panel.h"

#include "ui/document/project_commands.h"
#include "ui/models/limits_text.h"
#include "ui/support/office_window.h"

#include <QLabel>

using namespace cad2slam;
using test::OfficeWindow;

class AnchorPanelTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

 private slots:
  void init() { sandbox_.emplace(); }

  void whatAnchorsAreJudgedByIsToldAtTheTableAndBelowIt() {
    OfficeWindow office;
    office.addExact(5);
    QVERIFY(office.waitUntilSolved());
    AnchorPanel& panel = office.window.anchorPanel();
    const auto* median = panel.findChild<QLabel*>(QStringLiteral("footerLeaveOneOut"));
    QVERIFY(median);
    for (const double ok_m : {0.15, 0.07}) {
      ProjectSettings settings{office.document().project().settings, office.document().project().cell_size_m, {}};
      settings.limits.ok_m = ok_m;
      edit::changeSettings(office.document(), settings);
      const QString rule = limitsText(settings.limits) + QLatin1Char('\n') + badRuleText();
      const QAbstractItemModel& model = panel.model();
      QVERIFY(model.headerData(AnchorTableModel::kFlag, Qt::Horizontal, Qt::ToolTipRole).toString().contains(rule));
      QCOMPARE(model.index(0, AnchorTableModel::kFlag).data(Qt::ToolTipRole).toString(), rule);
      QVERIFY(median->toolTip().contains(rule));
    }
  }

  void theFooterCountsWhatIsSwitchedOnAndIsGreyUntilItIsSolved() {
    OfficeWindow office;
    office.addExact(8);
    QVERIFY(office.waitUntilSolved());
    const auto* count = office.window.anchorPanel().findChild<QLabel*>(QStringLiteral("footerCount"));
    QVERIFY(count);
    QCOMPARE(count->text(), QStringLiteral("Used 8 of 8"));
    QVERIFY(count->isEnabled());
    edit::setEnabled(office.document(), {3}, false);
    office.window.actionTable()[ActionId::kCancelSolve]->trigger();
    QVERIFY(office.session().alignment().status() == AlignmentStatus::kCancelled);
    QCOMPARE(count->text(), QStringLiteral("Used 7 of 8"));
    QVERIFY(!count->isEnabled());
    office.window.actionTable()[ActionId::kSolveAgain]->trigger();
    QVERIFY(office.waitUntilSolved());
    QCOMPARE(count->text(), QStringLiteral("Used 7 of 8"));
    QTRY_VERIFY(count->isEnabled());
  }
};

QTEST_MAIN(AnchorPanelTest)
#include "anchor_panel_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/anchor_panel.h"

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

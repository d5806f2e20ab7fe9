// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/alignment.h"

#include "ui/support/office_window.h"

using namespace cad2slam;
using test::OfficeWindow;

class AlignmentTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

 private slots:
  void init() { sandbox_.emplace(); }

  void whatIsSolvedAgainStaysCurrentWhenThatIsStopped() {
    OfficeWindow office;
    office.addExact(8);
    QVERIFY(office.waitUntilSolved());
    Alignment& alignment = office.session().alignment();
    alignment.solveNow();
    QVERIFY(alignment.status() == AlignmentStatus::kSolving);
    alignment.cancel();
    QVERIFY(alignment.status() == AlignmentStatus::kUpToDate);
    QVERIFY(alignment.isCurrent());
    // What was edited is not answered by the result before.
    edit::deleteAnchors(office.document(), {1});
    alignment.cancel();
    QVERIFY(alignment.status() == AlignmentStatus::kCancelled);
    QVERIFY(!alignment.isCurrent());
    alignment.solveNow();
    QVERIFY(office.waitUntilSolved());
    QVERIFY(alignment.isCurrent());
  }
};

QTEST_MAIN(AlignmentTest)
#include "alignment_test.moc"

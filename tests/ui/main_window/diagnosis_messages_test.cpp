// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/diagnosis_messages.h"

#include "ui/document/project_commands.h"
#include "ui/support/office_window.h"

using namespace cad2slam;
using test::OfficeWindow;

class DiagnosisMessagesTest : public QObject {
  Q_OBJECT

 private slots:
  void otherLimitsGiveOtherFindings() {
    const test::Sandbox sandbox;
    OfficeWindow office;
    office.addExact(8);
    const Anchor third = *office.document().anchor(3);
    edit::setCoordinates(office.document(), 3, third.in_blueprint, third.in_slam + Eigen::Vector2d(6.0, 5.0));
    QVERIFY(office.waitForFinding(Finding::Kind::kOutlier));
    const Project& project = office.document().project();
    ProjectSettings settings{project.settings, project.cell_size_m, office.document().state().limits};
    settings.limits.ok_m = 200.0;
    settings.limits.look_m = 300.0;
    edit::changeSettings(office.document(), settings);
    QTRY_VERIFY_WITH_TIMEOUT(!office.finding(Finding::Kind::kOutlier), test::kPatience);
    office.document().undoStack().undo();
    QVERIFY(office.waitForFinding(Finding::Kind::kOutlier));
  }
};

QTEST_MAIN(DiagnosisMessagesTest)
#include "diagnosis_messages_test.moc"

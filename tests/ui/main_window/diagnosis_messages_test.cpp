// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/diagnosis_messages.h"

#include "ui/document/project_commands.h"
#include "ui/support/office_window.h"

#include <algorithm>

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

  /// The blueprint is not to blame then, be it seen by two anchors or by many.
  void whereAnotherMapAgreesAWrongScaleIsNoError() {
    const test::Sandbox sandbox;
    OfficeWindow office;
    office.addExact(8);
    QVERIFY(office.waitUntilSolved());
    constexpr double kStretched = 1.3;
    ProjectRaster raster = office.document().currentMap()->raster;
    raster.metadata.resolution_m_per_px *= kStretched;
    edit::addSlamMap(office.document(), "stretched", raster);
    QVERIFY(office.waitUntilReady());
    const auto severityOf = [&](Finding::Kind kind) -> std::optional<Severity> {
      const QString id = QStringLiteral("diagnosis-%1").arg(static_cast<int>(kind));
      for (const Message& message : office.window.messages().messages())
        if (message.id == id || message.id.startsWith(id + QLatin1Char('-'))) return message.severity;
      return std::nullopt;
    };
    const auto farthest = std::max_element(office.pairs.begin(), office.pairs.end(), [&](const auto& a, const auto& b) {
      const Eigen::Vector2d& first = office.pairs.front().in_blueprint;
      return (a.in_blueprint - first).norm() < (b.in_blueprint - first).norm();
    });
    for (const Anchor& pair : {office.pairs.front(), *farthest})
      edit::addAnchor(office.document(), pair.in_blueprint, kStretched * pair.in_slam);
    QVERIFY(office.waitForFinding(Finding::Kind::kLengths));
    QVERIFY(!office.finding(Finding::Kind::kLengths)->agrees.empty());
    QVERIFY(severityOf(Finding::Kind::kLengths) == Severity::kWarning);
    for (std::size_t i = 1; i < 8; ++i)
      edit::addAnchor(office.document(), office.pairs[i].in_blueprint, kStretched * office.pairs[i].in_slam);
    QVERIFY(office.waitForFinding(Finding::Kind::kScale));
    QVERIFY(!office.finding(Finding::Kind::kScale)->agrees.empty());
    QVERIFY(severityOf(Finding::Kind::kScale) == Severity::kWarning);
  }
};

QTEST_MAIN(DiagnosisMessagesTest)
#include "diagnosis_messages_test.moc"

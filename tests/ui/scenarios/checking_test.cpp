// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/project_commands.h"
#include "ui/document/room_map.h"
#include "ui/main_window/exports.h"
#include "ui/panels/anchor_panel.h"
#include "ui/panels/preview_panel.h"
#include "ui/support/documents.h"
#include "ui/support/office_window.h"
#include "ui/tools/test_poses.h"

#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QTableView>
#include <QToolButton>

#include <Eigen/Geometry>

#include <algorithm>

using namespace cad2slam;
using test::OfficeWindow;
using Kind = Finding::Kind;

class CheckingTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

  static double rms(OfficeWindow& office) { return office.session().summary().rms_residual_m.value_or(1e9); }

  /// Where an anchor of the sample would be in a SLAM map that is turned by 168 degrees and not bent.
  static Eigen::Vector2d turned(OfficeWindow& office, std::size_t at) {
    const Eigen::Vector2d middle(14.0, 9.0);
    const Eigen::Vector2d there =
        office.session()
            .rasters()
            .frame(Side::kSlam)
            ->metricFromPixel({0.5 * office.session().rasters().frame(Side::kSlam)->width(),
                               0.5 * office.session().rasters().frame(Side::kSlam)->height()});
    return there + Eigen::Rotation2Dd(168.0 * kPi / 180.0) * (office.pairs[at].in_blueprint - middle);
  }

  /// As if the mouse were there; windows that other tests leave behind cannot take the event.
  static void hover(MapView& view) {
    const QPointF at(150.0, 150.0);
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &move);
  }

 private slots:
  void init() { sandbox_.emplace(); }

  void scenario10_swappedCounterpartsAreOfferedForRepair() {
    OfficeWindow office;
    office.addExact(10);
    QVERIFY(office.waitUntilSolved());
    const double good = rms(office);
    edit::swapCounterparts(office.document(), 4, 7);
    QVERIFY(office.waitForFinding(Kind::kSwapped));
    std::vector<AnchorId> named = office.finding(Kind::kSwapped)->anchors;
    std::sort(named.begin(), named.end());
    QCOMPARE(named, (std::vector<AnchorId>{4, 7}));
    for (const AnchorId id : {AnchorId(4), AnchorId(7)})
      QCOMPARE(office.session().judgements().at(id).judged, AnchorClass::kBad);
    QVERIFY(office.pressCure(QStringLiteral("diagnosis-"), QStringLiteral("Swap")));
    QVERIFY(office.waitUntilSolved());
    QVERIFY(rms(office) < 1.01 * good + 1e-6);
    QTRY_VERIFY_WITH_TIMEOUT(!office.finding(Kind::kSwapped), test::kPatience);
  }

  void scenario10_anAnchorTwoMetresOffTopsTheList() {
    OfficeWindow office;
    office.addExact(12);
    edit::moveAnchor(office.document(), 5, Side::kSlam, office.pairs[4].in_slam + Eigen::Vector2d(2.0, 0.0),
                     office.document().newGesture());
    QVERIFY(office.waitUntilSolved());
    const auto worst = std::max_element(
        office.session().judgements().begin(), office.session().judgements().end(), [](const auto& a, const auto& b) {
          return a.second.leave_one_out_m.value_or(0.0) < b.second.leave_one_out_m.value_or(0.0);
        });
    QCOMPARE(worst->first, AnchorId(5));
    QCOMPARE(office.window.anchorPanel().nextByError(std::nullopt, true), std::optional<AnchorId>(5));
    office.window.actionTable()[ActionId::kDisableWorst]->trigger();
    QVERIFY(!office.document().anchor(5)->enabled);
  }

  void scenario10_cornersHalfATurnWrongAreNotReadyToExport() {
    OfficeWindow office;
    // The outer corners of the plan, each with the one of the SLAM map that looks the same and is the opposite one.
    const AnchorList& known = office.pairs;
    const auto along = [](const Anchor& anchor, const Eigen::Vector2d& way) { return anchor.in_blueprint.dot(way); };
    for (const Eigen::Vector2d& way : {Eigen::Vector2d(1, 2), Eigen::Vector2d(1, -2)}) {
      const auto [first, last] = std::minmax_element(
          known.begin(), known.end(), [&](const Anchor& a, const Anchor& b) { return along(a, way) < along(b, way); });
      edit::addAnchor(office.document(), first->in_blueprint, last->in_slam);
      edit::addAnchor(office.document(), last->in_blueprint, first->in_slam);
    }
    QVERIFY(office.waitUntilSolved());
    QVERIFY(rms(office) < 0.1);  // it looks perfect
    QVERIFY(office.waitForFinding(Kind::kUnpredicted));
    const QStringList sentences = office.window.diagnosis().sentences(Severity::kWarning);
    QVERIFY(!sentences.filter(QStringLiteral("do not predict each other")).isEmpty());
    for (const QStringList& findings : {QStringList(), sentences}) {
      const std::vector<ExportCheck> checks = exportChecks(office.session(), findings);
      QVERIFY(checks.front().verdict == ExportCheck::Verdict::kWarning);
      QVERIFY(checks.front().sentence.startsWith(QStringLiteral("Without itself, an anchor is typically ")));
    }
    edit::deleteAnchors(office.document(), {1, 2, 3, 4});
    office.addExact(30);
    QVERIFY(office.waitUntilSolved());
    QVERIFY(exportChecks(office.session()).front().verdict == ExportCheck::Verdict::kGood);
    QTRY_VERIFY_WITH_TIMEOUT(!office.finding(Kind::kUnpredicted), test::kPatience);
  }

  void scenario11_duplicatesAreNamedWithACure() {
    OfficeWindow office;
    office.addExact(6);
    edit::addAnchor(office.document(), office.pairs[2].in_blueprint,
                    office.pairs[2].in_slam + Eigen::Vector2d(1.8, 0.0));
    QVERIFY(office.waitForFinding(Kind::kDuplicate));
    QCOMPARE(office.finding(Kind::kDuplicate)->anchors, (std::vector<AnchorId>{3, 7}));
    QVERIFY(office.pressCure(QStringLiteral("diagnosis-"), QStringLiteral("Disable 7")));
    QVERIFY(office.waitUntilSolved());
    QTRY_VERIFY_WITH_TIMEOUT(!office.finding(Kind::kDuplicate), test::kPatience);
  }

  void anchorsWhereAMapShowsNothingAreNoted() {
    OfficeWindow office;
    office.addExact(6);
    const auto putInto = [&](const Eigen::Vector2d& slam_pixel) {
      edit::moveAnchor(office.document(), 2, Side::kSlam,
                       office.session().rasters().frame(Side::kSlam)->metricFromPixel(slam_pixel),
                       office.document().newGesture());
    };
    putInto({6.0, 6.0});
    QVERIFY(office.waitForFinding(Kind::kUnknownGround));
    QCOMPARE(office.finding(Kind::kUnknownGround)->anchors, std::vector<AnchorId>{2});  // and none of the good ones
    QVERIFY(office.finding(Kind::kUnknownGround)->side == Side::kSlam);
    putInto({-6.0, 6.0});
    QVERIFY(office.waitForFinding(Kind::kOutsideImage));
    QCOMPARE(office.finding(Kind::kOutsideImage)->anchors, std::vector<AnchorId>{2});
    QVERIFY(!office.finding(Kind::kUnknownGround));
    QVERIFY(office.pressCure(QStringLiteral("diagnosis-"), QStringLiteral("Disable")));
    QVERIFY(!office.document().anchor(2)->enabled);
    QTRY_VERIFY_WITH_TIMEOUT(!office.finding(Kind::kOutsideImage), test::kPatience);
  }

  void scenario11_collinearAnchorsAndOneRoom() {
    OfficeWindow office;
    const Eigen::Vector2d b = office.pairs[0].in_blueprint;
    const Eigen::Vector2d s = office.pairs[0].in_slam;
    for (int i = 0; i < 3; ++i)
      edit::addAnchor(office.document(), b + Eigen::Vector2d(0.8 * i, 0.0), s + Eigen::Vector2d(0.8 * i, 0.0));
    QVERIFY(office.waitForFinding(Kind::kCollinear));
    QVERIFY(office.window.isVisible());
    // Beside the line, yet all in the largest room.
    const RoomMap rooms = RoomMap::find(*office.session().rasters().grid(Side::kBlueprint));
    const Eigen::Vector2d center =
        std::max_element(rooms.rooms().begin(), rooms.rooms().end(), [](const auto& a_room, const auto& b_room) {
          return a_room.area_m2 < b_room.area_m2;
        })->center;
    edit::deleteAnchors(office.document(), {1, 2, 3});
    const double half_turn = kPi;  // about how this SLAM map lies
    for (const Eigen::Vector2d& aside : {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.6, 0), Eigen::Vector2d(0, 0.6)})
      edit::addAnchor(office.document(), center + aside, s + Eigen::Rotation2Dd(half_turn) * aside);
    QVERIFY(office.waitForFinding(Kind::kOneRoom));
    QVERIFY(!office.finding(Kind::kCollinear));
    QVERIFY(office.pressCure(QStringLiteral("diagnosis-"), QStringLiteral("Show")));  // a room without anchors
    QVERIFY(office.window.isVisible());
  }

  void scenario12_aWrongScaleIsSaidAndCured_data() {
    QTest::addColumn<double>("factor");
    QTest::newRow("twice as large") << 2.0;
    QTest::newRow("half as large") << 0.5;
    QTest::newRow("5 % off") << 1.05;
  }
  void scenario12_aWrongScaleIsSaidAndCured() {
    QFETCH(double, factor);
    OfficeWindow office;
    office.addExact(12);
    edit::rescaleBlueprint(office.document(), factor);
    QVERIFY(office.waitForFinding(Kind::kScale));
    QVERIFY2(std::abs(office.finding(Kind::kScale)->value * factor - 1.0) < 0.04,
             qPrintable(QString::number(office.finding(Kind::kScale)->value)));
    QVERIFY(office.pressCure(QStringLiteral("diagnosis-"), QStringLiteral("Rescale")));
    QVERIFY(office.waitUntilSolved());
    QTRY_VERIFY_WITH_TIMEOUT(!office.finding(Kind::kScale), test::kPatience);
    QVERIFY(std::abs(office.document().project().blueprint.metadata.resolution_m_per_px / 0.025 - 1.0) < 0.04);
  }

  void scenario12_threePercentAreSaidOfAMapThatIsNotBent() {
    OfficeWindow office;
    for (std::size_t i = 0; i < 8; ++i)
      edit::addAnchor(office.document(), office.pairs[i].in_blueprint, turned(office, i));
    edit::rescaleBlueprint(office.document(), 1.03);
    QVERIFY(office.waitForFinding(Kind::kScale));
    QVERIFY(std::abs(office.finding(Kind::kScale)->value * 1.03 - 1.0) < 1e-3);
    QVERIFY(office.hasMessage(QStringLiteral("diagnosis-")));
    QVERIFY(office.pressCure(QStringLiteral("diagnosis-"), QStringLiteral("Rescale")));
    QVERIFY(office.waitUntilSolved());
    QTRY_VERIFY_WITH_TIMEOUT(!office.finding(Kind::kScale), test::kPatience);
  }

  void scenario12_theBlueprintIsNotBlamedForOneSlamMap() {
    OfficeWindow office(false);
    QVERIFY(office.openSolved(OfficeWindow::sample("office.c2sproj")));
    office.document().setCurrentMap("Robot 2");
    QVERIFY(office.waitUntilReady());
    QVERIFY(office.waitForFinding(Kind::kScale));
    QCOMPARE(office.finding(Kind::kScale)->agrees, std::string("Robot 1"));
    QVERIFY(!office.pressCure(QStringLiteral("diagnosis-"), QStringLiteral("Rescale")));
    QVERIFY(!office.window.diagnosis().sentences(Severity::kWarning).filter(QStringLiteral("Robot 1")).isEmpty());
  }

  void scenario12_aSlamMapThatIsTurnedIsNoMistake() {
    OfficeWindow office;
    for (std::size_t i = 0; i < 10; ++i)
      edit::addAnchor(office.document(), office.pairs[i].in_blueprint, turned(office, i));
    QVERIFY(office.waitUntilSolved());
    QTRY_VERIFY_WITH_TIMEOUT(office.finding(Kind::kSimilarityEnough), test::kPatience);
    for (const Kind wrong : {Kind::kMirrored, Kind::kSwapped, Kind::kScale, Kind::kOutlier})
      QVERIFY(!office.finding(wrong));
    QVERIFY(rms(office) < 0.01);
  }

  void scenario12_aMirroredBlueprintIsSaidAndCured() {
    OfficeWindow office;
    edit::flipBlueprint(office.document(), *office.session().rasters().frame(Side::kBlueprint));
    QVERIFY(office.waitUntilReady());
    // The installer clicks what they see: the same corners, now where the mirrored picture shows them.
    const MapFrame frame = *office.session().rasters().frame(Side::kBlueprint);
    for (std::size_t i = 0; i < 8; ++i) {
      Eigen::Vector2d pixel = frame.pixelFromMetric(office.pairs[i].in_blueprint);
      pixel.x() = frame.width() - pixel.x();
      edit::addAnchor(office.document(), frame.metricFromPixel(pixel), office.pairs[i].in_slam);
    }
    QVERIFY(office.waitForFinding(Kind::kMirrored));
    QVERIFY(office.pressCure(QStringLiteral("diagnosis-"), QStringLiteral("Mirror")));
    QVERIFY(office.waitUntilReady());
    QVERIFY(office.waitUntilSolved());
    QTRY_VERIFY_WITH_TIMEOUT(!office.finding(Kind::kMirrored), test::kPatience);
    QVERIFY(!office.document().project().blueprint.metadata.mirrored);
    QVERIFY((office.document().anchor(1)->in_blueprint - office.pairs[0].in_blueprint).norm() < 1e-9);
    QVERIFY(rms(office) < 1.0);
  }

  void scenario12_twoAnchorsCompareLengths() {
    OfficeWindow office;
    office.addExact(2);
    QVERIFY(office.waitUntilSolved());
    edit::rescaleBlueprint(office.document(), 1.3);
    QVERIFY(office.waitForFinding(Kind::kLengths));
    QVERIFY(office.pressCure(QStringLiteral("diagnosis-"), QStringLiteral("Rescale")));
    // The two lengths stay in view, now as a note without a cure.
    QTRY_VERIFY_WITH_TIMEOUT(office.finding(Kind::kLengths) && std::abs(office.finding(Kind::kLengths)->value -
                                                                        office.finding(Kind::kLengths)->other) < 1e-6,
                             test::kPatience);
    QVERIFY(!office.pressCure(QStringLiteral("diagnosis-"), QStringLiteral("Rescale")));
  }

  void scenario13_aDisabledAnchorIsACheckAndComesBackTheSame() {
    OfficeWindow office;
    office.addExact(8);
    QVERIFY(office.waitUntilSolved());
    const double before = office.session().judgements().at(3).residual_m.value();
    office.session().selection().set({3});
    office.window.actionTable()[ActionId::kToggleEnabled]->trigger();
    QVERIFY(office.waitUntilSolved());
    QCOMPARE(office.session().judgements().at(3).judged, AnchorClass::kDisabled);
    QVERIFY(office.session().judgements().at(3).residual_m.value() > before);
    QCOMPARE(office.session().summary().used, std::size_t(7));
    office.window.actionTable()[ActionId::kToggleEnabled]->trigger();
    QVERIFY(office.waitUntilSolved());
    QVERIFY(std::abs(office.session().judgements().at(3).residual_m.value() - before) < 1e-6);
  }

  void scenario14_tableAndViewsGoTogether() {
    OfficeWindow office;
    office.addExact(20);
    QVERIFY(office.waitUntilSolved());
    QTableView& table = *office.window.anchorPanel().table();
    // A click on a marker selects its row and scrolls to it.
    office.window.view(Side::kSlam).centerOn(toQPointF(office.pairs[17].in_slam), false);
    office.window.view(Side::kSlam).zoomBy(4.0);
    office.click(Side::kSlam, toQPointF(office.pairs[17].in_slam));
    QCOMPARE(office.session().selection().ids(), std::vector<AnchorId>{18});
    QCOMPARE(table.selectionModel()->selectedRows().size(), 1);
    const QModelIndex row = table.selectionModel()->selectedRows().front();
    QVERIFY(table.viewport()->rect().intersects(table.visualRect(row)));
    // A double click on a row shows the anchor in both views.
    table.sortByColumn(AnchorTableModel::kLeaveOneOut, Qt::DescendingOrder);
    const QModelIndex first = table.model()->index(0, AnchorTableModel::kNumber);
    const AnchorId worst = first.data().toLongLong();
    QCOMPARE(office.window.anchorPanel().nextByError(std::nullopt, true), std::optional(worst));
    table.scrollTo(first);
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(first).center());
    QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(first).center());
    for (const Side side : {Side::kBlueprint, Side::kSlam}) {
      const QPointF wanted = toQPointF(half(*office.document().anchor(worst), side));
      QTRY_VERIFY_WITH_TIMEOUT(
          QLineF(office.window.view(side).viewState().center_m, wanted).length() < office.clickError(side),
          test::kPatience);
    }
  }

  void scenario14_coordinatesByKeyboardAndBadTextStays() {
    OfficeWindow office;
    office.addExact(3);
    QTableView& table = *office.window.anchorPanel().table();
    table.setFocus();
    const QModelIndex cell = table.model()->index(0, AnchorTableModel::kSlamX);
    table.setCurrentIndex(cell);
    const int steps = office.document().undoStack().count();
    table.edit(cell);
    auto* editor = table.viewport()->findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("abc"));
    QTest::keyClick(editor, Qt::Key_Return);
    QCoreApplication::processEvents();                             // Return is taken in the next round of events
    QVERIFY(table.viewport()->findChild<QLineEdit*>() == editor);  // still open, nothing written
    QCOMPARE(office.document().undoStack().count(), steps);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("-7,5"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(office.document().undoStack().count(), steps + 1);
    QCOMPARE(
        office.document().anchor(table.model()->index(0, AnchorTableModel::kNumber).data().toLongLong())->in_slam.x(),
        -7.5);
  }

  void scenario14_aChosenRowIsInTheMiddleOfBothViews() {
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    QTableView& table = *office.window.anchorPanel().table();
    for (const Side side : {Side::kBlueprint, Side::kSlam}) office.window.view(side).zoomBy(6.0);
    const QModelIndex cell = table.model()->index(3, AnchorTableModel::kName);
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(cell).center());
    QCOMPARE(office.session().selection().ids(), (std::vector<AnchorId>{4}));
    for (const Side side : {Side::kBlueprint, Side::kSlam}) {
      const QPointF wanted = toQPointF(half(*office.document().anchor(4), side));
      QTRY_VERIFY_WITH_TIMEOUT(
          QLineF(office.window.view(side).viewState().center_m, wanted).length() < office.clickError(side),
          test::kPatience);
    }
  }

  void scenario14_aSolveLeavesWhatIsBeingTypedAlone() {
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    QTableView& table = *office.window.anchorPanel().table();
    for (const int column : {int(AnchorTableModel::kSlamY), int(AnchorTableModel::kNote)}) {
      const QModelIndex cell = table.model()->index(0, column);
      table.setFocus();
      table.setCurrentIndex(cell);
      table.edit(cell);
      auto* editor = table.viewport()->findChild<QLineEdit*>();
      QVERIFY(editor);
      editor->selectAll();
      QTest::keyClicks(editor, QStringLiteral("4.25"));
      edit::moveAnchor(office.document(), 5, Side::kSlam,
                       office.document().anchor(5)->in_slam + Eigen::Vector2d(0.01, 0.0),
                       office.document().newGesture());
      QVERIFY(office.waitUntilSolved());
      QCOMPARE(editor->text(), QStringLiteral("4.25"));
      QTest::keyClick(editor, Qt::Key_Return);
      QTRY_VERIFY(!table.viewport()->findChild<QLineEdit*>());
    }
    QCOMPARE(office.document().anchor(1)->in_slam.y(), 4.25);
    QCOMPARE(office.document().anchor(1)->note, std::string("4.25"));
  }

  void theUndoOfAToastUndoesItsOwnStepOnly() {
    OfficeWindow office;
    office.addExact(6);
    office.session().selection().set({2});
    office.window.actionTable()[ActionId::kDelete]->trigger();
    edit::rename(office.document(), 3, "pillar");
    QVERIFY(office.pressCure(QStringLiteral("toast"), QStringLiteral("Undo")));
    QCOMPARE(office.document().anchor(3)->name, std::string("pillar"));
    QVERIFY(!office.hasMessage(QStringLiteral("toast")));
    office.session().selection().set({4});
    office.window.actionTable()[ActionId::kDelete]->trigger();
    QVERIFY(!office.document().anchor(4));
    QVERIFY(office.pressCure(QStringLiteral("toast"), QStringLiteral("Undo")));
    QVERIFY(office.document().anchor(4));
  }

  void posesAreReadWithPointsAndCommas_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("commas") << QByteArray("x,y,heading\n12.34,5.67,1.5\n");
    QTest::newRow("semicolons") << QByteArray("12.34;5.67;1.5");
    QTest::newRow("decimal commas") << QByteArray("x;y\r\n12,34; 5,67; 1,5\r\n");
    QTest::newRow("tabs") << QByteArray("12.34\t5.67\t1.5\n");
  }
  void posesAreReadWithPointsAndCommas() {
    QFETCH(QByteArray, text);
    OfficeWindow office;
    const TestPoses::PoseImport import = office.window.testPoses().loadPoses(text, Side::kBlueprint);
    QCOMPARE(import.shown, std::size_t(1));
    QCOMPARE(import.skipped, std::size_t(text.startsWith('x') ? 1 : 0));
    QVERIFY(!import.cut);
    QVERIFY(office.window.actionTable()[ActionId::kClearPoses]->isEnabled());
    const PoseGlyph glyph = office.window.testPoses().glyphs(Side::kBlueprint).at(0);
    QCOMPARE(glyph.point_m, QPointF(12.34, 5.67));
    QCOMPARE(glyph.heading_rad, 1.5);
    office.window.actionTable()[ActionId::kClearPoses]->trigger();
    QVERIFY(office.window.testPoses().glyphs(Side::kSlam).empty());
    QVERIFY(!office.window.actionTable()[ActionId::kClearPoses]->isEnabled());
  }

  void scenario18_theRoundTripIsSeenWhileTheMouseMoves() {
    OfficeWindow office;
    office.addExact(8);
    QVERIFY(office.waitUntilSolved());
    office.window.actionTable()[ActionId::kTestPose]->setChecked(true);
    MapView& view = office.window.view(Side::kBlueprint);
    hover(view);
    const auto* hint = office.window.findChild<QLabel*>(QStringLiteral("hint"));
    QVERIFY(hint);
    QCOMPARE(hint->text(), office.window.testPoses().sentence());
    office.window.actionTable()[ActionId::kTestPose]->setChecked(false);
    QVERIFY(hint->text() != office.window.testPoses().sentence());
  }

  void zMagnifiesInTheViewUnderTheMouseWhicheverHasTheFocus() {
    OfficeWindow office;
    MapView& blueprint = office.window.view(Side::kBlueprint);
    MapView& slam = office.window.view(Side::kSlam);
    blueprint.setFocus();
    hover(slam);
    const QImage before = slam.grab().toImage();
    QTest::keyPress(&blueprint, Qt::Key_Z);
    QVERIFY(slam.grab().toImage() != before);
    QTest::keyRelease(&blueprint, Qt::Key_Z);
    QCOMPARE(slam.grab().toImage(), before);
  }

  void escInThePreviewDropsAHalfAnchor() {
    OfficeWindow office;
    office.click(Side::kBlueprint, toQPointF(office.pairs[0].in_blueprint));
    QVERIFY(office.document().pending());
    QTest::keyClick(&office.window.preview().view(), Qt::Key_Escape);
    QVERIFY(!office.document().pending());
  }

  void scenario18_testPoseThereAndBack_data() {
    QTest::addColumn<double>("heading_deg");
    QTest::newRow("0") << 0.0;
    QTest::newRow("90") << 90.0;
    QTest::newRow("-179") << -179.0;
  }
  void scenario18_testPoseThereAndBack() {
    QFETCH(double, heading_deg);
    OfficeWindow office;
    office.addExact(10);
    QVERIFY(office.waitUntilSolved());
    office.window.actionTable()[ActionId::kTestPose]->setChecked(true);
    TestPoses& poses = office.window.testPoses();
    poses.setRobot({office.pairs[4].in_blueprint, heading_deg * kPi / 180.0});
    const auto trial = poses.tried(poses.robot());
    QVERIFY(trial && trial->in_slam.ok());
    QVERIFY(trial->round_trip_m < 1e-3);
    QVERIFY(trial->round_trip_rad < 0.01 * kPi / 180.0);
    QCOMPARE(poses.glyphs(Side::kBlueprint).size(), std::size_t(1));
    QCOMPARE(poses.glyphs(Side::kSlam).size(), std::size_t(1));
    // Dragging it in the SLAM map moves it in the blueprint.
    const QPointF there = toQPointF(trial->in_slam.pose.translation);
    poses.drag(Side::kSlam, TestPoses::kRobot, there + QPointF(1.0, 0.0));
    QVERIFY(std::abs((poses.robot().translation - office.pairs[4].in_blueprint).norm() - 1.0) < 0.2);
    // Far outside the building it says so.
    poses.setRobot({{-500.0, -500.0}, 0.0});
    QVERIFY(poses.sentence().contains(QStringLiteral("Extrapolated")));
    QVERIFY(poses.glyphs(Side::kSlam).front().hollow);
  }
};

QTEST_MAIN(CheckingTest)
#include "checking_test.moc"

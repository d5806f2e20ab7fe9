// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/models/anchor_table_model.h"

#include "ui/document/anchor_commands.h"
#include "ui/models/number_text.h"
#include "ui/support/documents.h"

#include <QAbstractItemModelTester>
#include <QFont>
#include <QSignalSpy>
#include <QTest>

using namespace cad2slam;
using TableModel = AnchorTableModel;

class AnchorTableModelTest : public QObject {
  Q_OBJECT

 private:
  ProjectDocument document_;

  QString shown(const TableModel& model, int row, int column) {
    return model.data(model.index(row, column), Qt::DisplayRole).toString();
  }

 private slots:
  void init() {
    QLocale::setDefault(QLocale::c());
    document_.reset(test::smallProject(), {});
    edit::addAnchor(document_, {1.23456789, 2}, {3, 4});
    edit::addAnchor(document_, {5, 6}, {7, 8});
  }
  void cleanup() { QLocale::setDefault(QLocale::c()); }

  void staysConsistentThroughEdits() {
    TableModel model(document_);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    edit::addAnchor(document_, {9, 9}, {9, 9});
    edit::deleteAnchors(document_, {1, 3});
    document_.undoStack().undo();
    QCOMPARE(model.rowCount(), 3);
    document_.reset(Project{}, {});
    QCOMPARE(model.rowCount(), 0);
  }

  void scenario14_editsAreOneStepAndBadTextIsRefused() {
    TableModel model(document_);
    const int steps = document_.undoStack().count();
    QVERIFY(model.setData(model.index(0, TableModel::kSlamX), QStringLiteral("3,25"), Qt::EditRole));
    QCOMPARE(document_.anchor(1)->in_slam.x(), 3.25);
    QCOMPARE(document_.undoStack().count(), steps + 1);
    for (const char* bad : {"", "abc", "1.2.3", "nan", "inf", "1e300", "1,234.5", "3 4"})
      QVERIFY2(!model.setData(model.index(0, TableModel::kSlamX), QString::fromLatin1(bad), Qt::EditRole), bad);
    QCOMPARE(document_.anchor(1)->in_slam.x(), 3.25);
    QCOMPARE(document_.undoStack().count(), steps + 1);
  }

  void whatIsCutIsToldInFull() {
    TableModel model(document_);
    const auto tip = [&](int column) { return model.data(model.index(0, column), Qt::ToolTipRole).toString(); };
    edit::rename(document_, 1, "the third pillar to the left of the <b>main</b> entrance");
    edit::setNote(document_, 1, "hidden by a shelf");
    QVERIFY(tip(TableModel::kName).contains(QStringLiteral("main")));
    QVERIFY(!Qt::mightBeRichText(tip(TableModel::kName)) || !tip(TableModel::kName).contains(QStringLiteral("<b>")));
    QCOMPARE(tip(TableModel::kNote), QStringLiteral("hidden by a shelf"));
    QCOMPARE(tip(TableModel::kBlueprintX), QStringLiteral("1.235 m"));
    const QString corner = QStringLiteral("corner");
    QVERIFY(!tip(TableModel::kFlag).contains(corner));
    edit::moveAnchor(document_, 1, Side::kBlueprint, {2, 2}, document_.newGesture(), false, true);
    QVERIFY(document_.isSnapped(1));
    QVERIFY(tip(TableModel::kFlag).contains(corner));
  }

  void leavingTheTextAloneDoesNotRound() {
    TableModel model(document_);
    const QModelIndex cell = model.index(0, TableModel::kBlueprintX);
    QVERIFY(model.setData(cell, model.data(cell, Qt::EditRole), Qt::EditRole));
    QCOMPARE(document_.anchor(1)->in_blueprint.x(), 1.23456789);
  }

  void scenario27_decimalCommaWhereTheLanguageHasIt() {
    QLocale::setDefault(QLocale(QLocale::German));
    TableModel model(document_);
    QCOMPARE(shown(model, 0, TableModel::kBlueprintX), QStringLiteral("1,235"));
    QCOMPARE(parseNumber(QStringLiteral("12,5")), std::optional(12.5));
    QCOMPARE(parseNumber(QStringLiteral("12.5 m")), std::optional(12.5));
    QCOMPARE(numberText(1234567.891, 1), QStringLiteral("1234567,9"));
    QCOMPARE(numberText(-0.0001, 2), QStringLiteral("0,00"));
  }

  void pixelsAreToldOnDemand() {
    TableModel model(document_);
    const auto tip = [&model](int column) { return model.data(model.index(0, column), Qt::ToolTipRole).toString(); };
    QVERIFY(!tip(TableModel::kSlamX).contains(QStringLiteral("px")));
    model.setJudgements({{1, {.residual_m = 0.1}}}, false);
    QVERIFY(!tip(TableModel::kResidual).contains(QStringLiteral("px")));
    // 100 x 80 pixels of 5 cm, the origin in the lower left corner: y up in metres, down in pixels.
    model.setFrame(Side::kSlam, MapFrame::create(0.05, 100, 80, Pose2{}).value());
    QVERIFY2(tip(TableModel::kSlamX).contains(QStringLiteral("60.0, 0.0 px")), qPrintable(tip(TableModel::kSlamX)));
    QVERIFY(!tip(TableModel::kBlueprintX).contains(QStringLiteral("px")));
    QVERIFY(tip(TableModel::kResidual).contains(QStringLiteral("2.0 px")));
  }

  void scenario13_disabledRowsAreChecksInItalics() {
    TableModel model(document_);
    edit::setEnabled(document_, {2}, false);
    AnchorJudgement check;
    check.judged = AnchorClass::kDisabled;
    check.residual_m = 0.123;
    check.is_check = true;
    model.setJudgements({{2, check}}, false);
    QCOMPARE(shown(model, 1, TableModel::kResidual), QStringLiteral("12.3"));
    QVERIFY(model.data(model.index(1, TableModel::kResidual), Qt::FontRole).value<QFont>().italic());
    QCOMPARE(model.data(model.index(1, TableModel::kEnabled), Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
    QVERIFY(model.setData(model.index(1, TableModel::kEnabled), int(Qt::Checked), Qt::CheckStateRole));
    QVERIFY(document_.anchor(2)->enabled);
  }

  void staleNumbersAreGrey() {
    TableModel model(document_);
    AnchorJudgement judgement;
    judgement.residual_m = 0.1;
    model.setJudgements({{1, judgement}}, true);
    QVERIFY(model.data(model.index(0, TableModel::kResidual), Qt::ForegroundRole).isValid());
    model.setJudgements({{1, judgement}}, false);
    QVERIFY(!model.data(model.index(0, TableModel::kResidual), Qt::ForegroundRole).isValid());
  }

  void onlyWhatIsNewIsAnnounced() {
    TableModel model(document_);
    const QSignalSpy changes(&model, &TableModel::dataChanged);
    AnchorJudgement judgement;
    judgement.residual_m = 0.1;
    model.setJudgements({{1, judgement}}, false);
    QCOMPARE(changes.count(), 1);
    model.setJudgements({{1, judgement}}, false);
    QCOMPARE(changes.count(), 1);
    judgement.residual_m = 0.2;
    model.setJudgements({{1, judgement}}, false);
    QCOMPARE(changes.count(), 2);
    // An edit is announced for the rows of the edited anchors.
    edit::moveAnchor(document_, 2, Side::kSlam, {7, 8}, document_.newGesture());
    QCOMPARE(changes.count(), 3);
    QCOMPARE(changes.at(2).at(0).toModelIndex(), model.index(1, 0));
    QCOMPARE(changes.at(2).at(1).toModelIndex(), model.index(1, TableModel::kColumnCount - 1));
    edit::setEnabled(document_, {1, 2}, false);
    QCOMPARE(changes.count(), 4);
    QCOMPARE(changes.at(3).at(0).toModelIndex().row(), 0);
    QCOMPARE(changes.at(3).at(1).toModelIndex().row(), 1);
  }

  void everyClassHasItsShapeAndWord() {
    TableModel model(document_);
    QStringList flags;
    for (const AnchorClass judged : {AnchorClass::kOk, AnchorClass::kLook, AnchorClass::kBad}) {
      AnchorJudgement judgement;
      judgement.judged = judged;
      model.setJudgements({{1, judgement}}, false);
      flags += shown(model, 0, TableModel::kFlag);
    }
    QCOMPARE(flags, (QStringList{QStringLiteral("● OK"), QStringLiteral("◆ look"), QStringLiteral("■ bad")}));
  }

  void aLockedTableCannotBeEdited() {
    TableModel model(document_);
    document_.setLocked(true);
    QVERIFY(!(model.flags(model.index(0, TableModel::kName)) & Qt::ItemIsEditable));
    QVERIFY(!model.setData(model.index(0, TableModel::kName), QStringLiteral("x"), Qt::EditRole));
  }
};

QTEST_MAIN(AnchorTableModelTest)
#include "anchor_table_model_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/support/office_window.h"

#include "ui/dialogs/numbers_dialog.h"
#include "ui/main_window/appearance.h"
#include "ui/main_window/report.h"
#include "ui/main_window/view_pair.h"
#include "ui/panels/preview_panel.h"
#include "ui/tools/test_poses.h"

#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

using namespace cad2slam;
using test::OfficeWindow;

/// Dialogs that ask for files, driven as somebody at the keyboard would.
class DialogsTest : public QObject {
  Q_OBJECT

 private slots:
  void aFileWhoseSuffixWasLeftOutIsNotReplacedUnasked() {
    const test::Sandbox sandbox;
    const QString path = sandbox.path(QStringLiteral("site.c2sproj"));
    {
      QFile other(path);
      QVERIFY(other.open(QIODevice::WriteOnly));
      other.write("somebody's work");
    }
    OfficeWindow office;
    int names_given = 0;
    QTimer driver;  // types the name, says no, gives up
    connect(&driver, &QTimer::timeout, &driver, [&] {
      QWidget* modal = QApplication::activeModalWidget();
      if (auto* question = qobject_cast<QMessageBox*>(modal)) return question->button(QMessageBox::No)->click();
      auto* dialog = qobject_cast<QFileDialog*>(modal);
      if (!dialog) return;
      if (names_given++ > 0) return dialog->reject();
      dialog->setDirectory(QFileInfo(path).absolutePath());
      dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(QStringLiteral("site"));
      QMetaObject::invokeMethod(dialog, "accept");
    });
    driver.start(50);
    QVERIFY(!office.window.files().askSaveAs());
    QVERIFY(names_given >= 2);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("somebody's work"));
  }

  /// Scenario 27: what is dragged with the mouse can be typed.
  void theTestPoseGoesWhereNumbersSay() {
    const test::Sandbox sandbox;
    OfficeWindow office;
    typeNumbers({"1", "2", "30"});
    office.window.view(Side::kSlam).setFocus();
    office.window.actionTable()[ActionId::kTypePose]->trigger();
    QVERIFY2(!office.window.testPoses().isRobotVisible(), "without an alignment there is no way from the SLAM map");
    QVERIFY(office.hasMessage(QStringLiteral("poses")));

    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    for (const Side side : {Side::kSlam, Side::kBlueprint}) {
      const Eigen::Vector2d place = half(office.document().anchors()[2], side);
      const QString x = QString::number(place.x(), 'f', 3);
      office.window.activateWindow();  // again, after a dialog
      office.window.view(side).setFocus();
      QTRY_COMPARE(office.window.views().activeSide(), side);
      typeNumbers({x, QString::number(place.y(), 'f', 3), QStringLiteral("-170")});
      office.window.actionTable()[ActionId::kTypePose]->trigger();
      QVERIFY(office.window.actionTable()[ActionId::kTestPose]->isChecked());
      const Pose2 robot = office.window.testPoses().robotIn(side).value();
      QVERIFY((robot.translation - place).norm() < 2e-3);
      QVERIFY(std::abs(robot.heading * 180.0 / kPi + 170.0) < 1e-3);
      for (const Side each : {Side::kSlam, Side::kBlueprint}) {
        const Pose2 there = office.window.testPoses().robotIn(each).value();
        QVERIFY(QTest::qWaitFor([&] { return office.window.view(each).isInView(toQPointF(there.translation)); }));
      }
    }
  }

  void theReportShowsBothMapsWholeWithThePreviewClosed() {
    const test::Sandbox sandbox;
    OfficeWindow office;
    QVERIFY(picturesOverEachOther(office.session()).isNull());
    office.addExact(12);
    QVERIFY(office.waitUntilSolved());
    office.window.preview().hide();
    QVERIFY(QTest::qWaitFor([&] {
      return office.session().rasters().picture(Side::kSlam)->state() == TilePyramid::State::kReady &&
             office.session().rasters().picture(Side::kBlueprint)->state() == TilePyramid::State::kReady;
    }));
    // Where walls agree both inks make black; they do not when all is a metre off.
    const qint64 agreed = blackPixels(picturesOverEachOther(office.session()));
    for (const Anchor& anchor : AnchorList(office.document().anchors()))
      edit::moveAnchor(office.document(), anchor.id, Side::kSlam, anchor.in_slam + Eigen::Vector2d(1.0, 0.8),
                       office.document().newGesture());
    QVERIFY(office.waitUntilSolved());
    const qint64 by_chance = blackPixels(picturesOverEachOther(office.session()));
    QVERIFY2(agreed > 3 * by_chance && by_chance > 0,
             qPrintable(QStringLiteral("%1 pixels agree, %2 by chance").arg(agreed).arg(by_chance)));
  }

  void aProjectIsRemembered() {
    const test::Sandbox sandbox;
    const QString path = sandbox.path(QStringLiteral("remembered.c2sproj"));
    const auto isInMenu = [&path](OfficeWindow& office) {
      for (QMenu* menu : office.window.findChildren<QMenu*>()) {
        emit menu->aboutToShow();
        for (const QAction* action : menu->actions())
          if (action->text() == path && action->isEnabled()) return true;
      }
      return false;
    };
    {
      OfficeWindow office;
      QVERIFY(!isInMenu(office));
      QVERIFY(office.window.files().saveProjectTo(path));
      QVERIFY2(isInMenu(office), "at once");
    }
    const QString other = sandbox.path(QStringLiteral("other.c2sproj"));
    {
      OfficeWindow office;
      QVERIFY(office.window.files().saveProjectTo(other));
    }  // closed at once
    OfficeWindow office;
    QVERIFY(isInMenu(office));
    QVERIFY(QSettings().value(QStringLiteral("recent_projects")).toStringList().contains(other));
  }

  /// From the engine to the bar, in the language of the window.
  void errorsOfTheEngineSpeakTheLanguageOfTheWindow() {
    const test::Sandbox sandbox;
    const QString path = sandbox.path(QStringLiteral("broken.c2sproj"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\n \"name\": ");
    file.close();
    QStringList told;
    for (const char* language : {"de", "es", "en"}) {
      applyLanguage(QString::fromLatin1(language));
      OfficeWindow office(false);
      QVERIFY(!office.window.files().openProject(path));
      for (const Message& message : office.window.messages().messages())
        if (message.id == QStringLiteral("open")) told += message.text;
    }
    QLocale::setDefault(QLocale::c());
    QCOMPARE(told.size(), 3);
    for (const QString& text : told) QVERIFY2(text.startsWith(path + QStringLiteral(":2: ")), qPrintable(text));
    QVERIFY2(told[0].endsWith(QStringLiteral(" kein gültiges JSON")), qPrintable(told[0]));
    QVERIFY2(told[1].endsWith(QStringLiteral(": no es JSON válido")), qPrintable(told[1]));
    QVERIFY2(told[2].endsWith(QStringLiteral(": is not valid JSON")), qPrintable(told[2]));
  }

  void tipsComeOnceAndNotToWhoDoesNotWantThem() {
    const test::Sandbox sandbox;
    Tips::setWanted(true);
    const QString tip = QStringLiteral("tip");
    OfficeWindow office;
    office.addExact(1);
    QVERIFY(office.hasMessage(tip));
    office.window.messages().remove(tip);
    edit::deleteAnchors(office.document(), {1});
    office.addExact(1);
    QVERIFY2(!office.hasMessage(tip), "told before");
    office.addExact(2, 1);
    QVERIFY(office.hasMessage(tip));
    QVERIFY(office.pressCure(tip, QStringLiteral("No more")));
    QVERIFY(!office.hasMessage(tip));
    office.addExact(7, 3);
    QVERIFY(!office.hasMessage(tip));
  }

 private:
  static qint64 blackPixels(const QImage& picture) {
    qint64 count = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) count += picture.pixelColor(x, y).lightness() < 70 ? 1 : 0;
    return count;
  }

  /// Into the next dialog that asks for numbers, and OK.
  static void typeNumbers(const QStringList& texts) {
    QTimer::singleShot(0, qApp, [texts] {
      auto* dialog = qobject_cast<NumbersDialog*>(QApplication::activeModalWidget());
      QVERIFY(dialog);
      const QList<QLineEdit*> fields = dialog->findChildren<QLineEdit*>();
      QCOMPARE(fields.size(), texts.size());
      for (qsizetype i = 0; i < texts.size(); ++i) fields[i]->setText(texts[i]);
      dialog->accept();
    });
  }
};

QTEST_MAIN(DialogsTest)
#include "dialogs_test.moc"

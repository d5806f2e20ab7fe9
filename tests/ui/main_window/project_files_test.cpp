// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/project_files.h"

#include "ui/main_window/exports.h"
#include "ui/panels/anchor_panel.h"
#include "ui/support/office_window.h"

#include <QFile>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>
#include <QTimer>

using namespace cad2slam;
using test::OfficeWindow;

namespace {

/// Presses a button of the question that is about to come up.
void answerNextQuestion(const QString& label) {
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, label] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box) return;
    for (QAbstractButton* button : box->buttons()) {
      if (button->text().remove(QLatin1Char('&')) != label) continue;
      timer->deleteLater();
      button->click();
      return;
    }
  });
  timer->start(20);
}

std::size_t anchorsIn(const QString& path) {
  return readProject(toPath(path)).value().slam_maps.at(0).anchors.size();
}

}  // namespace

class ProjectFilesTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

 private slots:
  void init() { sandbox_.emplace(); }

  void whatAnotherProgramSavedIsNotReplacedUnasked() {
    const QString path = sandbox_->path(QStringLiteral("site.c2sproj"));
    OfficeWindow mine;
    mine.addExact(3);
    QVERIFY(mine.window.files().saveProjectTo(path));
    OfficeWindow theirs(false);
    QVERIFY(theirs.window.files().openProject(path));
    QVERIFY(theirs.waitUntilReady());
    theirs.addExact(10, 3);
    QVERIFY(theirs.window.files().askSave());  // no question: the file is as it was opened
    QCOMPARE(anchorsIn(path), std::size_t(13));
    theirs.addExact(1, 13);
    QVERIFY(theirs.window.files().askSave());  // nor after its own save
    QCOMPARE(anchorsIn(path), std::size_t(14));

    mine.addExact(1, 20);
    answerNextQuestion(QStringLiteral("Cancel"));
    QVERIFY(!mine.window.files().askSave());
    QVERIFY(mine.document().isModified());
    QCOMPARE(anchorsIn(path), std::size_t(14));
    answerNextQuestion(QStringLiteral("Replace"));
    QVERIFY(mine.window.files().askSave());
    QCOMPARE(anchorsIn(path), std::size_t(4));
    mine.addExact(1, 21);
    QVERIFY(mine.window.files().askSave());
    QCOMPARE(anchorsIn(path), std::size_t(5));
    // A file that is gone holds nothing to lose.
    QVERIFY(QFile::remove(path));
    mine.addExact(1, 22);
    QVERIFY(mine.window.files().askSave());
    QCOMPARE(anchorsIn(path), std::size_t(6));
    theirs.document().reset(Project{}, {});
  }

  void whatIsBeingTypedIsSaved() {
    const QString path = sandbox_->path(QStringLiteral("site.c2sproj"));
    OfficeWindow office;
    office.addExact(3);
    QVERIFY(office.window.files().saveProjectTo(path));
    QTableView* table = office.window.anchorPanel().table();
    const auto type = [&](const QString& name) {
      table->setFocus();
      const QModelIndex cell = table->model()->index(0, AnchorTableModel::kName);
      table->setCurrentIndex(cell);
      table->edit(cell);
      auto* editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
      if (editor) editor->selectAll();
      if (editor) QTest::keyClicks(editor, name);
      return editor;
    };
    QLineEdit* editor = type(QStringLiteral("north door"));
    QVERIFY(editor);
    QTest::keyClick(editor, Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!office.document().isModified(), test::kPatience);
    QCOMPARE(readProject(toPath(path)).value().slam_maps.at(0).anchors.at(0).name, std::string("north door"));
    QVERIFY(table->hasFocus());
    // A question whether to save comes for what is still in the cell, too.
    QVERIFY(type(QStringLiteral("south door")));
    answerNextQuestion(QStringLiteral("Save"));
    QVERIFY(office.window.files().mayClose());
    QCOMPARE(readProject(toPath(path)).value().slam_maps.at(0).anchors.at(0).name, std::string("south door"));
  }

  void aProjectOfTheTourIsNotProposedBesideTheProgram() {
    const QString site = sandbox_->path(QStringLiteral("site"));
    const QString sample = sandbox_->path(QStringLiteral("sample"));
    QVERIFY(QDir().mkpath(site) && QDir().mkpath(sample));
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    QCOMPARE(ProjectFiles::folderToSaveIn(site, sample), site);
    QCOMPARE(ProjectFiles::folderToSaveIn(site, std::nullopt), site);
    QCOMPARE(ProjectFiles::folderToSaveIn(sample, sample), documents);
    QCOMPARE(ProjectFiles::folderToSaveIn(sample + QStringLiteral("/../sample/"), sample), documents);
    QCOMPARE(ProjectFiles::folderToSaveIn(sandbox_->path(QStringLiteral("gone")), std::nullopt), documents);
  }

  void savingLeavesTheKeyboardWhereItIs() {
    OfficeWindow office;
    office.window.view(Side::kSlam).setFocus();
    QVERIFY(office.window.files().saveProjectTo(sandbox_->path(QStringLiteral("site.c2sproj"))));
    QVERIFY(office.window.files().askSave());
    QVERIFY(office.window.view(Side::kSlam).hasFocus());
  }
};

QTEST_MAIN(ProjectFilesTest)
#include "project_files_test.moc"

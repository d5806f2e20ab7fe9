// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/message_bar.h"

#include "ui/panels/toast_overlay.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

using namespace cad2slam;

namespace {

Message finding(const QString& id, const QString& text, std::vector<Cure> cures = {},
                Severity severity = Severity::kWarning) {
  return {QStringLiteral("diagnosis-") + id, severity, text, std::move(cures), 0};
}

QStringList shownTexts(const MessageBar& bar) {
  QStringList texts;
  for (const MessageRow* row : bar.findChildren<MessageRow*>())
    if (!row->isHidden()) texts << row->message().text;
  texts.sort();
  return texts;
}

}  // namespace

class MessageBarTest : public QObject {
  Q_OBJECT

 private:
  const QString group_ = QStringLiteral("diagnosis-");

 private slots:
  void aCurePressedWhileItsNumbersChangeStillRuns() {
    MessageBar bar;
    QString cured;
    const auto at = [&](const QString& number) {
      return finding(QStringLiteral("1"), QStringLiteral("off by ") + number,
                     {{QStringLiteral("Disable"), [&cured, number] { cured = number; }}});
    };
    bar.showGroup(group_, {at(QStringLiteral("3 cm"))});
    bar.window()->show();
    auto* button = bar.findChild<QPushButton*>();
    QVERIFY(button);
    QTest::mousePress(button, Qt::LeftButton);
    bar.showGroup(group_, {finding(QStringLiteral("0"), QStringLiteral("worse"), {}, Severity::kError),
                           at(QStringLiteral("4 cm"))});  // a solve has ended
    QCoreApplication::processEvents();
    QTest::mouseRelease(button, Qt::LeftButton);
    QCOMPARE(cured, QStringLiteral("4 cm"));
  }

  void aButtonThatMeansSomethingElseIsAnotherOne() {
    MessageBar bar;
    QString cured;
    const auto with = [&](const QString& label) {
      return finding(QStringLiteral("1"), QStringLiteral("wrong"), {{label, [&cured, label] { cured = label; }}});
    };
    bar.show(with(QStringLiteral("Rescale")));
    bar.window()->show();
    QPointer<QPushButton> button = bar.findChild<QPushButton*>();
    QTest::mousePress(button, Qt::LeftButton);
    bar.show(with(QStringLiteral("Flip")));
    QTest::mouseRelease(button, Qt::LeftButton);
    QVERIFY(cured.isEmpty());
    QTRY_VERIFY(!button);
    QTest::mouseClick(bar.findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(cured, QStringLiteral("Flip"));
  }

  void aCureMayReplaceItsOwnMessage() {
    MessageBar bar;
    bar.show(finding(QStringLiteral("1"), QStringLiteral("before"),
                     {{QStringLiteral("Cure"), [&bar] { bar.remove(QStringLiteral("diagnosis-1")); }}}));
    bar.window()->show();
    QTest::mouseClick(bar.findChild<QPushButton*>(), Qt::LeftButton);
    QVERIFY(bar.messages().empty());
    QVERIFY(bar.isHidden());
  }

  void theWorstComeFirstAndTheRestAreFolded() {
    MessageBar bar;
    bar.showGroup(group_, {finding(QStringLiteral("1"), QStringLiteral("note"), {}, Severity::kNote),
                           finding(QStringLiteral("2"), QStringLiteral("warning")),
                           finding(QStringLiteral("3"), QStringLiteral("error"), {}, Severity::kError)});
    QCOMPARE(shownTexts(bar), (QStringList{QStringLiteral("error"), QStringLiteral("warning")}));
    const auto rows = bar.findChildren<MessageRow*>();
    bar.window()->show();
    QCoreApplication::processEvents();
    QVERIFY(rows[0]->y() < rows[1]->y());
    QCOMPARE(rows[0]->message().text, QStringLiteral("error"));
    // What is folded comes out with a click, and goes with another.
    auto* more = bar.findChild<QToolButton*>(QStringLiteral("moreMessages"));
    QVERIFY(more->isVisible());
    more->click();
    QTRY_COMPARE(shownTexts(bar).size(), 3);
    more->click();
    QCOMPARE(shownTexts(bar).size(), 2);
    bar.showGroup(group_, {finding(QStringLiteral("1"), QStringLiteral("note"), {}, Severity::kNote)});
    QTRY_COMPARE(shownTexts(bar), QStringList{QStringLiteral("note")});
    QVERIFY(!more->isVisible());
  }

  void whatFilesWriteIsTextAndNeverFillsTheScreen() {
    MessageBar bar;
    bar.show(finding(QStringLiteral("1"), QStringLiteral("<b>") + QString(100'000, QLatin1Char('w')),
                     {{QString(100'000, QLatin1Char('w')), [] {}}}));
    const auto* row = bar.findChild<MessageRow*>();
    QVERIFY(row->heightForWidth(1000) < 600);
    QVERIFY(bar.findChild<QPushButton*>()->sizeHint().width() < 1500);
    for (const QLabel* label : row->findChildren<QLabel*>())
      QVERIFY(label->textFormat() == Qt::PlainText || !label->text().contains(QLatin1Char('<')));
    QCOMPARE(row->message().text.size(), qsizetype(100'003));
  }

  void aMessageThatVanishesTakesOnlyItself() {
    MessageBar bar;
    bar.show({QStringLiteral("toast"), Severity::kNote, QStringLiteral("deleted"), {}, 1});
    bar.show(finding(QStringLiteral("1"), QStringLiteral("stays")));
    QTRY_COMPARE(shownTexts(bar), QStringList{QStringLiteral("stays")});
  }

  void newsAndWhatIsPinnedAreNeverFolded() {
    MessageBar bar;
    bar.showGroup(group_, {finding(QStringLiteral("1"), QStringLiteral("error"), {}, Severity::kError),
                           finding(QStringLiteral("2"), QStringLiteral("worse"), {}, Severity::kError)});
    Message step{QStringLiteral("tour"), Severity::kNote, QStringLiteral("step"), {}, 0};
    step.pinned = true;
    bar.show(step);
    QCOMPARE(shownTexts(bar), (QStringList{QStringLiteral("error"), QStringLiteral("step")}));
    bar.show({QStringLiteral("old"), Severity::kError, QStringLiteral("old news"), {}, 60'000});
    bar.show({QStringLiteral("new"), Severity::kNote, QStringLiteral("news"), {}, 60'000});
    QCOMPARE(shownTexts(bar), (QStringList{QStringLiteral("news"), QStringLiteral("step")}));
    bar.remove(QStringLiteral("new"));
    QTRY_COMPARE(shownTexts(bar), (QStringList{QStringLiteral("old news"), QStringLiteral("step")}));
  }

  void newsOverTheViewsMoveNothing() {
    QWidget window;
    window.resize(600, 400);
    auto* layout = new QVBoxLayout(&window);
    auto* bar = new MessageBar;
    auto* views = new QWidget;
    layout->addWidget(bar);
    layout->addWidget(views, 1);
    auto* overlay = new ToastOverlay(*views);
    bar->setOverlay(overlay);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    const QRect before = views->geometry();
    QString cured;
    bar->show({QStringLiteral("toast"),
               Severity::kNote,
               QStringLiteral("Anchor 7 deleted"),
               {{QStringLiteral("Undo"), [&cured] { cured = QStringLiteral("undone"); }}},
               60'000});
    QCoreApplication::processEvents();
    QVERIFY(overlay->isVisible());
    QVERIFY(bar->isHidden());
    QCOMPARE(views->geometry(), before);
    QVERIFY(before.contains(overlay->geometry()));
    QCOMPARE(shownTexts(*bar), QStringList());
    QTest::mouseClick(overlay->findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(cured, QStringLiteral("undone"));
    window.resize(500, 300);
    QTRY_VERIFY(views->geometry().contains(overlay->geometry()));
    bar->remove(QStringLiteral("toast"));
    QVERIFY(overlay->isHidden());
    // What stays is beside it, and a message that changes its kind moves over.
    bar->show({QStringLiteral("toast"), Severity::kWarning, QStringLiteral("stays"), {}, 0});
    QCOMPARE(shownTexts(*bar), QStringList{QStringLiteral("stays")});
    bar->show({QStringLiteral("toast"), Severity::kWarning, QStringLiteral("goes"), {}, 1});
    QTRY_VERIFY(overlay->isHidden() && bar->isHidden());
  }

  void aClosedWarningComesBackWithItsReason() {
    MessageBar bar;
    const Message line = finding(QStringLiteral("8"), QStringLiteral("all on one line"));
    bar.showGroup(group_, {line});
    auto* close = bar.findChild<QToolButton*>(QStringLiteral("closeMessage"));
    QVERIFY(close);
    close->click();
    QVERIFY(bar.messages().empty());
    bar.showGroup(group_, {line});
    QVERIFY(bar.messages().empty());  // still the same: it stays closed
    bar.showGroup(group_, {});
    bar.showGroup(group_, {line});
    QCOMPARE(bar.messages().size(), std::size_t(1));
  }
};

QTEST_MAIN(MessageBarTest)
#include "message_bar_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/preview_panel.h"

#include <QSlider>
#include <QTest>
#include <QToolButton>

using namespace cad2slam;

class PreviewPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void blinkLastsWhileItsKeyIsHeld() {
    QWidget window;
    auto* panel = new PreviewPanel(&window);
    auto* beside = new QWidget(&window);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QTest::keyPress(beside, Qt::Key_B);
    QVERIFY(panel->view().isBlinkHeld());
    QTest::keyRelease(beside, Qt::Key_B);
    QVERIFY(!panel->view().isBlinkHeld());
    // Whatever else is held by then.
    QTest::keyPress(beside, Qt::Key_B);
    QTest::keyRelease(beside, Qt::Key_B, Qt::ShiftModifier);
    QVERIFY(!panel->view().isBlinkHeld());
  }

  void theOpacityCanBeSetInANarrowPanel() {
    PreviewPanel panel;
    for (const int width : {panel.minimumSizeHint().width(), 420, 900}) {
      panel.resize(width, 300);
      panel.show();
      QVERIFY(QTest::qWaitForWindowExposed(&panel));
      const auto* slider = panel.findChild<QSlider*>();
      QVERIFY(slider && slider->width() >= 70);
      const QRect in_panel(slider->mapTo(&panel, QPoint()), slider->size());
      QVERIFY(panel.rect().contains(in_panel));
      for (const QToolButton* button : panel.findChildren<QToolButton*>())
        QVERIFY(!button->isVisible() || !in_panel.intersects(QRect(button->mapTo(&panel, QPoint()), button->size())));
    }
  }

  /// Alt+Tab: the release of the key goes elsewhere.
  void blinkEndsWithTheWindowsTurn() {
    QWidget window;
    auto* panel = new PreviewPanel(&window);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    QTest::keyPress(panel, Qt::Key_B);
    QVERIFY(panel->view().isBlinkHeld());
    QWidget other;
    other.show();
    other.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&other));
    QVERIFY(!panel->view().isBlinkHeld());
  }
};

QTEST_MAIN(PreviewPanelTest)
#include "preview_panel_test.moc"

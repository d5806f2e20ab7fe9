// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/paint_turn.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QSet>
#include <QTest>
#include <QThread>

#include <algorithm>

namespace cad2slam {
namespace {

/// Dear to paint; notes the frame of the window in which it was.
class DearView : public QWidget {
 public:
  explicit DearView(const int& frame, QWidget* parent) : QWidget(parent), frame_(frame) {
    setAttribute(Qt::WA_OpaquePaintEvent);
  }
  QList<int> painted_in;
  QColor color = Qt::red;

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    if (!turn_.take(painter)) return;
    painted_in << frame_;
    painter.fillRect(rect(), color);
    QThread::msleep(10);
  }
  void hideEvent(QHideEvent*) override { turn_.forgetPixels(); }

 private:
  const int& frame_;
  PaintTurn turn_{*this};
};

class ViewsInAWindow : public QObject {
 public:
  ViewsInAWindow() {
    auto* layout = new QHBoxLayout(&window);
    for (int i = 0; i < 3; ++i) {
      views << new DearView(frame, &window);
      layout->addWidget(views.back());
    }
    window.resize(300, 100);
    window.installEventFilter(this);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) qFatal("the window does not show");
    QTest::qWait(50);
    forget();
  }
  ~ViewsInAWindow() override { window.removeEventFilter(this); }
  void forget() {
    for (DearView* view : views) view->painted_in.clear();
  }
  [[nodiscard]] bool haveAllPainted() const {
    return std::all_of(views.begin(), views.end(), [](const DearView* view) { return !view->painted_in.isEmpty(); });
  }

  int frame = 0;
  QWidget window;
  QList<DearView*> views;

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::UpdateRequest) ++frame;
    return false;
  }
};

class PaintTurnTest : public QObject {
  Q_OBJECT

 private slots:
  void eachDearViewHasAFrameOfItsOwn() {
    ViewsInAWindow shown;
    for (DearView* view : shown.views) view->update();
    QTRY_VERIFY(shown.haveAllPainted());
    QTest::qWait(100);
    QSet<int> frames;
    for (DearView* view : shown.views) {
      QCOMPARE(view->painted_in.size(), 1);
      frames << view->painted_in.first();
    }
    QCOMPARE(frames.size(), shown.views.size());
  }

  void nobodyWaitsForEver() {
    ViewsInAWindow shown;
    // The first is always ahead of the last.
    for (int i = 0; i < 12; ++i) {
      for (DearView* view : shown.views) view->update();
      QTest::qWait(20);
    }
    for (DearView* view : shown.views) QVERIFY(view->painted_in.size() >= 2);
  }

  void picturesAreWhole() {
    ViewsInAWindow shown;
    for (DearView* view : shown.views) view->color = Qt::blue;
    const QImage picture = shown.window.grab().toImage();
    for (DearView* view : shown.views) {
      const QPointF middle = view->geometry().center() * shown.window.devicePixelRatioF();
      QCOMPARE(picture.pixelColor(middle.toPoint()), QColor(Qt::blue));
    }
  }

  void oldPixelsOfAnotherPlaceAreNotShown() {
    ViewsInAWindow shown;
    shown.window.resize(330, 120);
    QTRY_VERIFY(shown.haveAllPainted());
    QSet<int> frames;
    for (DearView* view : shown.views) frames << view->painted_in.first();
    QCOMPARE(frames.size(), 1);

    shown.views[2]->hide();
    QTest::qWait(100);
    shown.forget();
    shown.views[2]->show();
    QTRY_VERIFY(shown.haveAllPainted());
    frames.clear();
    for (DearView* view : shown.views) frames << view->painted_in.first();
    QCOMPARE(frames.size(), 1);
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_MAIN(cad2slam::PaintTurnTest)
#include "paint_turn_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/map_view.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include <limits>

#include "ui/convert.h"
#include "ui/support/shown_view.h"

namespace cad2slam {
namespace {

using test::Shown;
constexpr double kResolution = test::kShownResolution;

double distance(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

Marker markerAt(MarkerId id, const QPointF& point_m) {
  Marker marker;
  marker.id = id;
  marker.text = QString::number(id);
  marker.point_m = point_m;
  return marker;
}

void moveWithoutButton(MapView& view, const QPointF& at) {
  QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&view, &move);
}

class MapViewTest : public QObject {
  Q_OBJECT

 private slots:
  void aMessageThatGoesInMidPanDoesNotPushTheMap() {
    QWidget window;
    auto* strip = new QWidget;
    auto* view = new MapView;
    strip->setFixedHeight(28);
    auto* layout = new QVBoxLayout(&window);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(strip);
    layout->addWidget(view, 1);
    const cv::Mat pixels(600, 800, CV_8UC1, cv::Scalar(255));
    const MapFrame frame = test::frameOf(pixels, kResolution, {{-3.0, 2.0}, 0.3});
    view->setImage(TilePyramid::fromPixels(pixels));
    view->setFrame(frame);
    window.resize(640, 508);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    view->fit();
    const auto in_window = [&] { return view->mapTo(&window, view->widgetFromMetres({5.0, 5.0})); };
    QTest::mousePress(view, Qt::LeftButton, {}, QPoint(300, 200));
    QTest::mouseMove(view, QPoint(330, 220));
    const QPointF before = in_window();
    strip->hide();
    QTRY_COMPARE(view->height(), 508);
    QVERIFY(distance(in_window(), before) <= 1.0);
    // The mouse stands where it stood, which is lower in the view now, and goes on.
    QTest::mouseMove(view, QPoint(331, 248));
    QVERIFY2(distance(in_window(), before + QPointF(1.0, 0.0)) <= 1.0, qPrintable(QString::number(in_window().y())));
    QTest::mouseRelease(view, Qt::LeftButton, {}, QPoint(331, 248));
  }

  void clickReportsMetres_data() {
    QTest::addColumn<double>("rotation");
    QTest::addColumn<double>("zoom");
    QTest::addColumn<QPointF>("pixel");
    QTest::newRow("middle") << 0.0 << 1.0 << QPointF(400, 300);
    QTest::newRow("top left") << 0.0 << 1.0 << QPointF(1, 1);
    QTest::newRow("bottom right") << 0.0 << 1.0 << QPointF(799, 599);
    QTest::newRow("turned") << 1.2 << 1.0 << QPointF(500, 200);
    QTest::newRow("turned and enlarged") << -2.5 << 3.0 << QPointF(420, 310);
  }
  void clickReportsMetres() {
    QFETCH(double, rotation);
    QFETCH(double, zoom);
    QFETCH(QPointF, pixel);
    Shown shown;
    shown.view.setRotation(rotation);
    shown.view.zoomBy(zoom);
    const QPointF expected = toQPointF(shown.frame.metricFromPixel(toEigen(pixel)));
    shown.view.centerOn(expected, false);
    QSignalSpy clicked(&shown.view, &MapView::clicked);
    QTest::mouseClick(&shown.view, Qt::LeftButton, {}, shown.at(expected));
    QCOMPARE(clicked.size(), 1);
    const double half_pixel_m = 0.75 * shown.view.viewState().m_per_px;
    QVERIFY(distance(clicked[0][0].toPointF(), expected) <= half_pixel_m);
    QVERIFY(distance(shown.view.imagePixelFromMetres(expected), pixel) < 1e-6);
  }

  void smallJitterIsAClickAndMoreIsAPan() {
    Shown shown;
    QSignalSpy clicked(&shown.view, &MapView::clicked);
    const ViewState before = shown.view.viewState();
    shown.drag({300, 200}, {302, 202});
    QCOMPARE(clicked.size(), 1);
    QVERIFY(shown.view.viewState() == before);

    const QPointF grabbed = shown.view.metresFromWidget(QPointF(300, 200));
    shown.drag({300, 200}, {360, 170});
    QCOMPARE(clicked.size(), 1);
    QVERIFY(distance(shown.view.widgetFromMetres(grabbed), QPointF(360, 170)) < 1e-6);
  }

  void panNearAMarkerMovesNoMarker() {
    Shown shown;
    const QPointF place = shown.middle();
    shown.view.setMarkers({markerAt(1, place)});
    QSignalSpy pressed(&shown.view, &MapView::markerPressed);
    QSignalSpy dragged(&shown.view, &MapView::dragStarted);
    QSignalSpy clicked(&shown.view, &MapView::clicked);
    const QPoint start = shown.at(place) + QPoint(14, 0);
    shown.drag(start, start + QPoint(50, 40));
    QCOMPARE(pressed.size() + dragged.size() + clicked.size(), 0);
  }

  void middleButtonAndSpacePan() {
    Shown shown;
    shown.view.setMarkers({markerAt(1, shown.middle())});
    QSignalSpy pressed(&shown.view, &MapView::markerPressed);
    QSignalSpy clicked(&shown.view, &MapView::clicked);
    const QPoint start = shown.at(shown.middle());  // even on a marker
    shown.drag(start, start + QPoint(-60, 10), Qt::MiddleButton);
    QCOMPARE(shown.at(shown.middle()), start + QPoint(-60, 10));
    QTest::keyPress(&shown.view, Qt::Key_Space);
    shown.drag(shown.at(shown.middle()), start);
    QTest::mouseClick(&shown.view, Qt::LeftButton, {}, QPoint(100, 100));
    QTest::keyRelease(&shown.view, Qt::Key_Space);
    QCOMPARE(shown.at(shown.middle()), start);
    QCOMPARE(pressed.size() + clicked.size(), 0);
  }

  void nearestMarkerWins() {
    Shown shown;
    const QPointF place = shown.middle();
    const double px = shown.view.viewState().m_per_px;
    shown.view.setMarkers({markerAt(1, place), markerAt(2, place + QPointF(14 * px, 0))});
    QSignalSpy pressed(&shown.view, &MapView::markerPressed);
    QSignalSpy marker_clicked(&shown.view, &MapView::markerClicked);
    QTest::mouseClick(&shown.view, Qt::LeftButton, Qt::ControlModifier, shown.at(place) + QPoint(9, 0));
    QCOMPARE(marker_clicked.size(), 1);
    QVERIFY(marker_clicked[0] == pressed.value(0));
    QCOMPARE(pressed.size(), 1);
    QCOMPARE(pressed[0][0].value<MarkerId>(), MarkerId(2));
    QCOMPARE(pressed[0][1].value<Qt::KeyboardModifiers>(), Qt::ControlModifier);
  }

  void dragKeepsTheGrip() {
    Shown shown;
    shown.view.setSnapping(false);
    const QPointF place = shown.middle();
    shown.view.setMarkers({markerAt(7, place)});
    QSignalSpy started(&shown.view, &MapView::dragStarted);
    QSignalSpy moved(&shown.view, &MapView::dragMoved);
    QSignalSpy finished(&shown.view, &MapView::dragFinished);
    QSignalSpy clicked(&shown.view, &MapView::clicked);
    const QPointF target = shown.view.metresFromWidget(shown.view.widgetFromMetres(place) + QPointF(40, -25));
    const QPoint grip = shown.at(place) + QPoint(5, 4);  // not quite on its centre
    shown.drag(grip, grip + QPoint(40, -25));
    QCOMPARE(started.size(), 1);
    QVERIFY(moved.size() >= 3);
    QCOMPARE(finished.size(), 1);
    QCOMPARE(finished[0][0].value<MarkerId>(), MarkerId(7));
    QVERIFY(distance(finished[0][1].toPointF(), target) < 1e-6);
    QCOMPARE(clicked.size(), 0);
  }

  /// A dialog that comes up by a key gets the release of the mouse.
  void aDragWhoseReleaseWentElsewhereEnds() {
    Shown shown;
    shown.view.setSnapping(false);
    shown.view.setMarkers({markerAt(7, shown.middle())});
    QSignalSpy moved(&shown.view, &MapView::dragMoved);
    QSignalSpy finished(&shown.view, &MapView::dragFinished);
    QSignalSpy clicked(&shown.view, &MapView::clicked);
    const QPoint start = shown.at(shown.middle());
    QTest::mousePress(&shown.view, Qt::LeftButton, {}, start);
    QTest::mouseMove(&shown.view, start + QPoint(30, 0));
    QVERIFY(shown.view.isDragging());
    const auto moves = moved.size();
    moveWithoutButton(shown.view, start + QPoint(90, 60));
    QVERIFY(!shown.view.isDragging());
    QCOMPARE(moved.size(), moves);
    QCOMPARE(finished.size(), 1);
    QCOMPARE(finished[0][1].toPointF(), moved.last()[1].toPointF());
    // The same of a pan, and a press alone is no click somewhere else.
    shown.view.setMarkers({});
    QTest::mousePress(&shown.view, Qt::LeftButton, {}, start);
    QTest::mouseMove(&shown.view, start + QPoint(30, 0));
    const ViewState panned = shown.view.viewState();
    moveWithoutButton(shown.view, start + QPoint(90, 60));
    QVERIFY(shown.view.viewState() == panned);
    QTest::mousePress(&shown.view, Qt::LeftButton, {}, start);
    moveWithoutButton(shown.view, start + QPoint(90, 60));
    QVERIFY(shown.view.viewState() == panned);
    QCOMPARE(clicked.size(), 0);
    QTest::mouseClick(&shown.view, Qt::LeftButton, {}, start);
    QCOMPARE(clicked.size(), 1);
  }

  void onlyPlacesThatCanBeCountedWithAreShown() {
    Shown shown;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    const ViewState before = shown.view.viewState();
    for (const double bad : {1e308, -1e308, 2e9, infinite, nan}) {
      for (const QPointF& center : {QPointF(bad, 0.0), QPointF(0.0, bad), QPointF(bad, bad)}) {
        shown.view.setViewState({center, 0.05, 0.0});
        shown.view.centerOn(center, false);
        shown.view.centerOn(center, true);
        shown.view.fitRect(QRectF(center, QSizeF(1.0, 1.0)));
      }
    }
    for (const double bad : {infinite, -infinite, nan}) {
      shown.view.setViewState({before.center_m, 0.05, bad});
      shown.view.setViewState({before.center_m, bad, 0.0});
    }
    QVERIFY(shown.view.viewState() == before && shown.view.isFitted());
    QTest::qWait(0);
    shown.view.setMarkers({markerAt(1, {1e308, -1e308}), markerAt(2, {nan, infinite})});
    shown.view.setResiduals({{{1e308, 0.0}, {0.0, infinite}, MarkerClass::kPlain}}, 10.0);
    shown.view.setPaths({PathGlyph{{{0.0, 0.0}, {1e308, -1e308}}, Qt::red, 2.0, {}, false}});
    shown.view.setGhost(Ghost{{1e308, 1e308}, 1e308, QStringLiteral("?")});
    QVERIFY(!shown.view.grab().isNull());
    // Far away there is nothing but background.
    shown.view.setViewState({{9e8, -9e8}, 0.05, 0.0});
    QVERIFY(!shown.view.grab().isNull());
  }

  void escapeRestoresADrag() {
    Shown shown;
    shown.view.setMarkers({markerAt(7, shown.middle())});
    QSignalSpy cancelled(&shown.view, &MapView::dragCancelled);
    QSignalSpy finished(&shown.view, &MapView::dragFinished);
    QSignalSpy moved(&shown.view, &MapView::dragMoved);
    QSignalSpy idle(&shown.view, &MapView::cancelRequested);
    const QPoint start = shown.at(shown.middle());
    QTest::mousePress(&shown.view, Qt::LeftButton, {}, start);
    QTest::mouseMove(&shown.view, start + QPoint(30, 0));
    QVERIFY(shown.view.isDragging());
    QTest::keyClick(&shown.view, Qt::Key_Escape);
    QCOMPARE(cancelled.size(), 1);
    const auto moves = moved.size();
    QTest::mouseMove(&shown.view, start + QPoint(60, 0));
    QTest::mouseRelease(&shown.view, Qt::LeftButton, {}, start + QPoint(60, 0));
    QCOMPARE(moved.size(), moves);
    QCOMPARE(finished.size(), 0);
    for (int i = 0; i < 10; ++i) QTest::keyClick(&shown.view, Qt::Key_Escape);
    QCOMPARE(idle.size(), 10);
    QVERIFY(shown.view.isVisible());
  }

  void lockedMarkersAreSelectedNotMoved() {
    Shown shown;
    Marker marker = markerAt(7, shown.middle());
    marker.selected = true;
    shown.view.setMarkers({marker});
    shown.view.setLocked(true);
    QSignalSpy pressed(&shown.view, &MapView::markerPressed);
    QSignalSpy started(&shown.view, &MapView::dragStarted);
    QSignalSpy nudged(&shown.view, &MapView::nudged);
    const QPoint start = shown.at(shown.middle());
    shown.drag(start, start + QPoint(40, 0));
    QTest::keyClick(&shown.view, Qt::Key_Left);
    QCOMPARE(pressed.size(), 1);
    QCOMPARE(started.size() + nudged.size(), 0);
  }

  void wheelZoomsAtTheCursor() {
    Shown shown;
    shown.view.setRotation(0.7);
    const QPointF cursor(150, 330);
    const QPointF below = shown.view.metresFromWidget(cursor);
    const double before = shown.view.viewState().m_per_px;
    for (int i = 0; i < 5; ++i) shown.wheel(cursor, 120);
    QVERIFY(shown.view.viewState().m_per_px < before / 2.5);
    QVERIFY(distance(shown.view.widgetFromMetres(below), cursor) < 1e-6);
    for (int i = 0; i < 5; ++i) shown.wheel(cursor, -120);
    QVERIFY(std::abs(shown.view.viewState().m_per_px - before) < 1e-9);
    for (int i = 0; i < 400; ++i) shown.wheel(cursor, i < 200 ? 240 : -240);  // never beyond use
    QVERIFY(shown.view.viewState().m_per_px > 0.0 && std::isfinite(shown.view.viewState().m_per_px));
    shown.wheel(cursor, 120, Qt::ShiftModifier);
    QVERIFY(std::abs(shown.view.viewState().rotation_rad - 0.7) > 0.05);
  }

  void zoomWhileDraggingKeepsTheMarkerUnderTheCursor() {
    Shown shown;
    shown.view.setSnapping(false);
    shown.view.setMarkers({markerAt(7, shown.middle())});
    QSignalSpy finished(&shown.view, &MapView::dragFinished);
    const QPoint start = shown.at(shown.middle());
    const QPoint end = start + QPoint(80, 30);
    QTest::mousePress(&shown.view, Qt::LeftButton, {}, start);
    QTest::mouseMove(&shown.view, end);
    shown.wheel(end, 360);
    QTest::mouseRelease(&shown.view, Qt::LeftButton, {}, end);
    QCOMPARE(finished.size(), 1);
    QVERIFY(distance(shown.view.widgetFromMetres(finished[0][1].toPointF()), end) < 1.5);
  }

  void snapIsShownBeforeTheClickAndReported() {
    Shown shown(test::floorPlan(800, 600));
    shown.view.showActualSize();
    const QPointF corner = toQPointF(shown.frame.metricFromPixel({404.0, 324.0}));  // inner corner of a room
    shown.view.centerOn(corner, false);
    QSignalSpy clicked(&shown.view, &MapView::clicked);
    const QPoint beside = shown.at(corner) + QPoint(5, 4);
    QTest::mouseMove(&shown.view, beside + QPoint(1, 0));
    QTest::mouseMove(&shown.view, beside);
    const QImage with_square = shown.view.grab().toImage();
    QTest::mouseClick(&shown.view, Qt::LeftButton, {}, beside);
    QCOMPARE(clicked.size(), 1);
    QVERIFY(clicked[0][2].toBool());
    QVERIFY2(distance(clicked[0][0].toPointF(), corner) < 0.6 * kResolution,
             qPrintable(QString::number(distance(clicked[0][0].toPointF(), corner) / kResolution)));

    QTest::mouseMove(&shown.view, beside + QPoint(1, 0));
    shown.view.setSnapping(false);
    QVERIFY(shown.view.grab().toImage() != with_square);
    QTest::mouseClick(&shown.view, Qt::LeftButton, {}, beside);
    QVERIFY(!clicked[1][2].toBool());
  }

  void altSuspendsSnapping() {
    Shown shown(test::floorPlan(800, 600));
    shown.view.showActualSize();
    const QPointF corner = toQPointF(shown.frame.metricFromPixel({404.0, 324.0}));
    shown.view.centerOn(corner, false);
    QSignalSpy clicked(&shown.view, &MapView::clicked);
    const QPoint beside = shown.at(corner) + QPoint(5, 4);
    QTest::mouseMove(&shown.view, beside);
    QTest::keyPress(&shown.view, Qt::Key_Alt, Qt::AltModifier);
    QTest::mouseClick(&shown.view, Qt::LeftButton, Qt::AltModifier, beside);
    QVERIFY(!clicked[0][2].toBool());
  }

  void arrowKeysNudgeByImagePixels() {
    Shown shown;
    Marker marker = markerAt(7, shown.middle());
    marker.selected = true;
    shown.view.setMarkers({marker});
    shown.view.setRotation(1.0);
    QSignalSpy nudged(&shown.view, &MapView::nudged);
    QTest::keyClick(&shown.view, Qt::Key_Right);
    QTest::keyClick(&shown.view, Qt::Key_Up, Qt::ShiftModifier);
    QTest::keyClick(&shown.view, Qt::Key_Left, Qt::ControlModifier);
    QCOMPARE(nudged.size(), 3);
    const QPointF right = nudged[0][0].toPointF();
    const QPointF on_screen = shown.view.widgetFromMetres(right) - shown.view.widgetFromMetres(QPointF(0, 0));
    QVERIFY(on_screen.x() > 0 && std::abs(on_screen.y()) < 1e-9);
    QVERIFY(std::abs(std::hypot(right.x(), right.y()) - kResolution) < 1e-12);
    const QPointF up = nudged[1][0].toPointF();
    QVERIFY(std::abs(std::hypot(up.x(), up.y()) - 10 * kResolution) < 1e-12);
    const QPointF left = nudged[2][0].toPointF();
    QVERIFY(distance(left, right * -0.1) < 1e-12);
    QCOMPARE(nudged[0][1].toInt(), nudged[2][1].toInt());  // one burst
    QTest::qWait(1100);
    QTest::keyClick(&shown.view, Qt::Key_Right);
    QVERIFY(nudged[3][1].toInt() != nudged[0][1].toInt());
  }

  void arrowKeysPanWithoutASelection() {
    Shown shown;
    QSignalSpy nudged(&shown.view, &MapView::nudged);
    const ViewState before = shown.view.viewState();
    QTest::keyClick(&shown.view, Qt::Key_Down);
    QCOMPARE(nudged.size(), 0);
    QVERIFY(shown.view.viewState() != before);
  }

  void rightClickAsksForAMenu() {
    Shown shown;
    shown.view.setMarkers({markerAt(3, shown.middle())});
    QSignalSpy marker_menu(&shown.view, &MapView::markerMenuRequested);
    QSignalSpy menu(&shown.view, &MapView::menuRequested);
    QSignalSpy pressed(&shown.view, &MapView::markerPressed);
    QTest::mouseClick(&shown.view, Qt::RightButton, {}, shown.at(shown.middle()));
    QTest::mouseClick(&shown.view, Qt::RightButton, {}, QPoint(60, 60));
    QCOMPARE(marker_menu.size(), 1);
    QCOMPARE(menu.size(), 1);
    QCOMPARE(pressed.size(), 0);
  }

  void hoverEnlargesAndTells() {
    Shown shown;
    shown.view.setMarkers({markerAt(3, shown.middle())});
    QSignalSpy hovered(&shown.view, &MapView::hoveredMarkerChanged);
    QTest::mouseMove(&shown.view, QPoint(100, 100));
    const QImage plain = shown.view.grab().toImage();
    QTest::mouseMove(&shown.view, shown.at(shown.middle()));
    QCOMPARE(hovered.size(), 1);
    QCOMPARE(hovered[0][0].value<MarkerId>(), MarkerId(3));
    QTest::mouseMove(&shown.view, QPoint(100, 100));
    QCOMPARE(hovered.size(), 2);
    QCOMPARE(hovered[1][0].value<MarkerId>(), kNoMarker);
    shown.view.setHighlighted(3);  // the other view's hover
    QVERIFY(shown.view.grab().toImage() != plain);
  }

  void loupeIsHeldOrKept() {
    Shown shown(test::floorPlan(800, 600));
    QTest::mouseMove(&shown.view, QPoint(300, 200));
    QSignalSpy held(&shown.view, &MapView::loupeHeld);
    const QImage plain = shown.view.grab().toImage();
    QTest::keyPress(&shown.view, Qt::Key_Z);
    QVERIFY(shown.view.grab().toImage() != plain);
    QTest::keyRelease(&shown.view, Qt::Key_Z);
    QCOMPARE(shown.view.grab().toImage(), plain);
    QCOMPARE(held.size(), 2);
    QTest::keyClick(&shown.view, Qt::Key_L);
    QVERIFY(shown.view.isLoupeOn());
    QVERIFY(shown.view.grab().toImage() != plain);
    QTest::keyClick(&shown.view, Qt::Key_L);
    QVERIFY(!shown.view.isLoupeOn());
  }

  void longPressShowsTheLoupeAndStillClicks() {
    Shown shown(test::floorPlan(800, 600));
    shown.view.setSnapping(false);
    QSignalSpy clicked(&shown.view, &MapView::clicked);
    QTest::mouseMove(&shown.view, QPoint(300, 200));
    const QImage plain = shown.view.grab().toImage();
    QTest::mousePress(&shown.view, Qt::LeftButton, {}, QPoint(300, 200));
    QTRY_VERIFY(shown.view.grab().toImage() != plain);
    QTest::mouseRelease(&shown.view, Qt::LeftButton, {}, QPoint(300, 200));
    QCOMPARE(clicked.size(), 1);
    QCOMPARE(shown.view.grab().toImage(), plain);
  }

  void anotherButtonDoesNotEndAGesture() {
    Shown shown;
    shown.view.setMarkers({markerAt(7, shown.middle())});
    QSignalSpy finished(&shown.view, &MapView::dragFinished);
    const QPoint start = shown.at(shown.middle());
    QTest::mousePress(&shown.view, Qt::LeftButton, {}, start);
    QTest::mouseMove(&shown.view, start + QPoint(30, 0));
    QTest::mouseClick(&shown.view, Qt::MiddleButton, {}, start + QPoint(30, 0));
    QTest::mouseClick(&shown.view, Qt::RightButton, {}, start + QPoint(30, 0));
    QVERIFY(shown.view.isDragging());
    QCOMPARE(finished.size(), 0);
    QTest::mouseRelease(&shown.view, Qt::LeftButton, {}, start + QPoint(30, 0));
    QCOMPARE(finished.size(), 1);
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_MAIN(cad2slam::MapViewTest)
#include "map_view_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/map_view.h"

#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include "ui/convert.h"
#include "ui/support/shown_view.h"

namespace cad2slam {
namespace {

using test::Shown;
constexpr double kResolution = test::kShownResolution;

double distance(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// What part of the map a view shows, and that it is drawn there.
class MapViewLookTest : public QObject {
  Q_OBJECT

 private slots:
  void fitShowsTheWholeRasterAndStaysWhileResizing() {
    Shown shown;
    for (const QSize size : {QSize(640, 480), QSize(300, 700), QSize(900, 200)}) {
      for (const double rotation : {0.0, 0.8}) {
        shown.view.setRotation(rotation);
        shown.view.fit();
        shown.view.resize(size);
        QCoreApplication::processEvents();
        for (const Eigen::Vector2d& corner :
             {Eigen::Vector2d(0, 0), Eigen::Vector2d(800, 0), Eigen::Vector2d(0, 600), Eigen::Vector2d(800, 600)}) {
          QVERIFY(shown.view.isInView(toQPointF(shown.frame.metricFromPixel(corner)), 0.0));
        }
      }
    }
    const ViewState before = shown.view.viewState();
    shown.wheel(QPointF(100, 100), 120);
    const double zoomed = shown.view.viewState().m_per_px;
    QVERIFY(zoomed < before.m_per_px);
    shown.view.resize(500, 500);
    QCoreApplication::processEvents();
    QCOMPARE(shown.view.viewState().m_per_px, zoomed);  // the user's view is not thrown away
  }

  void aMessageRefitsOnlyWhatNobodyCanClickIn_data() {
    QTest::addColumn<bool>("locked");
    QTest::newRow("clicked in") << false;
    QTest::newRow("locked") << true;
  }
  void aMessageRefitsOnlyWhatNobodyCanClickIn() {
    QFETCH(bool, locked);
    const cv::Mat pixels(600, 800, CV_8UC1, cv::Scalar(255));
    QWidget window;
    window.resize(640, 480);
    MapView view(&window);
    view.setGeometry(0, 0, 640, 480);
    view.setLocked(locked);
    view.setImage(TilePyramid::fromPixels(pixels));
    view.setFrame(test::frameOf(pixels, kResolution));
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    view.fit();
    QCursor::setPos(view.mapToGlobal(QPoint(300, 200)));
    QCoreApplication::processEvents();
    const double before = view.viewState().m_per_px;
    view.setGeometry(0, 40, 640, 440);  // as a message bar above it does
    QCoreApplication::processEvents();
    if (locked) {
      QVERIFY(view.viewState().m_per_px > before);
    } else {
      QCOMPARE(view.viewState().m_per_px, before);
    }
  }

  void actualSizeIsOneDevicePixel() {
    Shown shown;
    shown.view.showActualSize();
    QVERIFY(std::abs(shown.view.viewState().m_per_px - kResolution * shown.view.devicePixelRatioF()) < 1e-12);
  }

  void glideArrivesAndNeverZooms() {
    Shown shown;
    const QPointF target = toQPointF(shown.frame.metricFromPixel({700, 500}));
    const ViewState before = shown.view.viewState();
    shown.view.centerOn(target, true);
    QTRY_VERIFY(distance(shown.view.viewState().center_m, target) < 1e-9);
    QCOMPARE(shown.view.viewState().m_per_px, before.m_per_px);
    QCOMPARE(shown.view.viewState().rotation_rad, before.rotation_rad);
  }

  void compassTurnsAndResets() {
    Shown shown;
    const QPoint compass(640 - 27, 27);
    shown.drag(compass + QPoint(0, -15), compass + QPoint(15, 0));
    QVERIFY2(std::abs(shown.view.viewState().rotation_rad + kPi / 2.0) < 0.1,
             qPrintable(QString::number(shown.view.viewState().rotation_rad)));
    QTest::mouseClick(&shown.view, Qt::LeftButton, {}, compass);
    QCOMPARE(shown.view.viewState().rotation_rad, 0.0);
  }

  void posesAreMovedAndTurned() {
    Shown shown;
    PoseGlyph pose;
    pose.id = 1000;
    pose.point_m = shown.middle();
    pose.heading_rad = 0.0;
    pose.turnable = true;
    pose.color = Qt::darkGreen;
    shown.view.setPoses({pose});
    QSignalSpy finished(&shown.view, &MapView::dragFinished);
    QSignalSpy turned(&shown.view, &MapView::poseTurnFinished);
    const QPoint body = shown.at(pose.point_m);
    shown.drag(body, body + QPoint(-50, 20));
    QCOMPARE(finished.size(), 1);
    const double radius = std::max(7.0, pose.radius_m / shown.view.viewState().m_per_px);
    const QPoint handle = body + QPoint(static_cast<int>(radius) + 22, 0);
    shown.drag(handle, body + QPoint(0, -60));
    QCOMPARE(turned.size(), 1);
    QVERIFY(std::abs(turned[0][1].toDouble() - kPi / 2.0) < 0.05);
  }

  void theTextOfAGhostIsInsideTheView() {
    Shown shown;
    const QImage before = shown.view.grab().toImage();
    const auto reachOf = [&](double x_px) {  // to the left and to the right of it
      shown.view.setGhost(Ghost{shown.view.metresFromWidget({x_px, 200.0}), 0.0, QStringLiteral("19? Enter accepts")});
      const QImage with_ghost = shown.view.grab().toImage();
      const double ratio = shown.view.devicePixelRatioF();
      double left = 0.0;
      double right = 0.0;
      for (int y = 0; y < before.height(); ++y)
        for (int x = 0; x < before.width(); ++x) {
          if (before.pixel(x, y) == with_ghost.pixel(x, y)) continue;
          left = std::max(left, x_px - x / ratio);
          right = std::max(right, x / ratio - x_px);
        }
      return std::pair(left, right);
    };
    const auto [left, right] = reachOf(300.0);
    QVERIFY(left < 20.0 && right > 60.0);
    const auto [left_at_edge, right_at_edge] = reachOf(600.0);
    QVERIFY(left_at_edge > 60.0 && right_at_edge < 20.0);
  }

  void aLargeRobotIsSeenWhileAPartOfItIsInView() {
    Shown shown;
    const double view_m = shown.view.width() * shown.view.viewState().m_per_px;
    PoseGlyph pose;
    pose.point_m = shown.middle() + QPointF(2.0 * view_m, 0.0);
    pose.color = Qt::magenta;
    const QImage before = shown.view.grab().toImage();
    pose.radius_m = 1.2 * view_m;
    shown.view.setPoses({pose});
    QCOMPARE(shown.view.grab().toImage(), before);
    pose.radius_m = 1.8 * view_m;
    shown.view.setPoses({pose});
    QVERIFY(shown.view.grab().toImage() != before);
  }

  void manyPosesAreTicksThatShowTheirHeadings() {
    Shown shown;
    const QImage before = shown.view.grab().toImage();
    std::vector<PoseGlyph> poses(20'000);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      poses[i].point_m = shown.middle() + QPointF(100.0 + static_cast<double>(i), 0.0);  // out of view
      poses[i].color = Qt::magenta;
    }
    shown.view.setPoses(poses);
    QCOMPARE(shown.view.grab().toImage(), before);
    poses[7].point_m = shown.middle();
    poses[7].heading_rad = kPi / 2.0;  // up
    shown.view.setPoses(poses);
    const QImage with_one = shown.view.grab().toImage();
    const QPoint at = shown.at(shown.middle());
    const auto color = [&](const QPoint& place) { return with_one.pixelColor(place * shown.view.devicePixelRatioF()); };
    QCOMPARE(color(at), QColor(Qt::magenta));
    QCOMPARE(color(at - QPoint(0, 5)), QColor(Qt::magenta));
    QVERIFY(color(at + QPoint(0, 5)) != QColor(Qt::magenta));
  }

  void rasterIsDrawnWhereTheFrameSaysIt_data() {
    QTest::addColumn<double>("rotation");
    QTest::addColumn<double>("zoom");
    for (const double rotation : {0.0, 0.5, -1.9, 3.1}) {
      for (const double zoom : {0.4, 1.0, 2.7, 9.0}) {
        QTest::addRow("%g rad, x%g", rotation, zoom) << rotation << zoom;
      }
    }
  }
  void rasterIsDrawnWhereTheFrameSaysIt() {
    QFETCH(double, rotation);
    QFETCH(double, zoom);
    cv::Mat pixels(600, 800, CV_8UC1, cv::Scalar(255));
    pixels(cv::Rect(400, 300, 16, 16)).setTo(0);
    Shown shown(pixels);
    shown.view.setSnapping(false);
    shown.view.setRotation(rotation);
    shown.view.setViewState({toQPointF(shown.frame.metricFromPixel({406.0, 310.0})), kResolution / zoom, rotation});
    QCoreApplication::processEvents();
    const QImage picture = shown.view.grab().toImage();
    const double ratio = shown.view.devicePixelRatioF();
    const auto greyAt = [&](double column, double row) {
      const QPointF at = shown.view.widgetFromMetres(toQPointF(shown.frame.metricFromPixel({column, row}))) * ratio;
      return qGray(picture.pixel(static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))));
    };
    const double far = 4.0 / zoom / ratio + 1.0;  // a few device pixels beside the edge
    QVERIFY(greyAt(408.0, 308.0) < 60);
    if (16.0 > 2.0 * far) {
      QVERIFY(greyAt(400.0 + far, 308.0) < 60);
      QVERIFY(greyAt(408.0, 316.0 - far) < 60);
    }
    QVERIFY(greyAt(400.0 - far, 308.0) > 200);
    QVERIFY(greyAt(416.0 + far, 308.0) > 200);
    QVERIFY(greyAt(408.0, 300.0 - far) > 200);
    QVERIFY(greyAt(408.0, 316.0 + far) > 200);
  }

  void withoutAnImageNothingIsPlaced() {
    MapView view;
    view.setEmptyText(QStringLiteral("Drop a blueprint here"));
    view.resize(300, 200);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QSignalSpy clicked(&view, &MapView::clicked);
    QSignalSpy dropped(&view, &MapView::filesDropped);
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(100, 100));
    QCOMPARE(clicked.size(), 0);
    QMimeData mime;
    mime.setUrls({QUrl::fromLocalFile(QStringLiteral("/tmp/plan.png")), QUrl(QStringLiteral("http://example.org/x"))});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &drop);
    QCOMPARE(dropped.size(), 1);
    QCOMPARE(dropped[0][0].toStringList(), QStringList{QStringLiteral("/tmp/plan.png")});
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_MAIN(cad2slam::MapViewLookTest)
#include "map_view_look_test.moc"

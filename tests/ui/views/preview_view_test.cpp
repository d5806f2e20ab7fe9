// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/preview_view.h"

#include <set>

#include <QSignalSpy>
#include <QTest>

#include "ui/convert.h"
#include "ui/support/rasters.h"

namespace cad2slam {
namespace {

const QPoint kProbe(120, 90);

/// A white base with a view that has been given an orange picture of whatever kind is asked for.
class Shown {
 public:
  Shown() : frame(test::frameOf(pixels, 0.05)) {
    view.setImage(TilePyramid::fromPixels(pixels));
    view.setFrame(frame);
    view.resize(640, 480);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    view.fit();
    view.setInks({{QColor(224, 0, 132), QStringLiteral("Blueprint")}, {QColor(0, 154, 68), QStringLiteral("Robot")}});
    bring();
  }
  void bring() {
    PreviewPicture picture;
    picture.kind = previewKind(view.mode());
    picture.state = view.viewState();
    picture.size = view.size() + QSize(40, 40);
    picture.full_color = 0.02;
    const double ratio = view.devicePixelRatioF();
    picture.image = QImage((QSizeF(picture.size) * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
    picture.image.fill(QColor(255, 120, 0));
    view.setPicture(picture);
  }
  [[nodiscard]] QColor colorAt(const QPoint& at) {
    return view.grab().toImage().pixelColor((QPointF(at) * view.devicePixelRatioF()).toPoint());
  }

  cv::Mat pixels = cv::Mat(600, 800, CV_8UC1, cv::Scalar(255));
  MapFrame frame;
  PreviewView view;
};

class PreviewViewTest : public QObject {
  Q_OBJECT

 private slots:
  void opacityMixes() {
    Shown shown;
    const QColor orange(255, 120, 0);
    for (const double opacity : {0.0, 0.5, 1.0}) {
      shown.view.setOpacity(opacity);
      const double expected = 255.0 + opacity * (orange.green() - 255.0);
      QVERIFY(std::abs(shown.colorAt(kProbe).green() - expected) < 3.0);
    }
  }

  void everyModeHasALegendAndShowsSomething() {
    Shown shown;
    std::set<QByteArray> pictures;
    for (int i = 0; i < kPreviewModeCount; ++i) {
      shown.view.setMode(static_cast<PreviewMode>(i));
      shown.bring();
      QTest::mouseMove(&shown.view, QPoint(200 + i, 200));
      const QImage image = shown.view.grab().toImage();
      pictures.insert(QByteArray(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes()));
      const QColor panel = image.pixelColor(image.width() - static_cast<int>(14 * shown.view.devicePixelRatioF()),
                                            image.height() - static_cast<int>(12 * shown.view.devicePixelRatioF()));
      QVERIFY(panel.lightness() > 150);
    }
    QCOMPARE(pictures.size(), std::size_t(kPreviewModeCount));
  }

  void theLegendGivesWayToThePointer() {
    Shown shown;
    shown.view.setOpacity(1.0);
    const QPoint at(shown.view.width() - 12, shown.view.height() - 12);
    const auto paper = [&] { return std::abs(shown.colorAt(at).green() - 255); };  // the picture's green is 120
    QTest::mouseMove(&shown.view, QPoint(50, 50));
    const int covered = paper();
    QTest::mouseMove(&shown.view, at);
    const int seen = paper();
    QVERIFY(covered < 40);
    QVERIFY(seen > 80);
    QTest::mouseMove(&shown.view, QPoint(50, 50));
    QCOMPARE(paper(), covered);
  }

  void blinkAndHideWhileBIsHeld() {
    Shown shown;
    shown.view.setMode(PreviewMode::kBlink);
    QCOMPARE(shown.colorAt(kProbe), QColor(Qt::white));
    shown.view.setFocus();
    QTest::keyPress(&shown.view, Qt::Key_B);
    QCOMPARE(shown.colorAt(kProbe), QColor(255, 120, 0));
    QTest::keyRelease(&shown.view, Qt::Key_B);
    QCOMPARE(shown.colorAt(kProbe), QColor(Qt::white));
    shown.view.setMode(PreviewMode::kOverlay);
    shown.view.setOpacity(1.0);
    QTest::keyPress(&shown.view, Qt::Key_B);
    QCOMPARE(shown.colorAt(kProbe), QColor(Qt::white));
    QTest::keyRelease(&shown.view, Qt::Key_B);
    shown.view.setMode(PreviewMode::kBlink);
    shown.view.setAutoBlink(true);
    QTRY_COMPARE(shown.colorAt(kProbe), QColor(255, 120, 0));
    QTRY_COMPARE(shown.colorAt(kProbe), QColor(Qt::white));
  }

  void swipeBarIsDragged() {
    Shown shown;
    shown.view.setMode(PreviewMode::kSwipe);
    QSignalSpy clicked(&shown.view, &MapView::clicked);
    const ViewState before = shown.view.viewState();
    QCOMPARE(shown.colorAt({250, 90}), QColor(Qt::white));
    QCOMPARE(shown.colorAt({400, 90}), QColor(255, 120, 0));
    QTest::mousePress(&shown.view, Qt::LeftButton, {}, QPoint(322, 200));
    QTest::mouseMove(&shown.view, QPoint(160, 210));
    QTest::mouseRelease(&shown.view, Qt::LeftButton, {}, QPoint(160, 210));
    QVERIFY(std::abs(shown.view.swipe() - 0.25) < 0.01);
    QCOMPARE(shown.colorAt({250, 90}), QColor(255, 120, 0));
    QVERIFY(shown.view.viewState() == before);
    QCOMPARE(clicked.size(), 0);
  }

  void lensFollowsTheCursor() {
    Shown shown;
    shown.view.setMode(PreviewMode::kLens);
    QTest::mouseMove(&shown.view, QPoint(300, 240));
    QCOMPARE(shown.colorAt({340, 240}), QColor(255, 120, 0));
    QCOMPARE(shown.colorAt({450, 240}), QColor(Qt::white));
  }

  void pictureStaysOnItsPlaceWhileTheViewMoves() {
    Shown shown;
    shown.view.setOpacity(1.0);
    shown.view.zoomBy(4.0);
    shown.bring();
    QSignalSpy wanted(&shown.view, &PreviewView::pictureWanted);
    ViewState state = shown.view.viewState();
    state.center_m += QPointF(10.0 * state.m_per_px, 0.0);
    shown.view.setViewState(state);
    QVERIFY(wanted.isEmpty());  // within the margin
    state.center_m += QPointF(190.0 * state.m_per_px, 0.0);
    shown.view.setViewState(state);
    QVERIFY(!wanted.isEmpty());
    QCOMPARE(shown.colorAt({420, 90}), QColor(255, 120, 0));  // still covered by the old picture
    QCOMPARE(shown.colorAt({480, 90}), QColor(Qt::white));    // beyond it until the new one comes
    shown.bring();
    QCOMPARE(shown.colorAt({480, 90}), QColor(255, 120, 0));
  }

  void residualsAreEnlargedUntilTheyAreSeen_data() {
    QTest::addColumn<double>("longest_m");
    for (const double longest_m : {0.004, 0.12, 2.83, 60.0}) QTest::addRow("%g m", longest_m) << longest_m;
  }
  void residualsAreEnlargedUntilTheyAreSeen() {
    QFETCH(double, longest_m);
    Shown shown;
    shown.view.setMode(PreviewMode::kResiduals);
    const QPointF from = toQPointF(shown.frame.metricFromPixel({400.0, 300.0}));
    const QPointF to = from + QPointF(longest_m, 0.0);
    Marker marker;
    marker.id = 1;
    marker.point_m = to;
    marker.judged = MarkerClass::kOk;
    shown.view.setMarkers({marker});
    const QImage without = shown.view.grab().toImage();
    shown.view.setResiduals({{from, to, MarkerClass::kOk}, {from, (from + to) / 2.0, MarkerClass::kOk}},
                            MapView::kAutomaticMagnification);
    const double factor = shown.view.residualMagnification();
    const double leading = factor / std::pow(10.0, std::floor(std::log10(factor) + 1e-9));
    QVERIFY(std::abs(leading - 1.0) < 1e-9 || std::abs(leading - 2.0) < 1e-9 || std::abs(leading - 5.0) < 1e-9);
    const double part = factor * longest_m / shown.view.viewState().m_per_px / shown.view.width();
    QVERIFY2(part > 0.04 && (part < 0.16 || factor == 1.0), qPrintable(QString::number(part)));
    QVERIFY(shown.view.grab().toImage() != without);
    shown.view.zoomBy(1e6);  // enough to see it as it is
    if (longest_m > 1.0) QCOMPARE(shown.view.residualMagnification(), 1.0);
  }

  void withoutAnyResidualThereIsNoFactor() {
    Shown shown;
    shown.view.setResiduals({}, MapView::kAutomaticMagnification);
    QCOMPARE(shown.view.residualMagnification(), 1.0);
    const QPointF at = toQPointF(shown.frame.metricFromPixel({400.0, 300.0}));
    shown.view.setResiduals({{at, at, MarkerClass::kOk}}, MapView::kAutomaticMagnification);
    QCOMPARE(shown.view.residualMagnification(), 1.0);
  }

  /// What is asked of a preview is the map: markers with their numbers leave it free.
  void anchorsSideBySideAreDots() {
    Shown shown;
    shown.view.setMode(PreviewMode::kTwoInk);
    const auto changed = [&](double apart_px) {
      const QImage before = shown.view.grab().toImage();
      std::vector<Marker> markers;
      for (int i = 0; i < 8; ++i) {
        Marker marker;
        marker.id = i;
        marker.text = QString::number(10 + i);
        marker.point_m = shown.view.metresFromWidget({60.0 + apart_px * i, 200.0});
        markers.push_back(marker);
      }
      shown.view.setMarkers(markers);
      const QImage after = shown.view.grab().toImage();
      shown.view.setMarkers({});
      int count = 0;
      for (int y = 0; y < after.height(); ++y)
        for (int x = 0; x < after.width(); ++x) count += after.pixel(x, y) != before.pixel(x, y);
      return count;
    };
    QVERIFY(4 * changed(30.0) < changed(78.0));
  }

  void pictureOfAnotherModeIsNotTaken() {
    Shown shown;
    const PreviewPicture warped = shown.view.picture();
    shown.view.setMode(PreviewMode::kTwoInk);
    QVERIFY(shown.view.picture().image.isNull());
    shown.view.setPicture(warped);
    QVERIFY(shown.view.picture().image.isNull());
  }

  void reasonAndBannerAreShown() {
    Shown shown;
    shown.view.setOpacity(1.0);
    const QImage plain = shown.view.grab().toImage();
    shown.view.setNotCurrent(QStringLiteral("Not current: the last solve failed"));
    QVERIFY(shown.view.grab().toImage() != plain);
    QCOMPARE(shown.colorAt(kProbe), QColor(255, 120, 0));  // the last good picture stays
    shown.view.setReason(QStringLiteral("Place an anchor in both views"));
    QCOMPARE(shown.colorAt(kProbe), QColor(Qt::white));
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_MAIN(cad2slam::PreviewViewTest)
#include "preview_view_test.moc"

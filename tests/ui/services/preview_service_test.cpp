// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/preview_service.h"

#include <cmath>

#include <QSignalSpy>
#include <QTest>

#include "ui/convert.h"
#include "ui/support/flat_projector.h"
#include "ui/support/rasters.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

// 20 m x 16 m of blueprint at 5 cm, a SLAM map turned by 0.4 rad, 1.1 times as large.
constexpr double kResolution = 0.05;
const Similarity2 kSlamFromBlueprint{1.1, 0.4, {3.0, -2.0}};
const QSize kView(400, 320);

struct World {
  cv::Mat blueprint = cv::Mat(320, 400, CV_8UC1, cv::Scalar(255));
  cv::Mat slam = cv::Mat(600, 700, CV_8UC1, cv::Scalar(255));
  MapFrame blueprint_frame = test::frameOf(blueprint, kResolution);
  MapFrame slam_frame = test::frameOf(slam, kResolution, {{-8.0, -6.0}, 0.2});
  Projector projector = test::flatProjector(20, 16, 1.0, kSlamFromBlueprint);

  static void paintDot(cv::Mat& raster, const MapFrame& frame, const Vector2d& point_m) {
    const Vector2d pixel = frame.pixelFromMetric(point_m);
    cv::circle(raster, {static_cast<int>(pixel.x()), static_cast<int>(pixel.y())}, 6, cv::Scalar(0), cv::FILLED);
  }
  [[nodiscard]] std::shared_ptr<PreviewScene> scene(WarpDirection direction) const {
    auto result = std::make_shared<PreviewScene>();
    PreviewRaster plan{TilePyramid::fromPixels(blueprint)->store(), blueprint_frame};
    PreviewRaster map{TilePyramid::fromPixels(slam)->store(), slam_frame};
    const bool blueprint_below = direction == WarpDirection::kToBlueprint;
    result->direction = direction;
    result->base = blueprint_below ? plan : map;
    result->base_ink = QColor(220, 0, 130);
    result->layers.push_back({blueprint_below ? map : plan, projector, QColor(0, 150, 70)});
    return result;
  }
};

PreviewRequest requestFor(std::shared_ptr<const PreviewScene> scene, PreviewKind kind, const ViewState& state,
                          double ratio = 1.0) {
  return {std::move(scene), kind, state, kView, ratio};
}

QRgb pixelAt(const PreviewPicture& picture, const Vector2d& point_m) {
  const double ratio = static_cast<double>(picture.image.width()) / picture.size.width();
  const QPointF at = picture.state.widgetFromMetres(picture.size).map(toQPointF(point_m)) * ratio;
  return picture.image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
}

class PreviewServiceTest : public QObject {
  Q_OBJECT

 private slots:
  void frameOfAViewAgreesWithTheView() {
    const ViewState state{{3.0, 4.0}, 0.07, 0.9};
    for (const double ratio : {1.0, 2.0, 1.0 / 3.0}) {
      const MapFrame frame = *frameOfView(state, kView, ratio);
      const QTransform widget_from_metres = state.widgetFromMetres(kView);
      for (const QPointF widget : {QPointF(0, 0), QPointF(400, 320), QPointF(123, 45)}) {
        const Vector2d metres = frame.metricFromPixel(toEigen(widget * ratio));
        const QPointF back = widget_from_metres.map(toQPointF(metres));
        QVERIFY(std::hypot(back.x() - widget.x(), back.y() - widget.y()) < 2.0 / ratio * 0.5);
      }
    }
  }

  void layersLandWhereTheProjectorSays_data() {
    QTest::addColumn<bool>("to_blueprint");
    QTest::addColumn<double>("rotation");
    QTest::addColumn<double>("m_per_px");
    QTest::addColumn<double>("ratio");
    for (const bool to_blueprint : {true, false}) {
      for (const double rotation : {0.0, 1.3}) {
        for (const double m_per_px : {0.02, 0.06}) {
          for (const double ratio : {1.0, 2.0}) {
            QTest::addRow("%s %g rad %g m/px x%g", to_blueprint ? "to blueprint" : "to SLAM", rotation, m_per_px, ratio)
                << to_blueprint << rotation << m_per_px << ratio;
          }
        }
      }
    }
  }
  void layersLandWhereTheProjectorSays() {
    QFETCH(bool, to_blueprint);
    QFETCH(double, rotation);
    QFETCH(double, m_per_px);
    QFETCH(double, ratio);
    World world;
    const Vector2d in_blueprint(9.0, 7.0);
    const Vector2d in_slam = kSlamFromBlueprint * in_blueprint;
    const Vector2d seen_at = to_blueprint ? in_blueprint : in_slam;
    if (to_blueprint) {
      World::paintDot(world.slam, world.slam_frame, in_slam);
    } else {
      World::paintDot(world.blueprint, world.blueprint_frame, in_blueprint);
    }
    const auto scene = world.scene(to_blueprint ? WarpDirection::kToBlueprint : WarpDirection::kToSlam);
    const ViewState state{toQPointF(seen_at + Vector2d(1.0, -0.5)), m_per_px, rotation};
    const Result<PreviewPicture> picture = renderPreview(requestFor(scene, PreviewKind::kWarped, state, ratio));
    QVERIFY2(picture.has_value(), picture ? "" : picture.error().message.c_str());
    QVERIFY(qGray(pixelAt(*picture, seen_at)) < 60);
    QCOMPARE(qAlpha(pixelAt(*picture, seen_at)), 255);
    for (const Vector2d& away : {Vector2d(0.7, 0), Vector2d(-0.7, 0), Vector2d(0, 0.7), Vector2d(0, -0.7)}) {
      QVERIFY(qGray(pixelAt(*picture, seen_at + away)) > 200);
    }
  }

  void thinWallsKeepTheirInkHoweverSmall_data() {
    QTest::addColumn<int>("px_per_view_px");
    for (const int count : {1, 2, 3, 4, 6}) QTest::addRow("1 : %d", count) << count;
  }
  void thinWallsKeepTheirInkHoweverSmall() {
    QFETCH(int, px_per_view_px);
    // A hall in grey ground, its wall one pixel wide, as plans of some programs have it.
    World world;
    world.blueprint = cv::Mat(1920, 2400, CV_8UC1, cv::Scalar(125));
    const cv::Rect hall(333, 217, 1501, 1203);
    cv::rectangle(world.blueprint, hall, cv::Scalar(255), cv::FILLED);
    cv::rectangle(world.blueprint, hall, cv::Scalar(0), 1);
    world.blueprint_frame = test::frameOf(world.blueprint, kResolution);
    const auto scene = world.scene(WarpDirection::kToBlueprint);
    const Vector2d on_wall = world.blueprint_frame.metricFromPixel({333.5, 800.5});
    const ViewState state{toQPointF(on_wall), kResolution * px_per_view_px, 0.0};
    const Result<PreviewPicture> picture = renderPreview(requestFor(scene, PreviewKind::kInks, state));
    QVERIFY(picture.has_value());
    const int row = picture->image.height() / 2;
    int darkest = 255;
    int inked = 0;
    for (int column = -8; column < 8; ++column) {
      const int green = qGreen(picture->image.pixel(picture->image.width() / 2 + column, row));
      darkest = std::min(darkest, green);
      inked += green < 230 ? 1 : 0;
    }
    QVERIFY2(darkest < 170, qPrintable(QString::number(darkest)));  // full ink has none of it
    QVERIFY2(inked <= 4, qPrintable(QString::number(inked)));       // and the wall stays a line
  }

  void nothingBeyondTheReachOfTheMesh() {
    const World world;
    const ViewState state{{25.0, 8.0}, 0.05, 0.0};
    const auto picture =
        renderPreview(requestFor(world.scene(WarpDirection::kToBlueprint), PreviewKind::kWarped, state));
    QVERIFY(picture.has_value());
    QCOMPARE(qAlpha(pixelAt(*picture, {18.0, 8.0})), 255);
    QCOMPARE(qAlpha(pixelAt(*picture, {30.0, 8.0})), 0);
    const ViewState far_away{{500.0, 500.0}, 0.05, 0.0};
    const auto empty = renderPreview(requestFor(world.scene(WarpDirection::kToSlam), PreviewKind::kWarped, far_away));
    QVERIFY(empty.has_value());
    QCOMPARE(qAlpha(empty->image.pixel(10, 10)), 0);
  }

  void inksTellAgreement() {
    World world;
    const Vector2d both(5.0, 5.0);
    const Vector2d only_blueprint(9.0, 5.0);
    const Vector2d only_slam(13.0, 5.0);
    for (const Vector2d& point : {both, only_blueprint}) {
      World::paintDot(world.blueprint, world.blueprint_frame, point);
    }
    for (const Vector2d& point : {both, only_slam}) {
      World::paintDot(world.slam, world.slam_frame, kSlamFromBlueprint * point);
    }
    const ViewState state{{9.0, 6.0}, 0.05, 0.0};
    const auto picture = renderPreview(requestFor(world.scene(WarpDirection::kToBlueprint), PreviewKind::kInks, state));
    QVERIFY(picture.has_value());
    const QColor agreed(pixelAt(*picture, both));
    const QColor magenta(pixelAt(*picture, only_blueprint));
    const QColor green(pixelAt(*picture, only_slam));
    QVERIFY(agreed.lightness() < 60);
    QVERIFY(magenta.red() > 180 && magenta.green() < 60);
    QVERIFY(green.green() > 120 && green.red() < 60);
    QCOMPARE(QColor(pixelAt(*picture, {9.0, 9.0})), QColor(255, 255, 255));
  }

  void unknownGroundTakesNoInk() {
    World world;
    world.slam.setTo(205);
    const ViewState state{{9.0, 6.0}, 0.05, 0.0};
    const auto picture = renderPreview(requestFor(world.scene(WarpDirection::kToBlueprint), PreviewKind::kInks, state));
    QVERIFY(picture.has_value());
    QCOMPARE(QColor(pixelAt(*picture, {9.0, 9.0})), QColor(255, 255, 255));
  }

  void aSimilarityIsNeutralOnTheHeatMap_data() {
    QTest::addColumn<bool>("to_blueprint");
    QTest::addColumn<bool>("stretch");
    QTest::newRow("scale on blueprint") << true << true;
    QTest::newRow("turn on blueprint") << true << false;
    QTest::newRow("scale on SLAM map") << false << true;
    QTest::newRow("turn on SLAM map") << false << false;
  }
  void aSimilarityIsNeutralOnTheHeatMap() {
    QFETCH(bool, to_blueprint);
    QFETCH(bool, stretch);
    const World world;
    const Vector2d inside(10.0, 8.0);
    const Vector2d seen_at = to_blueprint ? inside : kSlamFromBlueprint * inside;
    const ViewState state{toQPointF(seen_at), 0.05, 0.3};
    const auto picture =
        renderPreview(requestFor(world.scene(to_blueprint ? WarpDirection::kToBlueprint : WarpDirection::kToSlam),
                                 stretch ? PreviewKind::kStretch : PreviewKind::kRotation, state));
    QVERIFY(picture.has_value());
    const QColor color(pixelAt(*picture, seen_at));
    QVERIFY(std::abs(color.red() - color.blue()) < 40);  // neither blue nor orange
    QCOMPARE(qAlpha(pixelAt(*picture, seen_at)), 255);
    QVERIFY(picture->full_color > 0.0);
  }

  void coverageIsColouredByTheNearestAnchor_data() {
    QTest::addColumn<bool>("to_blueprint");
    QTest::newRow("on blueprint") << true;
    QTest::newRow("on SLAM map") << false;
  }
  void coverageIsColouredByTheNearestAnchor() {
    QFETCH(bool, to_blueprint);
    const World world;
    const auto scene = world.scene(to_blueprint ? WarpDirection::kToBlueprint : WarpDirection::kToSlam);
    auto with_anchors = std::make_shared<PreviewScene>(*scene);
    with_anchors->anchors = {{2.0, 3.0}, {2.0, 12.0}};
    const auto seen = [&](const Vector2d& place) { return to_blueprint ? place : kSlamFromBlueprint * place; };
    const ViewState state{toQPointF(seen({10.0, 8.0})), 0.07, 0.0};
    const auto picture = renderPreview(requestFor(with_anchors, PreviewKind::kCoverage, state));
    QVERIFY(picture.has_value());
    QVERIFY(picture->full_color >= 10.0 && picture->full_color <= 20.0);
    const auto redAt = [&](const Vector2d& place) {
      const QColor color(pixelAt(*picture, seen(place)));
      return color.red() - color.blue();
    };
    QVERIFY(redAt({2.2, 3.1}) < 15);
    QVERIFY(redAt({8.0, 3.0}) > redAt({4.0, 3.0}) + 15);
    QVERIFY(redAt({16.0, 8.0}) > redAt({8.0, 3.0}) + 15);
  }

  void newestRequestWinsAndArrives() {
    const World world;
    PreviewService service;
    QSignalSpy pictures(&service, &PreviewService::pictureReady);
    QSignalSpy idle(&service, &PreviewService::idle);
    service.setScene(world.scene(WarpDirection::kToBlueprint));
    ViewState state{{9.0, 6.0}, 0.05, 0.0};
    for (int i = 0; i < 60; ++i) {
      state.center_m.rx() += 0.01;
      service.request(PreviewKind::kWarped, state, kView, 1.0);
      if (i % 10 == 0) QTest::qWait(1);
    }
    QVERIFY(idle.wait(5000));
    QVERIFY(pictures.size() < 60);
    const auto last = pictures.back()[0].value<PreviewPicture>();
    QVERIFY(last.state == state);
    QCOMPARE(last.image.size(), kView);
  }

  void withoutASceneNothingComes() {
    PreviewService service;
    QSignalSpy pictures(&service, &PreviewService::pictureReady);
    service.request(PreviewKind::kInks, ViewState{}, kView, 1.0);
    const World world;
    service.setScene(world.scene(WarpDirection::kToBlueprint));  // starts: the view is known
    service.setScene(nullptr);
    QTest::qWait(100);
    QCOMPARE(pictures.size(), 0);
    QVERIFY(!service.isBusy());
  }

  void canBeDestroyedWhileDrawing() {
    const World world;
    for (int i = 0; i < 10; ++i) {
      PreviewService service;
      service.setScene(world.scene(WarpDirection::kToSlam));
      service.request(PreviewKind::kInks, ViewState{{3, 3}, 0.01, 0.5}, QSize(1200, 900), 1.0);
      QTest::qWait(i);
    }
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::PreviewServiceTest)
#include "preview_service_test.moc"

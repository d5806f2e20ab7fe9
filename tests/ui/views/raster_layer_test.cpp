// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/raster_layer.h"

#include <QImage>
#include <QPainter>
#include <QRandomGenerator>
#include <QTest>

#include <limits>

#include "ui/support/rasters.h"

namespace cad2slam {
namespace {

QImage drawn(RasterLayer& layer, const QTransform& widget_from_image) {
  QImage picture(320, 240, QImage::Format_RGB32);
  picture.fill(Qt::red);
  QPainter painter(&picture);
  layer.paint(painter, widget_from_image, picture.size(), QColor(90, 90, 90));
  painter.end();
  return picture;
}

/// Drawn again until no coarse tile stands in for one that is still being unpacked.
QImage drawnWhole(RasterLayer& layer, const QTransform& widget_from_image) {
  QImage picture;
  const auto isWhole = [&] {
    layer.refresh();
    picture = drawn(layer, widget_from_image);
    return layer.isComplete();
  };
  return QTest::qWaitFor(isWhole, 60'000) ? picture : QImage();
}

class RasterLayerTest : public QObject {
  Q_OBJECT

 private slots:
  void levelsFollowTheZoom() {
    QCOMPARE(RasterLayer::levelForScale(8.0, 6), 0);
    QCOMPARE(RasterLayer::levelForScale(1.0, 6), 0);
    QCOMPARE(RasterLayer::levelForScale(0.5, 6), 1);
    QCOMPARE(RasterLayer::levelForScale(0.25, 6), 2);
    QCOMPARE(RasterLayer::levelForScale(1e-9, 6), 5);
    QCOMPARE(RasterLayer::levelForScale(0.0, 6), 0);
  }

  /// Files can hold any number: nothing is drawn where the raster cannot be.
  void anyTransformIsSurvived() {
    RasterLayer layer;
    layer.setSource(TilePyramid::fromPixels(test::floorPlan(900, 700)));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double number : {1e12, 1e30, 1e308, -1e308, infinite, nan, 1e-308, 1e-30}) {
      for (const QTransform& transform :
           {QTransform(1, 0, 0, 1, number, 0), QTransform(1, 0, 0, 1, 0, number), QTransform(number, 0, 0, 1, 0, 0),
            QTransform(1, number, 0, 1, 0, 0), QTransform(number, 0, 0, number, 0, 0),
            QTransform(number, 0, 0, number, -number, -number), QTransform(0, number, number, 0, number, 0)}) {
        const QImage picture = drawn(layer, transform);
        QCOMPARE(picture.size(), QSize(320, 240));
        QVERIFY(picture.pixelColor(319, 239) != QColor(Qt::red));  // of the picture that was there before
      }
    }
    const QImage after = drawnWhole(layer, QTransform());
    RasterLayer fresh;
    fresh.setSource(TilePyramid::fromPixels(test::floorPlan(900, 700)));
    QCOMPARE(after, drawnWhole(fresh, QTransform()));
  }

  /// A picture that was shifted strip by strip equals one drawn at once.
  void shiftedPictureEqualsAFreshOne() {
    const std::shared_ptr<TilePyramid> plan = TilePyramid::fromPixels(test::floorPlan(1500, 1200));
    QRandomGenerator random(7);
    for (const double scale : {0.3, 1.0, 3.0}) {
      for (const double angle : {0.0, 25.0}) {
        RasterLayer walker;
        walker.setSource(plan);
        QTransform transform = QTransform().rotate(angle).scale(scale, scale) * QTransform::fromTranslate(-80, -50);
        for (int step = 0; step < 12; ++step) {
          const QPoint shift(random.bounded(-90, 90), random.bounded(-90, 90));
          transform *= QTransform::fromTranslate(shift.x(), shift.y());
          const QImage walked = drawnWhole(walker, transform);
          RasterLayer fresh;
          fresh.setSource(plan);
          const QImage expected = drawnWhole(fresh, transform);
          qint64 difference = 0;
          for (int y = 0; y < walked.height(); ++y) {
            for (int x = 0; x < walked.width(); ++x) {
              difference += std::abs(qGray(walked.pixel(x, y)) - qGray(expected.pixel(x, y))) > 40 ? 1 : 0;
            }
          }
          QVERIFY2(difference < 40, qPrintable(QString::number(difference)));
        }
      }
    }
  }

  /// The memory of pictures is used again, what was in it is not: not after another raster, nor in another size.
  void picturesDoNotShowEarlierOnes() {
    const std::shared_ptr<TilePyramid> plan = TilePyramid::fromPixels(test::floorPlan(900, 700));
    const auto grey = TilePyramid::fromPixels(cv::Mat(900, 900, CV_8UC1, cv::Scalar(120)));
    const auto pictureOf = [](RasterLayer& layer, const QSize& size) {
      QImage picture(size, QImage::Format_RGB32);
      QPainter painter(&picture);
      layer.paint(painter, QTransform::fromScale(0.9, 0.9), size, QColor(90, 90, 90));
      return picture;
    };
    RasterLayer used;
    used.reserve(QSize(200, 100));
    used.setSource(grey);
    for (const QSize& size : {QSize(320, 240), QSize(500, 300), QSize(180, 400), QSize(320, 240)}) {
      QVERIFY(QTest::qWaitFor([&] { return static_cast<void>(pictureOf(used, size)), used.isComplete(); }, 60'000));
      used.setSource(plan);
      RasterLayer fresh;
      fresh.setSource(plan);
      QVERIFY(QTest::qWaitFor(
          [&] {
            used.refresh();
            fresh.refresh();
            const bool same = pictureOf(used, size) == pictureOf(fresh, size);
            return used.isComplete() && fresh.isComplete() && same;
          },
          60'000));
      used.setSource(grey);
    }
  }

  void coarseTilesStandInForMissingOnes() {
    class Late : public RasterSource {
     public:
      explicit Late(std::shared_ptr<TilePyramid> all) : all_(std::move(all)) {}
      QSize size() const override { return all_->size(); }
      int levelCount() const override { return all_->levelCount(); }
      QImage::Format format() const override { return all_->format(); }
      QImage tile(const TileKey& key) override { return key.level >= coarsest_at_hand ? all_->tile(key) : QImage(); }
      QImage pixels(int, const QRect&) override { return {}; }
      int coarsest_at_hand = 2;

     private:
      std::shared_ptr<TilePyramid> all_;
    };
    const auto late = std::make_shared<Late>(TilePyramid::fromPixels(cv::Mat(1000, 1000, CV_8UC1, cv::Scalar(40))));
    RasterLayer layer;
    layer.setSource(late);
    QCOMPARE(qGray(drawn(layer, QTransform()).pixel(100, 100)), 40);
    late->coarsest_at_hand = 9;
    RasterLayer nothing_yet;
    nothing_yet.setSource(late);
    QVERIFY(qGray(drawn(nothing_yet, QTransform()).pixel(100, 100)) > 200);
    late->coarsest_at_hand = 0;
    nothing_yet.refresh();
    QCOMPARE(qGray(drawn(nothing_yet, QTransform()).pixel(100, 100)), 40);
  }

  void backgroundOutsideTheRaster() {
    RasterLayer layer;
    layer.setSource(TilePyramid::fromPixels(cv::Mat(100, 100, CV_8UC1, cv::Scalar(255))));
    const QImage picture = drawnWhole(layer, QTransform::fromTranslate(100, 60));
    QCOMPARE(qGray(picture.pixel(99, 100)), 90);
    QCOMPARE(qGray(picture.pixel(101, 100)), 255);
    QCOMPARE(qGray(picture.pixel(199, 159)), 255);
    QCOMPARE(qGray(picture.pixel(201, 161)), 90);
    const QImage away = drawn(layer, QTransform::fromTranslate(5000, 60));
    QCOMPARE(qGray(away.pixel(10, 10)), 90);
  }

  void coloredRasters() {
    RasterLayer layer;
    layer.setSource(TilePyramid::fromPixels(cv::Mat(500, 500, CV_8UC4, cv::Scalar(200, 20, 10, 255))));
    const QColor color(drawnWhole(layer, QTransform()).pixel(50, 50));
    QCOMPARE(color, QColor(10, 20, 200));
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_MAIN(cad2slam::RasterLayerTest)
#include "raster_layer_test.moc"

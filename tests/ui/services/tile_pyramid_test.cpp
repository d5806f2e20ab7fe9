// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/tile_pyramid.h"

#include <QElapsedTimer>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <opencv2/imgcodecs.hpp>

#include "ui/services/pyramid_builder.h"
#include "ui/support/rasters.h"

namespace cad2slam {
namespace {

cv::Mat noise(int width, int height, int type = CV_8UC1) {
  cv::Mat pixels(height, width, type);
  cv::RNG(11).fill(pixels, cv::RNG::UNIFORM, 0, 256);
  return pixels;
}

class TilePyramidTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir dir_;

  std::filesystem::path written(const char* name, const cv::Mat& pixels, const std::vector<int>& options = {}) {
    const std::filesystem::path path = std::filesystem::path(dir_.path().toStdString()) / name;
    if (!cv::imwrite(path.string(), pixels, options)) throw std::runtime_error("cannot write " + path.string());
    return path;
  }
  static bool waitUntilRead(TilePyramid& pyramid) {
    return QTest::qWaitFor([&] { return pyramid.state() != TilePyramid::State::kLoading; }, 20'000);
  }
  static cv::Mat wholeLevel(const TilePyramid& pyramid, int level) {
    return pyramid.store()->region(level, cv::Rect(0, 0, 1 << 20, 1 << 20), 0);
  }
  static bool equal(const cv::Mat& a, const cv::Mat& b) {
    return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
  }

 private slots:
  void levelsHalveUntilOneTile() {
    QCOMPARE(PyramidBuilder::levelCount(QSize(1, 1)), 1);
    QCOMPARE(PyramidBuilder::levelCount(QSize(256, 256)), 1);
    QCOMPARE(PyramidBuilder::levelCount(QSize(257, 10)), 2);
    QCOMPARE(PyramidBuilder::levelCount(QSize(9253, 7095)), 7);
    const auto pyramid = TilePyramid::fromPixels(noise(1001, 517));
    QCOMPARE(pyramid->levelCount(), 3);
    for (int level = 0; level < pyramid->levelCount(); ++level) {
      const cv::Mat pixels = wholeLevel(*pyramid, level);
      QCOMPARE(QSize(pixels.cols, pixels.rows), pyramid->levelSize(level));
      if (level > 0) QVERIFY(equal(pixels, PyramidBuilder::halved(wholeLevel(*pyramid, level - 1))));
    }
  }

  void thinWallsSurviveReduction() {
    cv::Mat pixels(1024, 1024, CV_8UC1, cv::Scalar(255));
    pixels.col(501).setTo(0);
    const auto pyramid = TilePyramid::fromPixels(pixels);
    for (int level = 0; level < pyramid->levelCount(); ++level) {
      double darkest = 255.0;
      cv::minMaxLoc(wholeLevel(*pyramid, level), &darkest);
      QVERIFY2(darkest < 200.0, qPrintable(QString::number(darkest)));
    }
  }

  void filesGiveTheirPixels_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("type");
    for (const char* name : {"a.png", "a.bmp", "a.tiff", "a.pgm"}) {
      QTest::addRow("grey %s", name) << QString::fromLatin1(name) << CV_8UC1;
    }
    for (const char* name : {"b.png", "b.bmp", "b.tiff", "b.ppm"}) {
      QTest::addRow("colour %s", name) << QString::fromLatin1(name) << CV_8UC3;
    }
  }
  void filesGiveTheirPixels() {
    QFETCH(QString, name);
    QFETCH(int, type);
    const cv::Mat pixels = noise(700, 530, type);
    const auto pyramid = TilePyramid::load(written(name.toUtf8().constData(), pixels));
    QSignalSpy changed(pyramid.get(), &RasterSource::tilesChanged);
    QVERIFY(waitUntilRead(*pyramid));
    QVERIFY2(pyramid->state() == TilePyramid::State::kReady, qPrintable(pyramid->error()));
    QVERIFY(!changed.isEmpty());
    QCOMPARE(pyramid->size(), QSize(700, 530));
    cv::Mat expected = pixels;
    if (type == CV_8UC3) cv::cvtColor(pixels, expected, cv::COLOR_BGR2BGRA);
    QVERIFY(equal(wholeLevel(*pyramid, 0), expected));
    const QImage tile = pyramid->tile({0, 2, 2});
    QCOMPARE(tile.size(), QSize(700 - 512, 530 - 512));
    QCOMPARE(tile.format(), type == CV_8UC1 ? QImage::Format_Grayscale8 : QImage::Format_RGB32);
  }

  void greyInAColourFileTakesOneChannel() {
    cv::Mat pixels;
    cv::cvtColor(noise(600, 300), pixels, cv::COLOR_GRAY2BGR);
    const auto pyramid = TilePyramid::load(written("grey_rgb.png", pixels));
    QVERIFY(waitUntilRead(*pyramid));
    QCOMPARE(pyramid->format(), QImage::Format_Grayscale8);
    pixels.at<cv::Vec3b>(290, 590) = cv::Vec3b(1, 2, 3);  // colour comes late
    const auto colored = TilePyramid::load(written("nearly_grey.png", pixels));
    QVERIFY(waitUntilRead(*colored));
    QCOMPARE(colored->format(), QImage::Format_RGB32);
  }

  /// What was cut as grey is thrown away while its tiles are being unpacked.
  void tilesCanBeAskedForWhileColourTurnsUp() {
    cv::Mat pixels;
    cv::cvtColor(noise(1536, 1536), pixels, cv::COLOR_GRAY2BGR);
    pixels.at<cv::Vec3b>(1530, 1530) = cv::Vec3b(1, 2, 3);
    const std::filesystem::path path = written("late_colour.png", pixels, {cv::IMWRITE_PNG_COMPRESSION, 0});
    for (int round = 0; round < 5; ++round) {
      const auto pyramid = TilePyramid::load(path);
      while (pyramid->state() == TilePyramid::State::kLoading) {
        QCoreApplication::processEvents();
        for (int row = 0; row < 6; ++row)
          for (int column = 0; column < 6; ++column) (void)pyramid->tile({0, column, row});
      }
      QVERIFY(pyramid->state() == TilePyramid::State::kReady);
      QCOMPARE(pyramid->format(), QImage::Format_RGB32);
      QTRY_COMPARE_WITH_TIMEOUT(pyramid->tile({0, 5, 5}).format(), QImage::Format_RGB32, 20'000);
    }
  }

  void transparentIsWhite() {
    cv::Mat pixels(64, 64, CV_8UC4, cv::Scalar(0, 0, 0, 0));
    pixels(cv::Rect(10, 10, 5, 5)).setTo(cv::Scalar(0, 0, 0, 255));
    for (const char* name : {"alpha.png", "alpha.tiff"}) {
      const auto pyramid = TilePyramid::load(written(name, pixels));
      QVERIFY(waitUntilRead(*pyramid));
      const QImage all = pyramid->pixels(0, QRect(0, 0, 64, 64));
      QCOMPARE(qGray(all.pixel(2, 2)), 255);
      QCOMPARE(qGray(all.pixel(12, 12)), 0);
    }
  }

  void sixteenBitsAreNarrowed() {
    cv::Mat pixels(50, 60, CV_16UC1, cv::Scalar(65535));
    pixels.row(0).setTo(257 * 100);
    for (const char* name : {"deep.png", "deep.tiff"}) {
      const auto pyramid = TilePyramid::load(written(name, pixels));
      QVERIFY(waitUntilRead(*pyramid));
      const QImage all = pyramid->pixels(0, QRect(0, 0, 60, 50));
      QVERIFY(std::abs(qGray(all.pixel(5, 0)) - 100) <= 1);
      QCOMPARE(qGray(all.pixel(5, 5)), 255);
    }
  }

  void mirroredSwapsLeftAndRight() {
    const cv::Mat pixels = noise(300, 100);
    const auto pyramid = TilePyramid::load(written("mirror.png", pixels), true);
    QVERIFY(waitUntilRead(*pyramid));
    cv::Mat expected;
    cv::flip(pixels, expected, 1);
    QVERIFY(equal(wholeLevel(*pyramid, 0), expected));
  }

  void badFilesFailWithASentence() {
    const std::filesystem::path good = written("whole.png", noise(400, 400));
    QFile file(QString::fromStdString(good.string()));
    QVERIFY(file.open(QFile::ReadOnly));
    const QByteArray bytes = file.readAll();
    const auto broken = [&](const char* name, const QByteArray& content) {
      const QString path = dir_.filePath(QString::fromLatin1(name));
      QFile out(path);
      if (out.open(QFile::WriteOnly)) out.write(content);
      out.close();
      return std::filesystem::path(path.toStdString());
    };
    QByteArray flipped = bytes;
    for (int i = 200; i < 260; ++i) flipped[i] = static_cast<char>(~flipped[i]);
    const std::vector<std::filesystem::path> files = {dir_.filePath(QStringLiteral("absent.png")).toStdString(),
                                                      broken("cut.png", bytes.left(bytes.size() / 2)),
                                                      broken("flipped.png", flipped),
                                                      broken("empty.png", {}),
                                                      broken("text.png", "hello"),
                                                      broken("head.png", bytes.left(40))};
    for (const std::filesystem::path& path : files) {
      const auto pyramid = TilePyramid::load(path);
      QSignalSpy failed(pyramid.get(), &TilePyramid::failed);
      QVERIFY(waitUntilRead(*pyramid));
      QVERIFY2(pyramid->state() == TilePyramid::State::kFailed, path.c_str());
      QCOMPARE(failed.size(), 1);
      QVERIFY(!pyramid->error().isEmpty());
    }
  }

  void canBeDroppedWhileReading() {
    const std::filesystem::path path = written("large.png", noise(3000, 3000), {cv::IMWRITE_PNG_COMPRESSION, 1});
    for (int i = 0; i < 10; ++i) {
      const auto pyramid = TilePyramid::load(path);
      QTest::qWait(7 * i);
    }
  }

  void tilesComeInTheBackgroundAfterTheBudget() {
    const auto pyramid = TilePyramid::fromPixels(noise(8192, 4096));
    QSignalSpy changed(pyramid.get(), &RasterSource::tilesChanged);
    // Ask for more than may be unpacked at once; whatever was not given must be announced and given later.
    std::vector<TileKey> missing;
    for (int row = 0; row < 8; ++row) {
      for (int column = 0; column < 32; ++column) {
        if (pyramid->tile({0, column, row}).isNull()) missing.push_back({0, column, row});
      }
    }
    if (missing.empty()) QSKIP("this machine unpacks all tiles within the budget");
    QVERIFY(changed.wait(5000));
    QTRY_VERIFY(!pyramid->tile(missing.back()).isNull());
  }

  void memoryIsCapped() {
    TileStore store(QSize(256 * 40, 256 * 40), 1, 1);
    for (int row = 0; row < 40; ++row) {  // 100 MiB that do not shrink
      for (int column = 0; column < 40; ++column) {
        cv::Mat tile(256, 256, CV_8UC1);
        cv::RNG(static_cast<std::uint64_t>(row * 40 + column + 1)).fill(tile, cv::RNG::UNIFORM, 0, 256);
        QVERIFY(store.put({0, column, row}, tile));
      }
    }
    QVERIFY(store.packedBytes() <= TileStore::kPackedBytes);
    QVERIFY(store.spilledBytes() > 0);
    for (int row = 0; row < 40; ++row) {
      for (int column = 0; column < 40; ++column) {
        cv::Mat expected(256, 256, CV_8UC1);
        cv::RNG(static_cast<std::uint64_t>(row * 40 + column + 1)).fill(expected, cv::RNG::UNIFORM, 0, 256);
        QVERIFY(equal(store.get({0, column, row}), expected));
      }
    }
    QVERIFY(store.unpackedBytes() <= store.unpackedLimit());
  }

  void uniformTilesTakeNoRoom() {
    TileStore store(QSize(2560, 2560), 1, 4);
    const cv::Mat tile(256, 256, CV_8UC4, cv::Scalar(1, 2, 3, 255));
    for (int i = 0; i < 10; ++i) QVERIFY(store.put({0, i, 0}, tile));
    QCOMPARE(store.packedBytes(), std::size_t(0));
    QVERIFY(equal(store.get({0, 7, 0}), tile));
    QVERIFY(store.get({0, 7, 1}).empty());
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::TilePyramidTest)
#include "tile_pyramid_test.moc"

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/picture_rows.h"

#include <tiffio.h>
#include <QtTest>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "support/temporary_folder.h"

using namespace cad2slam;

namespace {

constexpr int kWidth = 83;  // no multiple of 8 or 16
constexpr int kHeight = 61;

cv::Mat noise(int type) {
  cv::Mat picture(kHeight, kWidth, type);
  cv::RNG random(7);
  random.fill(picture, cv::RNG::UNIFORM, 0, CV_MAT_DEPTH(type) == CV_8U ? 256 : 65536);
  if (picture.channels() == 4) {  // opaque: programs differ in what they make of the colour of transparent pixels
    cv::Mat opaque(picture.size(), CV_MAKETYPE(picture.depth(), 1), cv::Scalar(picture.depth() == CV_8U ? 255 : 65535));
    cv::insertChannel(opaque, picture, 3);
  }
  return picture;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

/// Strips of changing height, put together.
Result<cv::Mat> readAll(PictureRows& rows) {
  cv::Mat all;
  for (int count = 1;; count = count % 13 + 1) {
    const Result<cv::Mat> piece = rows.read(count);
    if (!piece) return piece;
    if (piece->empty()) return all;
    all.push_back(*piece);
  }
}

struct TiffKind {
  int bits = 8;
  int samples = 1;
  int photometric = PHOTOMETRIC_MINISBLACK;
  int compression = COMPRESSION_LZW;
  int tile = 0;  // [px]; 0: strips
  int rows_per_strip = 5;
  const char* mode = "w";
};

/// Writes samples as they are.
void writeTiff(const std::filesystem::path& path, const TiffKind& kind, const cv::Mat& samples) {
  TIFF* tiff = TIFFOpen(path.c_str(), kind.mode);
  QVERIFY(tiff != nullptr);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, kWidth);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, kHeight);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, kind.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, kind.samples);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, kind.photometric);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, kind.compression);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  if (kind.samples == 2 || kind.samples == 4) {
    const std::uint16_t extra = EXTRASAMPLE_UNASSALPHA;
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &extra);
  }
  if (kind.tile == 0) {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, kind.rows_per_strip);
    for (int row = 0; row < kHeight; ++row)
      QCOMPARE(TIFFWriteScanline(tiff, const_cast<std::uint8_t*>(samples.ptr(row)), static_cast<std::uint32_t>(row), 0),
               1);
  } else {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kind.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, kind.tile);
    const int pixel_bytes = kind.bits / 8 * kind.samples;
    for (int y = 0; y < kHeight; y += kind.tile) {
      for (int x = 0; x < kWidth; x += kind.tile) {
        cv::Mat tile(kind.tile, kind.tile * pixel_bytes, CV_8UC1, cv::Scalar(0));
        const int rows = std::min(kind.tile, kHeight - y);
        const int bytes = std::min(kind.tile, kWidth - x) * pixel_bytes;
        const cv::Mat all(kHeight, kWidth * pixel_bytes, CV_8UC1, samples.data, samples.step);
        all(cv::Rect(x * pixel_bytes, y, bytes, rows)).copyTo(tile(cv::Rect(0, 0, bytes, rows)));
        QVERIFY(TIFFWriteTile(tiff, tile.data, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0) > 0);
      }
    }
  }
  TIFFClose(tiff);
}

}  // namespace

Q_DECLARE_METATYPE(TiffKind)

class PictureRowsTest : public QObject {
  Q_OBJECT

 private slots:
  void rowsAreThoseOfOpenCv_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("type");
    for (const char* name : {"a.png", "a.tif", "a.jpg", "a.pgm", "a.bmp", "a.pbm"})
      QTest::addRow("grey %s", name) << name << CV_8UC1;
    for (const char* name : {"a.png", "a.tif", "a.jpg", "a.ppm", "a.bmp"})
      QTest::addRow("colour %s", name) << name << CV_8UC3;
    for (const char* name : {"a.png", "a.tif"}) QTest::addRow("alpha %s", name) << name << CV_8UC4;
    for (const char* name : {"a.png", "a.tif", "a.pgm"}) QTest::addRow("wide grey %s", name) << name << CV_16UC1;
    for (const char* name : {"a.png", "a.tif", "a.ppm"}) QTest::addRow("wide colour %s", name) << name << CV_16UC3;
    for (const char* name : {"a.png", "a.tif"}) QTest::addRow("wide alpha %s", name) << name << CV_16UC4;
  }
  void rowsAreThoseOfOpenCv() {
    QFETCH(QString, name);
    QFETCH(int, type);
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path(name.toStdString());
    QVERIFY(cv::imwrite(path.string(), noise(type)));
    const Result<std::unique_ptr<PictureRows>> rows = PictureRows::open(path);
    QVERIFY2(rows, rows ? "" : rows.error().sentence().c_str());
    QCOMPARE((*rows)->type(), type);
    const Result<cv::Mat> all = readAll(**rows);
    QVERIFY2(all, all ? "" : all.error().sentence().c_str());
    QVERIFY(same(*all, cv::imread(path.string(), cv::IMREAD_UNCHANGED)));
    QVERIFY((*rows)->read(5)->empty());  // and stays at the end
  }

  void tiffsOfManyKinds_data() {
    QTest::addColumn<TiffKind>("kind");
    QTest::newRow("LZW strips") << TiffKind{};
    QTest::newRow("one strip") << TiffKind{8, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_NONE, 0, kHeight};
    QTest::newRow("deflate tiles") << TiffKind{8, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_ADOBE_DEFLATE, 32};
    QTest::newRow("white is zero") << TiffKind{8, 1, PHOTOMETRIC_MINISWHITE};
    QTest::newRow("colour tiles") << TiffKind{8, 3, PHOTOMETRIC_RGB, COMPRESSION_LZW, 16};
    QTest::newRow("alpha tiles") << TiffKind{8, 4, PHOTOMETRIC_RGB, COMPRESSION_LZW, 64};
    QTest::newRow("wide tiles") << TiffKind{16, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_LZW, 32};
    QTest::newRow("wide colour tiles") << TiffKind{16, 3, PHOTOMETRIC_RGB, COMPRESSION_NONE, 32};
    QTest::newRow("BigTIFF") << TiffKind{8, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_LZW, 0, 5, "w8"};
    QTest::newRow("other byte order") << TiffKind{16, 3, PHOTOMETRIC_RGB, COMPRESSION_LZW, 0, 5, "wb"};
  }
  void tiffsOfManyKinds() {
    QFETCH(TiffKind, kind);
    const test::TemporaryFolder folder;
    const cv::Mat expected = noise(CV_MAKETYPE(kind.bits == 16 ? CV_16U : CV_8U, kind.samples));
    cv::Mat samples = expected.clone();
    if (kind.samples >= 3) cv::mixChannels(expected, samples, {0, 2, 2, 0});  // red first in the file
    if (kind.photometric == PHOTOMETRIC_MINISWHITE) samples = 255 - expected;
    writeTiff(folder.path("a.tif"), kind, samples);
    const Result<std::unique_ptr<PictureRows>> rows = PictureRows::open(folder.path("a.tif"));
    QVERIFY2(rows, rows ? "" : rows.error().sentence().c_str());
    QVERIFY(same(*readAll(**rows), expected));
  }

  void faxPagesAreBlackOnWhite() {
    const test::TemporaryFolder folder;
    const cv::Mat expected = (noise(CV_8UC1) > 127);
    for (const int photometric : {PHOTOMETRIC_MINISWHITE, PHOTOMETRIC_MINISBLACK}) {
      cv::Mat bits(kHeight, (kWidth + 7) / 8, CV_8UC1, cv::Scalar(0));
      for (int row = 0; row < kHeight; ++row) {
        for (int column = 0; column < kWidth; ++column) {
          const bool is_white = expected.at<std::uint8_t>(row, column) != 0;
          if (is_white == (photometric == PHOTOMETRIC_MINISBLACK))
            bits.at<std::uint8_t>(row, column / 8) |= static_cast<std::uint8_t>(0x80 >> column % 8);
        }
      }
      writeTiff(folder.path("a.tif"), {1, 1, photometric, COMPRESSION_CCITTFAX4, 0, kHeight}, bits);
      QVERIFY(same(*readAll(**PictureRows::open(folder.path("a.tif"))), expected));
    }
  }

  void greyWithAlphaBecomesColourWithAlpha() {
    const test::TemporaryFolder folder;
    cv::Mat grey = noise(CV_8UC1);
    cv::Mat alpha;
    cv::flip(grey, alpha, 0);
    cv::Mat samples;
    cv::merge(std::vector<cv::Mat>{grey, alpha}, samples);
    writeTiff(folder.path("a.tif"), {8, 2}, samples);
    const Result<std::unique_ptr<PictureRows>> rows = PictureRows::open(folder.path("a.tif"));
    QVERIFY((*rows)->hasAlpha());
    cv::Mat expected;
    cv::merge(std::vector<cv::Mat>{grey, grey, grey, alpha}, expected);
    QVERIFY(same(*readAll(**rows), expected));
  }

  void whatRowsCannotDoIsDecodedWhole() {
    const test::TemporaryFolder folder;
    const cv::Mat picture = noise(CV_8UC1);
    std::string text = "P2\n" + std::to_string(kWidth) + " " + std::to_string(kHeight) + "\n255\n";
    for (int row = 0; row < kHeight; ++row) {
      for (int column = 0; column < kWidth; ++column)
        text += std::to_string(int{picture.at<std::uint8_t>(row, column)}) + " ";
    }
    QVERIFY(same(*readAll(**PictureRows::open(folder.write("text.pgm", text))), picture));

    writeTiff(folder.path("turned.tif"), {}, picture);
    TIFF* tiff = TIFFOpen(folder.path("turned.tif").c_str(), "r+");
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_BOTRIGHT);
    TIFFRewriteDirectory(tiff);
    TIFFClose(tiff);
    const cv::Mat turned = cv::imread(folder.path("turned.tif").string(), cv::IMREAD_UNCHANGED);
    QVERIFY(same(*readAll(**PictureRows::open(folder.path("turned.tif"))), turned));
  }

  void aDarkestWhiteIsTold() {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.write("a.pgm", std::string("P5 2 1 100\n") + '\x64' + '\x32');
    const Result<std::unique_ptr<PictureRows>> rows = PictureRows::open(path);
    QCOMPARE((*rows)->fullBrightness(), 100U);
    QVERIFY(same(*(*rows)->read(1), cv::Mat(1, 2, CV_8UC1, std::vector<std::uint8_t>{100, 50}.data())));
    QCOMPARE((*PictureRows::open(folder.write("b.pgm", "P5 1 1 65535\n\x01\x02")))->read(1)->at<std::uint16_t>(0, 0),
             std::uint16_t{0x0102});
  }

  /// Whatever is flipped: a sentence or a picture of the size that was announced, never a crash.
  void damageIsAnErrorOrAPicture_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"a.png", "strips.tif", "tiles.tif", "a.jpg", "a.pgm"}) QTest::newRow(name) << name;
  }
  void damageIsAnErrorOrAPicture() {
    QFETCH(QString, name);
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path(name.toStdString());
    const cv::Mat picture = noise(CV_8UC1);
    if (name.endsWith(".tif")) {
      writeTiff(path, {8, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_ADOBE_DEFLATE, name[0] == 't' ? 16 : 0}, picture);
    } else {
      QVERIFY(cv::imwrite(path.string(), picture));
    }
    const std::string good = test::TemporaryFolder::readAll(path);
    int refused = 0;
    for (std::size_t at = 0; at < good.size(); at += 1 + good.size() / 300) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ 0x5a);
      const Result<std::unique_ptr<PictureRows>> rows = PictureRows::open(folder.write("bad", bad));
      const Result<cv::Mat> all = rows ? readAll(**rows) : Result<cv::Mat>(failAs(rows));
      if (all) QCOMPARE(all->size(), cv::Size((*rows)->width(), (*rows)->height()));
      if (!all) QVERIFY(!all.error().message.empty() && !all.error().where.empty());
      if (!all) ++refused;
    }
    QVERIFY2(refused > 0, "no flipped bit was noticed");
    const Result<std::unique_ptr<PictureRows>> short_file =
        PictureRows::open(folder.write("short", good.substr(0, good.size() / 2)));
    QVERIFY(!short_file || !readAll(**short_file));
  }

  void whatIsNotThereIsSaid() {
    const test::TemporaryFolder folder;
    QVERIFY(PictureRows::open(folder.path("none.tif")).error().code == ErrorCode::kNotFound);
    QVERIFY(PictureRows::open(folder.write("a.txt", "no image")).error().code == ErrorCode::kMalformed);
  }
};

QTEST_APPLESS_MAIN(PictureRowsTest)
#include "picture_rows_test.moc"

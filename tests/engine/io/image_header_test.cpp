// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/image_header.h"

#include <opencv2/imgcodecs.hpp>

#include <QtTest>

#include "support/temporary_folder.h"

using namespace cad2slam;

namespace {

cv::Mat picture(int type) {
  cv::Mat image(11, 17, type);
  cv::randu(image, 0, 250);
  return image;
}

std::string littleEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int k = 0; k < bytes; ++k) text += static_cast<char>((value >> (8 * k)) & 0xff);
  return text;
}

}  // namespace

class ImageHeaderTest : public QObject {
  Q_OBJECT

 private slots:
  void everyFormatTellsItsSize_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("type");
    for (const char* name : {"a.png", "a.pgm", "a.bmp", "a.jpg", "a.tif"}) QTest::newRow(name) << name << CV_8UC1;
    for (const char* name : {"c.png", "c.ppm", "c.bmp", "c.jpg", "c.tif"}) QTest::newRow(name) << name << CV_8UC3;
    for (const char* name : {"w.png", "w.pgm", "w.tif"}) QTest::newRow(name) << name << CV_16UC1;
    QTest::newRow("alpha.png") << "alpha.png" << CV_8UC4;
  }
  void everyFormatTellsItsSize() {
    QFETCH(QString, name);
    QFETCH(int, type);
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path(name.toStdString());
    QVERIFY(cv::imwrite(path.string(), picture(type)));
    for (const ImageCheck check : {ImageCheck::kSize, ImageCheck::kWhole}) {
      const Result<ImageHeader> header = readImageHeader(path, check);
      QVERIFY2(header, header ? "" : header.error().sentence().c_str());
      QCOMPARE(header->width_px, std::uint64_t{17});
      QCOMPARE(header->height_px, std::uint64_t{11});
      const bool is_pnm = path.extension() == ".pgm" || path.extension() == ".ppm";
      QCOMPARE(header->format == ImageFormat::kPnm, is_pnm);
      QCOMPARE(header->format == ImageFormat::kPng, path.extension() == ".png");
      QCOMPARE(header->format == ImageFormat::kJpeg, path.extension() == ".jpg");
      QCOMPARE(header->format == ImageFormat::kTiff, path.extension() == ".tif");
      QCOMPARE(header->format == ImageFormat::kBmp, path.extension() == ".bmp");
    }
  }

  void cutAnywhereItIsAnError_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"a.png", "a.pgm", "a.bmp", "a.jpg", "a.ppm"}) QTest::newRow(name) << name;
  }
  void cutAnywhereItIsAnError() {
    QFETCH(QString, name);
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path(name.toStdString());
    QVERIFY(cv::imwrite(path.string(), picture(name == "a.ppm" ? CV_8UC3 : CV_8UC1)));
    const std::string whole = folder.read(name.toStdString());
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const Result<ImageHeader> header =
          readImageHeader(folder.write("cut", whole.substr(0, length)), ImageCheck::kWhole);
      QVERIFY2(!header, std::to_string(length).c_str());
      QVERIFY(header.error().code == ErrorCode::kMalformed);
      QCOMPARE(header.error().where, folder.path("cut").string());
    }
  }

  void damageInAPngIsFound() {
    const test::TemporaryFolder folder;
    QVERIFY(cv::imwrite(folder.path("a.png").string(), picture(CV_8UC1)));
    const std::string whole = folder.read("a.png");
    for (std::size_t at = 0; at < whole.size(); ++at) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 4);
      QVERIFY(!readImageHeader(folder.write("damaged", damaged), ImageCheck::kWhole));
    }
  }

  void anyByteMayChange_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"a.pgm", "a.bmp", "a.jpg", "a.tif", "c.tif"}) QTest::newRow(name) << name;
  }
  void anyByteMayChange() {  // no crash, and nothing beyond the limit passes
    QFETCH(QString, name);
    const test::TemporaryFolder folder;
    QVERIFY(cv::imwrite(folder.path(name.toStdString()).string(), picture(name[0] == 'c' ? CV_8UC3 : CV_8UC1)));
    const std::string whole = folder.read(name.toStdString());
    for (std::size_t at = 0; at < whole.size(); ++at) {
      for (const int change : {1, 0x80, 0xff}) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ change);
        const Result<ImageHeader> header = readImageHeader(folder.write("changed", changed), ImageCheck::kWhole);
        if (header) QVERIFY(header->width_px * header->height_px <= kMostPixels);
      }
    }
  }

  void sizesThatLie_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("word");
    const auto row = [](const char* name, const std::string& bytes, const char* word) {
      QTest::newRow(name) << QByteArray::fromStdString(bytes) << word;
    };
    row("PGM larger than the file", "P5\n30000 30000\n255\n" + std::string(1000, 'x'), "cannot hold");
    row("PGM a little short", "P5\n10 10\n255\n" + std::string(99, 'x'), "cut off");
    row("16-bit PGM short", "P5\n10 10\n65535\n" + std::string(150, 'x'), "cut off");
    row("PGM too large", "P5\n40000 40000\n255\nx", "at most 30000 x 30000");
    row("PGM of nothing", "P5\n0 10\n255\nx", "0 x 10");
    row("PGM overflow", "P5\n99999999999999999999 1\n255\nx", "PNM header");
    row("PGM 2^63", "P5\n9223372036854775807 2\n255\nx", "at most 30000 x 30000");
    row("PGM without maximum", "P5\n2 2\n", "PNM header");
    row("PGM maximum 0", "P5\n2 2\n0\nxxxx", "PNM header");
    row("PGM endless comment", "P5\n#" + std::string(100000, 'x'), "PNM header");
    row("text PGM short", "P2\n3 1\n255\n1 2", "cut off");
    const std::string png_start = std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    row("PNG bomb", png_start + std::string("\0\0\x75\x30\0\0\x75\x30\x08\0\0\0\0", 13) + std::string(500000, '\0'),
        "cut off");
    row("PNG too large", png_start + std::string("\x7f\xff\xff\xff\x7f\xff\xff\xff\x08\0\0\0\0", 13), "at most");
    row("PNG chunk longer than the file",
        png_start + std::string("\0\0\0\x01\0\0\0\x01\x08\0\0\0\0\0\0\0\0\xff\xff\xff\xffIDAT", 25), "");
    row("BMP larger than the file",
        "BM" + std::string(8, '\0') + littleEndian(54, 4) + littleEndian(40, 4) + littleEndian(1000, 4) +
            littleEndian(1000, 4) + littleEndian(1, 2) + littleEndian(8, 2) + littleEndian(0, 4) +
            std::string(5000, '\0'),
        "cut off");
    row("JPEG without frame", "\xff\xd8\xff\xda", "without a frame");
    row("JPEG empty segment", std::string("\xff\xd8\xff\xe0\0\0", 6), "empty JPEG segment");
    row("JPEG padding for ever", "\xff\xd8" + std::string(5000, '\xff'), "cut off");
    row("TIFF directory outside", std::string("II*\0\xff\xff\xff\xff", 8), "cut off");
    row("TIFF endless directory", std::string("II*\0\x08\0\0\0\xff\xff", 10), "too many entries");
    row("BigTIFF directory overflow", "II+" + std::string(5, '\0') + std::string(8, '\xff'), "cut off");
    row("empty", "", "is empty");
    row("text", "hello world", "no image that can be read");
    row("GIF", "GIF89a......", "no image that can be read");
  }
  void sizesThatLie() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, word);
    const test::TemporaryFolder folder;
    const Result<ImageHeader> header = readImageHeader(folder.write("image", bytes.toStdString()), ImageCheck::kWhole);
    QVERIFY(!header);
    QVERIFY(header.error().code == ErrorCode::kMalformed);
    QVERIFY2(QString::fromStdString(header.error().message).contains(word), header.error().message.c_str());
  }

  void theLargestImageIsTaken() {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.write("large.pgm", "P5\n30000 30000\n255\n");
    std::filesystem::resize_file(path, 19 + 900'000'000);  // sparse
    QVERIFY(readImageHeader(path, ImageCheck::kWhole).has_value());
  }

  void brightnessOfPgmIsTold() {
    const test::TemporaryFolder folder;
    const auto of = [&folder](const std::string& bytes) {
      return readImageHeader(folder.write("a.pgm", bytes), ImageCheck::kSize)->full_brightness;
    };
    QCOMPARE(of("P5 # note\n2 1 100\nxx"), 100U);
    QCOMPARE(of("P5\n2 1\n1000\nxxxx"), 1000U);
    QCOMPARE(of("P2\n2 1\n100\n1 2\n"), 0U);  // the decoder stretches 8-bit text
    QCOMPARE(of("P4\n2 1\nx"), 0U);
  }

  void missingFilesAndFolders() {
    const test::TemporaryFolder folder;
    QVERIFY(readImageHeader(folder.path("none"), ImageCheck::kSize).error().code == ErrorCode::kNotFound);
    QVERIFY(readImageHeader(folder.path(), ImageCheck::kSize).error().code == ErrorCode::kUnreadable);
  }
};

QTEST_APPLESS_MAIN(ImageHeaderTest)
#include "image_header_test.moc"

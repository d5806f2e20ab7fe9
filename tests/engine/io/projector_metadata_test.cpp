// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/projector_metadata.h"

#include <QtTest>

#include <limits>

#include "support/projector_samples.h"

using namespace cad2slam;

class ProjectorMetadataTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsWrittenIsRead() {
    ProjectorInfo info = test::sampleProjector(3, 2).info;
    QVERIFY(test::sameInfo(*infoOf(metadataOf(info), "x"), info));
    info.model = "rigid";
    info.weights = BlendWeights::kPaper;
    info.outside = OutsidePolicy::kRigid;
    info.quality.leave_one_out_max_m = std::numeric_limits<double>::quiet_NaN();  // not known
    info.note.clear();
    info.slam.image_sha256.clear();
    QVERIFY(test::sameInfo(*infoOf(metadataOf(info), "x"), info));
    QVERIFY(test::sameInfo(*infoOf(metadataOf(ProjectorInfo{}), "x"), ProjectorInfo{}));
  }

  void newerMinorVersionsMaySayMore() {
    ProjectorMetadata metadata = metadataOf(ProjectorInfo{});
    metadata["version"] = "1.17";
    metadata["colour"] = "blue";
    QVERIFY(infoOf(metadata, "x").has_value());
  }

  void whatIsWrongIsNamed_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");  // null: left out
    QTest::addColumn<QString>("word");
    QTest::newRow("other format") << "format"
                                  << "picture"
                                  << "not a projector file";
    QTest::newRow("no format") << "format" << QString() << "not a projector file";
    QTest::newRow("newer") << "version"
                           << "2.0"
                           << "'2.0'";
    QTest::newRow("no version") << "version" << QString() << "version";
    QTest::newRow("word version") << "version"
                                  << "new"
                                  << "version";
    QTest::newRow("no scale") << "scale" << QString() << "scale is missing";
    QTest::newRow("word scale") << "scale"
                                << "big"
                                << "scale is 'big'";
    QTest::newRow("NaN scale") << "scale"
                               << "nan"
                               << "scale";
    QTest::newRow("infinite radius") << "radius_m"
                                     << "1e999"
                                     << "radius_m";
    QTest::newRow("model") << "model"
                           << "soft"
                           << "model";
    QTest::newRow("weights") << "weights"
                             << "heavy"
                             << "weights";
    QTest::newRow("no outside") << "outside" << QString() << "outside";
    QTest::newRow("negative width") << "slam_width_px"
                                    << "-1"
                                    << "slam_width_px";
    QTest::newRow("too wide") << "slam_width_px"
                              << "9999999999"
                              << "slam_width_px";
    QTest::newRow("hash") << "blueprint_image_sha256"
                          << "abc"
                          << "blueprint_image_sha256";
    QTest::newRow("capital hash") << "blueprint_image_sha256" << QString(64, 'A') << "blueprint_image_sha256";
    QTest::newRow("quality") << "quality_anchor_rms_m"
                             << "good"
                             << "quality_anchor_rms_m";
  }
  void whatIsWrongIsNamed() {
    QFETCH(QString, key);
    QFETCH(QString, value);
    QFETCH(QString, word);
    ProjectorMetadata metadata = metadataOf(ProjectorInfo{});
    metadata.erase(key.toStdString());
    if (!value.isNull()) metadata[key.toStdString()] = value.toStdString();
    const Result<ProjectorInfo> info = infoOf(metadata, "a.c2s");
    QVERIFY(!info);
    QVERIFY(info.error().code == ErrorCode::kMalformed);
    QCOMPARE(info.error().where, std::string("a.c2s"));
    QVERIFY2(QString::fromStdString(info.error().message).contains(word), info.error().message.c_str());
  }
};

QTEST_APPLESS_MAIN(ProjectorMetadataTest)
#include "projector_metadata_test.moc"

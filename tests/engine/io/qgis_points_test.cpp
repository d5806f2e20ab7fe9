// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/qgis_points.h"

#include <QtTest>

#include <cmath>

#include "cad2slam/geometry/pose2.h"

using namespace cad2slam;
using Eigen::Vector2d;

namespace {

const MapFrame& blueprint() {
  static const MapFrame frame = *MapFrame::create(0.05, 800, 400, {{-3.0, 2.0}, 0.0});
  return frame;
}
const MapFrame& slam() {
  static const MapFrame frame = *MapFrame::create(0.1, 600, 500, {{-20.0, -30.0}, 0.3});
  return frame;
}

const std::vector<Vector2d> kPlaces{{1.0, 5.0}, {20.0, 6.0}, {30.0, 20.0}, {4.0, 18.0}, {12.5, 11.0}};

/// A robot's map: turned, shifted, a little bent.
Vector2d slamFromBlueprint(const Vector2d& p) {
  return rotationMatrix(0.4) * p + Vector2d(-5.0, -10.0) + Vector2d(0.2 * std::sin(0.2 * p.y()), 0.0);
}

Vector2d inPicture(const MapFrame& frame, const Vector2d& point) {
  const Vector2d pixel = frame.pixelFromMetric(point);
  return {pixel.x(), -pixel.y()};
}

QString line(const Vector2d& map, const Vector2d& source, int enable = 1) {
  const auto text = [](double number) { return QString::number(number, 'g', 17); };
  return QStringList{text(map.x()),           text(map.y()),       text(source.x()),    text(source.y()),
                     QString::number(enable), QStringLiteral("0"), QStringLiteral("0"), QStringLiteral("0")}
             .join(u',') +
         u'\n';
}

constexpr auto kHeader = "mapX,mapY,sourceX,sourceY,enable,dX,dY,residual\n";

}  // namespace

class QgisPointsTest : public QObject {
  Q_OBJECT
 private slots:
  void findsOutWhichPictureIsWhich_data() {
    QTest::addColumn<bool>("slam_is_source");
    QTest::addColumn<bool>("target_in_pixels");
    QTest::newRow("SLAM map onto a blueprint in metres") << true << false;
    QTest::newRow("SLAM map onto a blueprint without scale") << true << true;
    QTest::newRow("blueprint onto a SLAM map in metres") << false << false;
    QTest::newRow("blueprint onto a SLAM map without scale") << false << true;
  }
  void findsOutWhichPictureIsWhich() {
    QFETCH(bool, slam_is_source);
    QFETCH(bool, target_in_pixels);
    QString text = QStringLiteral("#CRS: LOCAL_CS[\"unknown\"]\n") + QLatin1String(kHeader);
    for (const Vector2d& place : kPlaces) {
      const MapFrame& target_frame = slam_is_source ? blueprint() : slam();
      const Vector2d target = slam_is_source ? place : slamFromBlueprint(place);
      const Vector2d source =
          slam_is_source ? inPicture(slam(), slamFromBlueprint(place)) : inPicture(blueprint(), place);
      text += line(target_in_pixels ? inPicture(target_frame, target) : target, source);
    }
    QVERIFY(looksLikeQgisPoints(text.toStdString()));
    const auto read = parseQgisPoints(text.toStdString(), "plan.points", blueprint(), slam());
    QVERIFY2(read, read ? "" : read.error().sentence().c_str());
    QCOMPARE(read->reading.slam_is_source, slam_is_source);
    QCOMPARE(read->reading.target_in_pixels, target_in_pixels);
    QVERIFY(read->import.rejected.empty());
    QCOMPARE(read->import.anchors.size(), kPlaces.size());
    for (std::size_t k = 0; k < kPlaces.size(); ++k) {
      const Anchor& anchor = read->import.anchors[k];
      QCOMPARE(anchor.id, static_cast<AnchorId>(k + 1));
      QVERIFY((anchor.in_blueprint - kPlaces[k]).norm() < 1e-9);
      QVERIFY((anchor.in_slam - slamFromBlueprint(kPlaces[k])).norm() < 1e-9);
      QVERIFY(anchor.enabled);
    }
  }

  void readsTheOldHeaderAndKeepsDisabledPoints() {
    QString text = QStringLiteral("mapX,mapY,pixelX,pixelY,enable\r\n");
    for (const Vector2d& place : kPlaces) text += line(place, inPicture(slam(), slamFromBlueprint(place)));
    text += line({999.0, 0.0}, {0.0, 0.0}, 0);  // far outside, but switched off
    const auto read = parseQgisPoints("\xef\xbb\xbf" + text.toStdString(), "plan.points", blueprint(), slam());
    QVERIFY(read);
    QCOMPARE(read->import.anchors.size(), kPlaces.size() + 1);
    QVERIFY(!read->import.anchors.back().enabled);
  }

  void badLinesAreNamed() {
    QString text = QLatin1String(kHeader);
    for (const Vector2d& place : kPlaces) text += line(place, inPicture(slam(), slamFromBlueprint(place)));
    text += QStringLiteral("1,2,three,4,1\n1,2\n1,2,3,nan,1\n1,5,3,-4,perhaps\n");
    const auto read = parseQgisPoints(text.toStdString(), "plan.points", blueprint(), slam());
    QVERIFY(read);
    QCOMPARE(read->import.anchors.size(), kPlaces.size());
    QCOMPARE(read->import.rejected.size(), std::size_t{4});
    QCOMPARE(read->import.rejected[0].line, std::size_t{7});
    QCOMPARE(read->import.rejected[2].line, std::size_t{9});
  }

  void refuses_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("empty") << "";
    QTest::newRow("only a header") << kHeader;
    QTest::newRow("other columns") << "id,blueprint_x,blueprint_y,slam_x,slam_y\n1,2,3,4,5\n";
    QTest::newRow("a column is missing") << "mapX,mapY,sourceX,enable\n1,2,3,1\n";
    QTest::newRow("points of other maps") << QLatin1String(kHeader) + line({4.5e6, 5.4e6}, {20000.0, -3.0});
  }
  void refuses() {
    QFETCH(QString, text);
    const auto read = parseQgisPoints(text.toStdString(), "plan.points", blueprint(), slam());
    QVERIFY(!read);
    QVERIFY(read.error().sentence().find("plan.points") != std::string::npos);
  }
};

QTEST_GUILESS_MAIN(QgisPointsTest)
#include "qgis_points_test.moc"

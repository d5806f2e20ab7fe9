// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
//
// Draws the views in their main states into PNG files (folder `pictures` beside the program) to be looked at, and
// checks that none is blank.
#include <set>

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QStyleFactory>
#include <QTest>

#include <Eigen/LU>

#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/mesh/mesh_builder.h"
#include "cad2slam/projection/make_projector.h"
#include "cad2slam/solver/mesh_solver.h"
#include "ui/convert.h"
#include "ui/services/preview_renderer.h"
#include "ui/support/rasters.h"
#include "ui/views/icons.h"
#include "ui/views/preview_view.h"

namespace cad2slam {
namespace {

/// A real building, solved.
struct Site {
  MapFrame blueprint_frame;
  MapFrame slam_frame;
  std::shared_ptr<TilePyramid> blueprint;
  std::shared_ptr<TilePyramid> slam;
  AnchorList anchors;
  std::shared_ptr<const Mesh> mesh;
  Solution solution;
  Projector projector;
};

std::optional<Site> solvedSite(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(CAD2SLAM_SHARED_DATA) / name;
  if (!std::filesystem::exists(folder)) return std::nullopt;
  const Result<LoadedMap> blueprint = loadMap(folder / "blueprint.yaml");
  const Result<MapYaml> slam = readMapYaml(folder / "slam.yaml");
  const Result<AnchorImport> anchors = readAnchorsCsv(folder / "anchors.csv");
  if (!blueprint || !slam || !anchors) return std::nullopt;
  Result<Mesh> mesh = buildMesh(blueprint->grid, std::nullopt);
  if (!mesh) return std::nullopt;
  auto shared = std::make_shared<const Mesh>(std::move(*mesh));
  MeshSolver solver(shared);
  Result<Solution> solution = solver.solve(anchors->anchors, defaultSettings(Model::kStretch));
  if (!solution) return std::nullopt;
  Result<Projector> projector = makeProjector(*shared, *solution);
  const Result<MapFrame> slam_frame = readMapFrame(slam->metadata);
  if (!projector || !slam_frame) return std::nullopt;
  Site site{blueprint->grid.frame(),
            *slam_frame,
            TilePyramid::load(blueprint->metadata.image),
            TilePyramid::load(slam->metadata.image),
            anchors->anchors,
            shared,
            std::move(*solution),
            std::move(*projector)};
  const bool read = QTest::qWaitFor(
      [&] {
        return site.blueprint->state() != TilePyramid::State::kLoading &&
               site.slam->state() != TilePyramid::State::kLoading;
      },
      30'000);
  if (!read) return std::nullopt;
  return site;
}

std::shared_ptr<MeshOverlay> overlayOf(const Site& site, bool in_slam) {
  auto overlay = std::make_shared<MeshOverlay>();
  const auto& rest = site.mesh->centers();
  for (std::size_t i = 0; i < rest.size(); ++i) {
    overlay->nodes_m.push_back(toQPointF(in_slam ? site.solution.node_slam[i].translation : rest[i]));
    if (site.projector.jacobian(rest[i]).determinant() <= 0.0) overlay->folds.push_back(static_cast<std::uint32_t>(i));
  }
  for (const MeshEdge& edge : site.mesh->edges()) {
    overlay->edges.push_back({edge.from, edge.to});
    const double length =
        (site.solution.node_slam[edge.to].translation - site.solution.node_slam[edge.from].translation).norm();
    overlay->strain.push_back(
        static_cast<float>(length / (site.solution.global_fit.scale * (rest[edge.to] - rest[edge.from]).norm()) - 1.0));
  }
  return overlay;
}

std::vector<Marker> markersOf(const Site& site, bool in_slam) {
  std::vector<Marker> markers;
  for (std::size_t i = 0; i < site.anchors.size(); ++i) {
    Marker marker;
    marker.id = site.anchors[i].id;
    marker.text = QString::number(marker.id);
    marker.point_m = toQPointF(in_slam ? site.anchors[i].in_slam : site.anchors[i].in_blueprint);
    const double error = site.solution.anchors[i].leave_one_out_m;
    marker.judged = error < 0.1 ? MarkerClass::kOk : error < 0.25 ? MarkerClass::kLook : MarkerClass::kBad;
    marker.selected = i == 3;
    marker.snapped = i % 5 == 0;
    markers.push_back(marker);
  }
  return markers;
}

void saveAndCheck(QWidget& widget, const QString& name) {
  const QDir folder(QCoreApplication::applicationDirPath() + QStringLiteral("/pictures"));
  QVERIFY(QDir().mkpath(folder.path()));
  const QImage image = widget.grab().toImage();
  QVERIFY(image.save(folder.filePath(name + QStringLiteral(".png"))));
  std::set<QRgb> colors;
  for (int y = 0; y < image.height(); y += 3) {
    for (int x = 0; x < image.width(); x += 3) colors.insert(image.pixel(x, y));
  }
  QVERIFY2(colors.size() > 8, qPrintable(name));
}

void showSized(QWidget& widget, const QSize& size) {
  widget.resize(size);
  widget.show();
  QVERIFY(QTest::qWaitForWindowExposed(&widget));
}

class ViewPicturesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion"))); }

  void everyKindOfMark() {
    const cv::Mat plan = test::floorPlan(1200, 900);
    MapView view;
    const MapFrame frame = test::frameOf(plan, 0.05);
    view.setImage(TilePyramid::fromPixels(plan));
    view.setFrame(frame);
    showSized(view, {900, 640});
    view.fit();
    std::vector<Marker> markers;
    const MarkerClass classes[] = {MarkerClass::kPlain, MarkerClass::kOk,      MarkerClass::kLook,
                                   MarkerClass::kBad,   MarkerClass::kPending, MarkerClass::kDisabled};
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 6; ++column) {
        Marker marker;
        marker.id = row * 6 + column + 1;
        marker.text = QString::number(marker.id);
        marker.point_m = QPointF(4.0 + 6.0 * column, 40.0 - 5.0 * row);
        marker.judged = classes[column];
        marker.selected = row == 1;
        marker.snapped = row == 2;
        markers.push_back(marker);
      }
    }
    view.setMarkers(markers);
    view.setHighlighted(2);
    view.setGhost(Ghost{{20.2, 20.2}, 1.6, QStringLiteral("19? Enter accepts")});
    view.setResiduals({{{30, 20}, {30.3, 20.2}, MarkerClass::kOk},
                       {{36, 20}, {36.5, 19.6}, MarkerClass::kLook},
                       {{42, 20}, {41.6, 20.8}, MarkerClass::kBad}},
                      10.0);
    PoseGlyph test_pose;
    test_pose.id = 500;
    test_pose.point_m = {8.0, 10.0};
    test_pose.heading_rad = 0.6;
    test_pose.radius_m = 0.7;
    test_pose.color = QColor(0x6a, 0x2f, 0xb5);
    test_pose.text = QStringLiteral("test pose");
    test_pose.turnable = true;
    PoseGlyph outside = test_pose;
    outside.id = 501;
    outside.point_m = {16.0, 10.0};
    outside.turnable = false;
    outside.hollow = true;
    outside.text = QStringLiteral("extrapolated");
    view.setPoses({test_pose, outside});
    PathGlyph path;
    path.points_m = {{22, 6}, {28, 12}, {34, 12}, {40, 6}, {50, 8}};
    path.color = QColor(0xd9, 0x7a, 0x00);
    path.text = QStringLiteral("27.4 m");
    view.setPaths({path});
    view.setMirroredCursor(QPointF(52, 30));
    view.setAttention(QStringLiteral("Now click the same place here (Esc cancels)"), true);
    saveAndCheck(view, QStringLiteral("marks"));
    view.setAttention({}, false);
    view.setRotation(0.5);
    view.setFocus();
    QTest::mouseMove(&view, QPoint(455, 300));
    QTest::keyClick(&view, Qt::Key_L);
    saveAndCheck(view, QStringLiteral("loupe_turned"));
  }

  void emptyView() {
    MapView view;
    view.setEmptyText(
        QStringLiteral("Drop a blueprint here (PNG, JPG, TIFF or map.yaml), or choose one from the menu"));
    showSized(view, {500, 360});
    saveAndCheck(view, QStringLiteral("empty"));
  }

  void icons() {
    class Sheet : public QWidget {
     public:
      QStringList names;
      QIcon::Mode mode = QIcon::Normal;

     protected:
      void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.fillRect(rect(), palette().color(QPalette::Button));
        painter.setPen(palette().color(QPalette::ButtonText));
        for (int i = 0; i < names.size(); ++i) {
          const int x = (i % 10) * 84;
          const int y = (i / 10) * 76;
          icon(names[i]).paint(&painter, QRect(x + 14, y + 6, 24, 24), Qt::AlignCenter, mode);
          icon(names[i]).paint(&painter, QRect(x + 44, y + 2, 32, 32), Qt::AlignCenter, QIcon::Disabled);
          painter.drawText(QRect(x, y + 42, 84, 24), Qt::AlignHCenter, names[i]);
        }
      }
    };
    QVERIFY(icon(QStringLiteral("no such icon")).isNull());
    QVERIFY(!icon(QStringLiteral("add")).isNull());
    Sheet sheet;
    for (const QString& file : QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")})) {
      sheet.names << file.chopped(4);
    }
    QVERIFY(sheet.names.size() >= 40);
    QFont font = sheet.font();
    font.setPointSizeF(7.5);
    sheet.setFont(font);
    showSized(sheet, {840, 460});
    saveAndCheck(sheet, QStringLiteral("icons_light"));
    const QPalette light = QApplication::palette();
    QPalette dark(QColor(52, 54, 58), QColor(38, 40, 43));
    dark.setColor(QPalette::Disabled, QPalette::ButtonText, QColor(130, 130, 130));
    QApplication::setPalette(dark);
    sheet.setPalette(dark);
    saveAndCheck(sheet, QStringLiteral("icons_dark"));
    QApplication::setPalette(light);
  }

  void previewsOfRealBuildings_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("diag") << QStringLiteral("diag");
    QTest::newRow("eiii-0") << QStringLiteral("eiii-0");
  }
  void previewsOfRealBuildings() {
    QFETCH(QString, name);
    const std::optional<Site> site = solvedSite(name.toStdString());
    if (!site) QSKIP("the shared maps are not here");
    for (const bool blueprint_below : {true, false}) {
      auto scene = std::make_shared<PreviewScene>();
      const PreviewRaster plan{site->blueprint->store(), site->blueprint_frame};
      const PreviewRaster map{site->slam->store(), site->slam_frame};
      scene->direction = blueprint_below ? WarpDirection::kToBlueprint : WarpDirection::kToSlam;
      scene->base = blueprint_below ? plan : map;
      scene->base_ink = QColor(0xe0, 0x00, 0x84);
      scene->layers.push_back({blueprint_below ? map : plan, site->projector, QColor(0x00, 0x9a, 0x44)});
      PreviewView view;
      view.setImage(blueprint_below ? site->blueprint : site->slam);
      view.setFrame(blueprint_below ? site->blueprint_frame : site->slam_frame);
      view.setInks({{scene->base_ink, QStringLiteral("Blueprint")}, {scene->layers[0].ink, QStringLiteral("Robot 1")}});
      showSized(view, {900, 600});
      view.fit();
      for (int mode = 0; mode < kPreviewModeCount; ++mode) {
        view.setMode(static_cast<PreviewMode>(mode));
        const Result<PreviewPicture> picture = renderPreview(
            {scene, previewKind(view.mode()), view.viewState(), view.size() + QSize(80, 60), view.devicePixelRatioF()});
        QVERIFY2(picture.has_value(), picture ? "" : picture.error().message.c_str());
        qInfo("%s %s mode %d: %.0f ms", qPrintable(name), blueprint_below ? "on blueprint" : "on SLAM map", mode,
              picture->seconds * 1e3);
        view.setPicture(*picture);
        const bool with_mesh = view.mode() == PreviewMode::kMesh;
        const std::shared_ptr<MeshOverlay> mesh = with_mesh ? overlayOf(*site, !blueprint_below) : nullptr;
        view.setMesh(mesh);
        view.setMarkers(view.mode() == PreviewMode::kResiduals ? markersOf(*site, !blueprint_below)
                                                               : std::vector<Marker>());
        QTest::mouseMove(&view, QPoint(430 + mode, 300));
        if (with_mesh) {
          view.grab();
          QTest::qWait(300);  // the mesh is drawn by a worker
        }
        saveAndCheck(view, QStringLiteral("%1_%2_%3")
                               .arg(name, blueprint_below ? QStringLiteral("blueprint") : QStringLiteral("slam"))
                               .arg(mode));
      }
    }
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_MAIN(cad2slam::ViewPicturesTest)
#include "view_pictures_test.moc"

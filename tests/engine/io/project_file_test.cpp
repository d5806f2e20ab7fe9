// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/project_file.h"

#include <nlohmann/json.hpp>

#include <QtTest>

#include <limits>

#include "support/temporary_folder.h"

using namespace cad2slam;
using nlohmann::json;

namespace {

ProjectRaster rasterAt(const std::filesystem::path& image) {
  ProjectRaster raster;
  raster.metadata.image = image;
  raster.metadata.yaml = std::filesystem::path(image).replace_extension(".yaml");
  raster.metadata.resolution_m_per_px = 1.0 / 3.0;
  raster.metadata.metric_from_corner = {{-1.5, 2e-9}, 0.25};
  raster.metadata.occupied_threshold = 0.7;
  raster.metadata.free_threshold = 0.1;
  raster.metadata.negate = true;
  raster.metadata.mode = MapMode::kScale;
  raster.image_bytes = 1234567890123;
  raster.image_sha256 = std::string(64, 'b');
  return raster;
}

Project sampleProject() {
  Project project;
  project.name = "T\xc3\xbcr \"3\"";
  project.app_version = "0.1.0";
  project.blueprint = rasterAt("/sites/one/plan/eg.png");
  ProjectSlamMap first;
  first.name = "robot 1";
  first.raster = rasterAt("/sites/one/robot1.pgm");
  first.anchors = {{7, {0.1, 0.2}, {1.0 / 3.0, -4.0}, true, "door", "left\npost"}, {3, {5, 6}, {7, 8}, false, "", ""}};
  first.pending = PendingAnchor{false, 1.5, -2.5};
  ProjectSlamMap second;
  second.name = "robot 2";
  second.raster = rasterAt("/other/place/map.png");
  second.raster.metadata.yaml.clear();
  project.slam_maps = {first, second};
  project.settings.model = Model::kRigid;
  project.settings.scale = {ScaleRule::kFixed, 1.02};
  project.settings.lambda_theta = 42.0;
  project.settings.max_iterations = 17;
  project.cell_size_m = 0.75;
  project.view_state_json = R"({"zoom":1.5})";
  return project;
}

bool sameRaster(const ProjectRaster& a, const ProjectRaster& b) {
  const MapMetadata& p = a.metadata;
  const MapMetadata& q = b.metadata;
  return p.image == q.image && p.yaml == q.yaml && p.resolution_m_per_px == q.resolution_m_per_px &&
         p.metric_from_corner.translation == q.metric_from_corner.translation &&
         p.metric_from_corner.heading == q.metric_from_corner.heading && p.occupied_threshold == q.occupied_threshold &&
         p.free_threshold == q.free_threshold && p.negate == q.negate && p.mode == q.mode &&
         a.image_bytes == b.image_bytes && a.image_sha256 == b.image_sha256;
}

bool sameMap(const ProjectSlamMap& a, const ProjectSlamMap& b) {
  const bool same_pending = a.pending.has_value() == b.pending.has_value() &&
                            (!a.pending || (a.pending->in_blueprint == b.pending->in_blueprint &&
                                            a.pending->x_m == b.pending->x_m && a.pending->y_m == b.pending->y_m));
  return a.name == b.name && sameRaster(a.raster, b.raster) && a.anchors == b.anchors && same_pending;
}

bool sameProject(const Project& a, const Project& b) {
  return a.name == b.name && a.app_version == b.app_version && sameRaster(a.blueprint, b.blueprint) &&
         std::equal(a.slam_maps.begin(), a.slam_maps.end(), b.slam_maps.begin(), b.slam_maps.end(), sameMap) &&
         a.settings.model == b.settings.model && a.settings.scale.rule == b.settings.scale.rule &&
         a.settings.scale.fixed_scale == b.settings.scale.fixed_scale &&
         a.settings.lambda_theta == b.settings.lambda_theta && a.settings.loss_width_m == b.settings.loss_width_m &&
         a.settings.max_iterations == b.settings.max_iterations && a.settings.lambda_y == b.settings.lambda_y &&
         a.cell_size_m == b.cell_size_m && a.view_state_json == b.view_state_json;
}

const std::filesystem::path kPath = "/sites/one/site.c2sproj";

json sampleDocument() {
  return json::parse(formatProject(sampleProject(), kPath));
}

}  // namespace

class ProjectFileTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsWrittenIsRead() {
    const Project project = sampleProject();
    const std::string text = formatProject(project, kPath);
    const Result<Project> read = parseProject(text, kPath);
    QVERIFY2(read, read ? "" : read.error().sentence().c_str());
    QVERIFY(sameProject(*read, project));
    QCOMPARE(formatProject(*read, kPath), text);
    QCOMPARE(formatProject(project, kPath), text);
    const Result<Project> empty = parseProject(formatProject({}, kPath), kPath);
    QVERIFY(sameProject(*empty, {}));
  }

  void aFolderMayMove() {
    const json document = sampleDocument();
    QCOMPARE(document["blueprint"]["image"].get<std::string>(), std::string("plan/eg.png"));
    QCOMPARE(document["slam_maps"][0]["raster"]["yaml"].get<std::string>(), std::string("robot1.yaml"));
    QCOMPARE(document["slam_maps"][1]["raster"]["image"].get<std::string>(), std::string("/other/place/map.png"));
    const Result<Project> moved = parseProject(document.dump(), "/new/home/site.c2sproj");
    QCOMPARE(moved->blueprint.metadata.image.string(), std::string("/new/home/plan/eg.png"));
    QCOMPARE(moved->slam_maps[1].raster.metadata.image.string(), std::string("/other/place/map.png"));
    const Result<Project> here = parseProject(document.dump(), "site.c2sproj");
    QCOMPARE(here->blueprint.metadata.image, std::filesystem::current_path() / "plan/eg.png");
  }

  void unknownKeysSurvive() {
    json document = sampleDocument();
    document["future"] = {{"deep", {1, 2, {{"x", nullptr}}}}};
    document["blueprint"]["colour"] = "blue";
    document["solver"]["lambda_new"] = 3;
    document["slam_maps"][1]["battery"] = true;
    document["slam_maps"][0]["anchors"][1]["photo"] = "a.jpg";
    document["slam_maps"][0]["pending"]["since"] = 5;
    Result<Project> project = parseProject(document.dump(), kPath);
    QVERIFY2(project, project ? "" : project.error().sentence().c_str());
    QVERIFY(json::parse(formatProject(*project, kPath)) == document);
    // They stay with the map and the anchor they belong to, whatever moved meanwhile, and go with them.
    std::swap(project->slam_maps[0], project->slam_maps[1]);
    project->slam_maps[1].anchors.erase(project->slam_maps[1].anchors.begin());
    project->name = "renamed";
    const json saved = json::parse(formatProject(*project, kPath));
    QCOMPARE(saved["slam_maps"][0]["battery"], json(true));
    QVERIFY(!saved["slam_maps"][1].contains("battery"));
    QCOMPARE(saved["slam_maps"][1]["anchors"][0]["photo"], json("a.jpg"));
    QCOMPARE(saved["future"], document["future"]);
    project->slam_maps.erase(project->slam_maps.begin());
    QVERIFY(formatProject(*project, kPath).find("battery") == std::string::npos);
  }

  void whatIsWrongIsNamed_data() {
    QTest::addColumn<QString>("place");  // JSON pointer
    QTest::addColumn<QString>("value");  // JSON; null: left out
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* place, const char* value, const char* sentence) {
      QTest::addRow("%s = %s", place, value == nullptr ? "nothing" : value)
          << place << (value == nullptr ? QString() : QString(value)) << sentence;
    };
    row("/format", "\"other\"", "is not a project of CAD2SLAM");
    row("/version", "2", "was written by a newer program (format 2); this one reads format 1");
    row("/version", nullptr, "version is missing");
    row("/version", "\"1\"", "version must be a whole number in its range");
    row("/version", "0", "version must be a whole number in its range");
    row("/name", "7", "name must be a text");
    row("/blueprint", nullptr, "blueprint is missing");
    row("/blueprint", "[]", "blueprint must be an object");
    row("/blueprint/image", nullptr, "blueprint.image is missing");
    row("/blueprint/image", "\"a\\u0000b\"", "blueprint.image is no file name");
    row("/blueprint/resolution_m_per_px", "0", "blueprint.resolution_m_per_px must be a finite number in its range");
    row("/blueprint/origin", "[1, 2]", "blueprint.origin must be a list of three numbers: x, y, yaw");
    row("/blueprint/origin/2", "null", "blueprint.origin[2] must be a finite number in its range");
    row("/blueprint/free_thresh", "0.9", "blueprint.free_thresh must not be above occupied_thresh");
    row("/blueprint/mode", "\"Raw\"", "blueprint.mode is not one of the words known here");
    row("/blueprint/image_bytes", "-1", "blueprint.image_bytes must be a whole number in its range");
    row("/blueprint/image_sha256", "\"12\"", "blueprint.image_sha256 must be 64 hexadecimal digits");
    row("/slam_maps", nullptr, "slam_maps is missing");
    row("/slam_maps", "{}", "slam_maps must be a list");
    row("/slam_maps/1", "3", "slam_maps[1] must be an object");
    row("/slam_maps/1/name", "\"\"", "slam_maps[1].name must not be empty");
    row("/slam_maps/1/name", "\"robot 1\"", "slam_maps[1].name is the name of another map, too: 'robot 1'");
    row("/slam_maps/0/anchors/1/id", "7", "slam_maps[0].anchors[1].id stands twice: 7");
    for (const char* id : {"-1", "-100", "9007199254740993", "9223372036854775807"})
      row("/slam_maps/0/anchors/1/id", id, "slam_maps[0].anchors[1].id must be a whole number in its range");
    row("/slam_maps/0/anchors/1/id", "1.5", "slam_maps[0].anchors[1].id must be a whole number in its range");
    row("/slam_maps/0/anchors/1/slam", "[1]", "slam_maps[0].anchors[1].slam must be a list of two numbers");
    row("/slam_maps/0/anchors/1/slam/1", "\"1\"",
        "slam_maps[0].anchors[1].slam[1] must be a finite number in its range");
    row("/slam_maps/0/anchors/0/enabled", "1", "slam_maps[0].anchors[0].enabled must be true or false");
    row("/slam_maps/0/pending/frame", "\"moon\"", "slam_maps[0].pending.frame is not one of the words known here");
    row("/slam_maps/0/pending/point", nullptr, "slam_maps[0].pending.point is missing");
    row("/solver/model", "\"soft\"", "solver.model is not one of the words known here");
    row("/solver/lambda_x", "-1", "solver.lambda_x must be a finite number in its range");
    row("/solver/max_iterations", "1e3", "solver.max_iterations must be a whole number in its range");
    row("/cell_size_m", "0", "cell_size_m must be a finite number in its range");
    row("/view", "[]", "view must be an object");
  }
  void whatIsWrongIsNamed() {
    QFETCH(QString, place);
    QFETCH(QString, value);
    QFETCH(QString, sentence);
    json document = sampleDocument();
    const json::json_pointer pointer(place.toStdString());
    if (value.isNull()) {
      document[pointer.parent_pointer()].erase(pointer.back());
    } else {
      document[pointer] = json::parse(value.toStdString());
    }
    const Result<Project> project = parseProject(document.dump(), "site.c2sproj");
    QVERIFY(!project);
    QVERIFY(project.error().code == ErrorCode::kMalformed);
    QCOMPARE(QString::fromStdString(project.error().message), sentence);
    QCOMPARE(project.error().where, std::string("site.c2sproj"));
  }

  void olderFilesMayLackWhatHasADefault() {
    json document = sampleDocument();
    for (const char* key : {"name", "app_version", "cell_size_m", "solver", "view"}) document.erase(key);
    document["slam_maps"][0].erase("anchors");
    document["slam_maps"][0].erase("pending");
    const Result<Project> project = parseProject(document.dump(), kPath);
    QVERIFY2(project, project ? "" : project.error().sentence().c_str());
    QVERIFY(project->slam_maps[0].anchors.empty());
    QVERIFY(!project->cell_size_m);
    QCOMPARE(project->view_state_json, std::string("{}"));
  }

  void cutAnywhereItIsAnError() {
    const std::string text = formatProject(sampleProject(), kPath);
    for (std::size_t length = 0; length + 1 < text.size(); ++length) {  // the last line end may go
      const Result<Project> project = parseProject(text.substr(0, length), kPath);
      QVERIFY(!project);
      QVERIFY(project.error().where.rfind(kPath.string(), 0) == 0);
    }
  }

  void hostileDocuments() {
    QVERIFY(!parseProject(std::string(9 << 20, ' '), kPath));
    QVERIFY(!parseProject(std::string(1 << 20, '['), kPath));
    QVERIFY(!parseProject(R"({"format":"cad2slam-project","format":"cad2slam-project"})", kPath));
    json many = sampleDocument();  // unknown keys by the hundred thousand must not take quadratic time
    for (int k = 0; k < 200000; ++k) many[std::to_string(k) + "k"] = k;
    const Result<Project> project = parseProject(many.dump(), kPath);
    QVERIFY(project.has_value());
    QVERIFY(json::parse(formatProject(*project, kPath)) == many);
  }

  void savingKeepsTheOldFileWhenItCannot() {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path("a.c2sproj");
    QVERIFY(writeProject(path, sampleProject()).has_value());
    const std::string saved = folder.read("a.c2sproj");
    QVERIFY(sameProject(*readProject(path), sampleProject()));
    Project broken = sampleProject();
    broken.slam_maps[0].anchors[0].in_slam.x() = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(writeProject(path, broken).error().code == ErrorCode::kUnwritable);
    broken = sampleProject();
    broken.slam_maps[1].name = broken.slam_maps[0].name;
    QVERIFY(!writeProject(path, broken));
    broken = sampleProject();
    broken.blueprint.metadata.image = "/sites/T\xfcr.png";  // a name that JSON cannot hold
    QVERIFY(writeProject(path, broken).error().message.find("UTF-8") != std::string::npos);
    QCOMPARE(folder.read("a.c2sproj"), saved);
    QVERIFY(readProject(folder.path("none.c2sproj")).error().code == ErrorCode::kNotFound);
    QVERIFY(readProject(folder.path()).error().code == ErrorCode::kUnreadable);
  }

  void changedImagesAreRecognised() {
    const test::TemporaryFolder folder;
    MapMetadata metadata;
    metadata.image = folder.write("a.png", "first");
    const Result<ProjectRaster> raster = describeRaster(metadata);
    QCOMPARE(raster->image_bytes, std::uintmax_t{5});
    QVERIFY(checkRaster(*raster) == RasterState::kUnchanged);
    folder.write("a.png", "other");
    QVERIFY(checkRaster(*raster) == RasterState::kChanged);
    folder.write("a.png", "longer");
    QVERIFY(checkRaster(*raster) == RasterState::kChanged);
    std::filesystem::remove(metadata.image);
    QVERIFY(checkRaster(*raster) == RasterState::kMissing);
    QVERIFY(describeRaster(metadata).error().code == ErrorCode::kNotFound);
    ProjectRaster never_described;
    never_described.metadata.image = folder.write("b.png", "x");
    QVERIFY(checkRaster(never_described) == RasterState::kUnchanged);
  }
};

QTEST_APPLESS_MAIN(ProjectFileTest)
#include "project_file_test.moc"

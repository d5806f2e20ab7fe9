// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/test_poses.h"

#include "ui/convert.h"
#include "ui/engine_sentences.h"
#include "ui/models/number_text.h"
#include "ui/services/guarded.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace cad2slam {
namespace {

constexpr double kRobotRadius = 0.3;               // [m]
constexpr std::size_t kLargestPoseCount = 20'000;  // more would only be ink
const QColor kRobotColor(0xe0, 0x5a, 0x00);
const QColor kGoalColor(0x2e, 0x7d, 0x32);
const QColor kLoadedColor(0x6a, 0x1b, 0x9a);

}  // namespace

struct TestPoses::PlanRequest {
  std::shared_ptr<const OccupancyGrid> grid;
  Eigen::Vector2d start;
  Eigen::Vector2d goal;
  bool interim = false;
};

struct TestPoses::Planned {
  Result<PlannedPath> path;
  bool interim = false;
};

TestPoses::TestPoses(Session& session, QObject* parent) : QObject(parent), session_(session) {
  planner_ = std::make_unique<LatestJob<PlanRequest, Planned>>(
      [](const PlanRequest& request) {
        return Planned{guarded([&] { return planPath(*request.grid, request.start, request.goal); }), request.interim};
      },
      [this](const Planned& planned) { showPath(planned); });
  connect(&session_.alignment(), &Alignment::resultChanged, this, &TestPoses::changed);
  connect(&session_.document(), &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (!(event.what & (Change::kEverything | Change::kBlueprint))) return;
    planner_->cancel();
    path_.reset();
    emit planningOver();
    if (event.what & Change::kEverything) {
      placed_[0] = placed_[1] = false;
      poses_ = {};
      robot_visible_ = path_visible_ = false;  // they stood in another building
      loaded_.clear();
      emit forgotten();
    }
    emit changed();
  });
}

TestPoses::~TestPoses() = default;

void TestPoses::setRobotVisible(bool visible, const FirstPlace& where) {
  if (visible && !placed_[0]) {
    poses_[0] = {toEigen(where()), 0.0};  // before it counts as shown
    placed_[0] = true;
  }
  robot_visible_ = visible;
  emit changed();
}

void TestPoses::setPathVisible(bool visible, const FirstPlace& where) {
  if (visible && !placed_[1]) {
    poses_[1] = {toEigen(where()), 0.0};
    placed_[1] = true;
  }
  path_visible_ = visible;
  if (visible) {
    plan();
  } else {
    planner_->cancel();
    emit planningOver();
  }
  emit changed();
}

bool TestPoses::canStandAt(const Eigen::Vector2d& place) const {
  const auto& grid = session_.rasters().grid(Side::kBlueprint);
  constexpr int kAround = 12;
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2.0 * kPi * i / kAround;
    const Eigen::Vector2d arm(std::cos(angle), std::sin(angle));
    for (const double reach : {0.0, 0.5 * kRobotRadius, kRobotRadius})
      if (grid->at(Eigen::Vector2d(place + reach * arm)) != CellState::kFree) return false;
  }
  return true;
}

QPointF TestPoses::freePlaceNear(const QPointF& where, double away_m) const {
  if (!session_.rasters().grid(Side::kBlueprint)) return where;
  std::vector<Eigen::Vector2d> taken;
  for (const Anchor& anchor : session_.document().anchors()) taken.push_back(anchor.in_blueprint);
  if (robot_visible_ || path_visible_) taken.push_back(poses_[0].translation);
  const auto is_near = [&](const Eigen::Vector2d& place) {
    return std::any_of(taken.begin(), taken.end(),
                       [&](const Eigen::Vector2d& other) { return (other - place).norm() < away_m; });
  };
  constexpr int kRings = 200;
  const double step = kRobotRadius;
  for (int ring = 0; ring < kRings; ++ring) {
    const int places = 1 + 6 * ring;  // about as far from each other as the rings
    for (int i = 0; i < places; ++i) {
      const double angle = 2.0 * kPi * i / places;
      const Eigen::Vector2d place = toEigen(where) + ring * step * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      if (!is_near(place) && canStandAt(place)) return toQPointF(place);
    }
  }
  return where;
}

void TestPoses::setRobot(const Pose2& in_blueprint) {
  poses_[0] = in_blueprint;
  placed_[0] = true;
  plan();
  emit changed();
}

std::optional<Pose2> TestPoses::robotIn(Side side) const {
  return inFrame(side, poses_[0]);
}

bool TestPoses::setRobotIn(Side side, const Pose2& pose) {
  const std::optional<Pose2> in_blueprint = inBlueprint(side, pose);
  if (in_blueprint) setRobot(*in_blueprint);
  return in_blueprint.has_value();
}

std::optional<Pose2> TestPoses::inFrame(Side side, const Pose2& in_blueprint) const {
  bool certain = false;
  return side == Side::kBlueprint ? in_blueprint : carried(in_blueprint, Side::kBlueprint, certain);
}

std::optional<Pose2> TestPoses::inBlueprint(Side side, const Pose2& pose) const {
  bool certain = false;
  return side == Side::kBlueprint ? pose : carried(pose, side, certain);
}

std::optional<Pose2> TestPoses::carried(const Pose2& pose, Side from, bool& certain) const {
  const SolveResultPtr& result = session_.alignment().result();
  if (!result) return std::nullopt;
  const Projection there = from == Side::kBlueprint ? result->projector.slamFromBlueprint(pose, OutsidePolicy::kRigid)
                                                    : result->projector.blueprintFromSlam(pose, OutsidePolicy::kRigid);
  certain = there.status == ProjectionStatus::kInside;
  return there.ok() ? std::optional(there.pose) : std::nullopt;
}

void TestPoses::drag(Side side, MarkerId id, const QPointF& point_m, bool interim) {
  if (id != kRobot && id != kGoal) return;
  Pose2& pose = poses_[id == kRobot ? 0 : 1];
  Pose2 there = inFrame(side, pose).value_or(Pose2{});
  there.translation = toEigen(point_m);
  const std::optional<Pose2> dragged = inBlueprint(side, there);
  if (!dragged) return;
  pose = *dragged;
  plan(interim);
  emit changed();
}

void TestPoses::turn(Side side, MarkerId id, double heading_rad) {
  if (id != kRobot && id != kGoal) return;
  Pose2& pose = poses_[id == kRobot ? 0 : 1];
  std::optional<Pose2> there = inFrame(side, pose);
  if (!there) return;
  there->heading = heading_rad;
  const std::optional<Pose2> turned = inBlueprint(side, *there);
  if (!turned) return;
  pose.heading = turned->heading;
  emit changed();
}

std::optional<TestPoses::Tried> TestPoses::tried(const Pose2& in_blueprint) const {
  const SolveResultPtr& result = session_.alignment().result();
  if (!result) return std::nullopt;
  Tried tried;
  tried.in_slam = result->projector.slamFromBlueprint(in_blueprint, OutsidePolicy::kRigid);
  if (!tried.in_slam.ok()) return tried;
  const Projection back = result->projector.blueprintFromSlam(tried.in_slam.pose, OutsidePolicy::kRigid);
  tried.round_trip_m = (back.pose.translation - in_blueprint.translation).norm();
  tried.round_trip_rad = std::abs(wrapAngle(back.pose.heading - in_blueprint.heading));
  return tried;
}

void TestPoses::plan(bool interim) {
  const auto& grid = session_.rasters().grid(Side::kBlueprint);
  if (path_visible_ && grid) planner_->request({grid, poses_[0].translation, poses_[1].translation, interim});
}

void TestPoses::showPath(const Planned& planned) {
  path_ = planned.path ? std::optional(*planned.path) : std::nullopt;
  if (planned.path) {
    emit planningOver();
  } else if (!planned.interim) {
    emit planningFailed(toSentence(planned.path.error()));
  }
  emit changed();
}

TestPoses::PoseImport TestPoses::loadPoses(const QByteArray& text, Side side) {
  loaded_.clear();
  loaded_side_ = side;
  // Where semicolons or tabs separate, as spreadsheets write them, a comma is a decimal comma.
  static const QRegularExpression kCommaOrSpace(QStringLiteral("[, ]+"));
  static const QRegularExpression kSemicolonOrTab(QStringLiteral(",? *(;|\\t+)"));
  const bool from_spreadsheet = text.contains(';') || text.contains('\t');
  const QRegularExpression& separator = from_spreadsheet ? kSemicolonOrTab : kCommaOrSpace;
  PoseImport import;
  for (const QByteArray& line : text.split('\n')) {
    const QString trimmed = QString::fromUtf8(line).trimmed();
    if (trimmed.isEmpty()) continue;
    const QStringList fields = trimmed.split(separator, from_spreadsheet ? Qt::KeepEmptyParts : Qt::SkipEmptyParts);
    const std::optional<double> x = fields.size() > 1 ? parseNumber(fields[0]) : std::nullopt;
    const std::optional<double> y = fields.size() > 1 ? parseNumber(fields[1]) : std::nullopt;
    const std::optional<double> heading = fields.size() > 2 ? parseNumber(fields[2]) : std::nullopt;
    if (!x || !y) {
      ++import.skipped;
      continue;
    }
    import.cut = loaded_.size() >= kLargestPoseCount;
    if (import.cut) break;
    loaded_.push_back({{*x, *y}, heading.value_or(0.0)});
  }
  import.shown = loaded_.size();
  emit changed();
  return import;
}

void TestPoses::clearPoses() {
  loaded_.clear();
  emit changed();
}

std::vector<PoseGlyph> TestPoses::glyphs(Side side) const {
  std::vector<PoseGlyph> glyphs;
  const auto add = [&](const Pose2& pose, Side of, MarkerId id, const QColor& color, const QString& text) {
    bool certain = true;
    std::optional<Pose2> shown = pose;
    if (of != side) shown = carried(pose, of, certain);
    if (!shown) return;
    PoseGlyph glyph;
    glyph.id = id;
    glyph.point_m = toQPointF(shown->translation);
    glyph.heading_rad = shown->heading;
    glyph.radius_m = kRobotRadius;
    glyph.color = color;
    glyph.text = certain ? text : text.isEmpty() ? text : tr("%1 (extrapolated)").arg(text);
    glyph.turnable = id != kNoMarker;
    glyph.hollow = !certain;
    glyphs.push_back(std::move(glyph));
  };
  for (const Pose2& pose : loaded_) add(pose, loaded_side_, kNoMarker, kLoadedColor, {});
  if (path_visible_) add(poses_[1], Side::kBlueprint, kGoal, kGoalColor, tr("goal"));
  if (robot_visible_ || path_visible_)
    add(poses_[0], Side::kBlueprint, kRobot, kRobotColor, path_visible_ ? tr("start") : tr("robot"));
  return glyphs;
}

std::vector<PathGlyph> TestPoses::paths(Side side) const {
  if (!path_visible_ || !path_) return {};
  PathGlyph glyph;
  glyph.color = kRobotColor;
  glyph.text = tr("%1 m").arg(numberText(path_->length_m, 1));
  bool certain = true;
  for (const Pose2& pose : path_->poses) {
    const std::optional<Pose2> shown =
        side == Side::kBlueprint ? std::optional(pose) : carried(pose, Side::kBlueprint, certain);
    if (shown) glyph.points_m.push_back(toQPointF(shown->translation));
  }
  return {std::move(glyph)};
}

QString TestPoses::sentence() const {
  const std::optional<Tried> trial = tried(poses_[0]);
  if (!trial) return tr("Place anchors first, then the robot shows in both views");
  if (trial->in_slam.status == ProjectionStatus::kFolded) return tr("The mesh folds here: there is no answer");
  if (!trial->in_slam.ok()) return tr("There is no answer at this place");
  const Pose2& there = trial->in_slam.pose;
  return tr("%1SLAM map x %2 m, y %3 m, heading %4°; there and back differs by %5 mm, %6°")
      .arg(trial->in_slam.status == ProjectionStatus::kExtrapolated ? tr("Extrapolated: ") : QString(),
           metresText(there.translation.x()), metresText(there.translation.y()),
           numberText(there.headingWrapped() * 180.0 / kPi, 1), numberText(1000.0 * trial->round_trip_m, 3),
           numberText(trial->round_trip_rad * 180.0 / kPi, 4));
}

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/planning/grid_planner.h"
#include "ui/main_window/session.h"
#include "ui/views/latest_job.h"
#include "ui/views/marker.h"

#include <QObject>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace cad2slam {

/// Poses that try the alignment out: a robot to drag in either view, a goal with the way to it, and poses from a file.
/// Everything is kept in the frame it was given in and carried to the other one through the current alignment.
class TestPoses : public QObject {
  Q_OBJECT

 public:
  static constexpr MarkerId kRobot = -100;
  static constexpr MarkerId kGoal = -101;

  explicit TestPoses(Session& session, QObject* parent = nullptr);
  ~TestPoses() override;

  /// First place of the robot or of the goal, blueprint frame. Asked only before it is shown for the first time, for
  /// the search may take a while.
  using FirstPlace = std::function<QPointF()>;
  void setRobotVisible(bool visible, const FirstPlace& where);
  void setPathVisible(bool visible, const FirstPlace& where);
  [[nodiscard]] bool isRobotVisible() const { return robot_visible_; }
  /// The nearest place of the blueprint where a robot can stand, at least `away_m` from every anchor and every shown
  /// pose; the place itself where there is none.
  [[nodiscard]] QPointF freePlaceNear(const QPointF& where, double away_m) const;

  /// `interim`: the drag goes on, and nobody is told yet where there is no way.
  void drag(Side side, MarkerId id, const QPointF& point_m, bool interim = false);
  void turn(Side side, MarkerId id, double heading_rad);

  struct Tried {
    Projection in_slam;
    double round_trip_m = 0.0;
    double round_trip_rad = 0.0;
  };
  [[nodiscard]] const Pose2& robot() const { return poses_[0]; }  ///< blueprint frame
  void setRobot(const Pose2& in_blueprint);
  /// The robot in the frame of a side; empty in the SLAM map while there is no alignment.
  [[nodiscard]] std::optional<Pose2> robotIn(Side side) const;
  /// False where the pose cannot be carried to the blueprint.
  bool setRobotIn(Side side, const Pose2& pose);
  /// There and back through the current alignment; empty while there is none.
  [[nodiscard]] std::optional<Tried> tried(const Pose2& in_blueprint) const;

  struct PoseImport {
    std::size_t shown = 0;
    std::size_t skipped = 0;  ///< lines without numbers, a heading of the columns among them
    bool cut = false;         ///< there were more than can be shown
  };
  /// Lines `x,y[,heading]` (metres, radians), separated by comma or spaces, or by semicolon or tab with decimal commas.
  PoseImport loadPoses(const QByteArray& text, Side side);
  void clearPoses();
  [[nodiscard]] bool hasPoses() const { return !loaded_.empty(); }

  [[nodiscard]] std::vector<PoseGlyph> glyphs(Side side) const;
  [[nodiscard]] std::vector<PathGlyph> paths(Side side) const;
  /// What the status bar says of the robot.
  [[nodiscard]] QString sentence() const;

 signals:
  void changed();
  /// Another project: nothing of the old one is shown any more.
  void forgotten();
  void planningFailed(const QString& sentence);
  /// There is a way now, or none is asked for any more.
  void planningOver();

 private:
  struct PlanRequest;
  struct Planned;

  [[nodiscard]] std::optional<Pose2> inFrame(Side side, const Pose2& in_blueprint) const;
  [[nodiscard]] std::optional<Pose2> inBlueprint(Side side, const Pose2& pose) const;  // of a pose in the frame of side
  [[nodiscard]] std::optional<Pose2> carried(const Pose2& pose, Side from, bool& certain) const;
  void plan(bool interim = false);
  void showPath(const Planned& planned);
  [[nodiscard]] bool canStandAt(const Eigen::Vector2d& place) const;

  Session& session_;
  std::array<Pose2, 2> poses_;  // robot and goal, blueprint frame
  bool placed_[2] = {false, false};
  bool robot_visible_ = false;
  bool path_visible_ = false;
  std::optional<PlannedPath> path_;  // blueprint frame
  std::vector<Pose2> loaded_;
  Side loaded_side_ = Side::kSlam;
  std::unique_ptr<LatestJob<PlanRequest, Planned>> planner_;
};

}  // namespace cad2slam

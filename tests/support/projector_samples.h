// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "cad2slam/projection/projector.h"
#include "cad2slam/projection/projector_data.h"

namespace cad2slam::test {

/// A small projector of `columns` x `rows` tiles with everything filled in that a file can hold.
inline ProjectorData sampleProjector(int columns, int rows) {
  ProjectorData data;
  ProjectorInfo& info = data.info;
  info.scale = 1.25;
  info.lattice.cell_size = 0.5;
  info.lattice.blueprint_from_lattice = {{3.0, -2.0}, 0.1};
  info.blueprint = {
      "Stra\xc3\x9f"
      "e 1 \"EG\"",
      std::string(64, 'a'),
      0.02,
      400,
      300,
      {{-1.0, -2.0}, 0.0}};
  info.slam = {"robot \\ 7\n", std::string(64, '0'), 0.05, 200, 100, {{5.0, 1e-7}, -0.5}};
  info.quality = {0.1, 0.2, 0.3, 0.25, 1.0 / 3.0, 4, 0};
  info.creator = "test 1.0";
  info.created = "2026-01-01T00:00:00Z";
  info.project = "site.c2sproj";
  info.note = "two warnings were overridden";
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d cells(column + 0.5, row + 0.5);
      const Eigen::Vector2d center = info.lattice.blueprintFromCells(cells);
      data.node_tile.push_back({column, row});
      data.node_blueprint.push_back(center);
      data.node_slam.push_back({{info.scale * center.x() + 0.02 * row, info.scale * center.y()}, 0.01 * column});
      data.node_stretch.emplace_back(0.01 * row, -0.02);
      const auto node = static_cast<std::uint32_t>(row * columns + column);
      if (column + 1 < columns) data.edges.push_back({node, node + 1});
      if (row + 1 < rows) data.edges.push_back({node, node + static_cast<std::uint32_t>(columns)});
    }
  }
  data.anchors = {{3.0, -2.0, 4.0, 5.0}, {0.1, 1.0 / 3.0, -7.0, 1e9}};
  const Result<Projector> projector = Projector::create(data);
  for (int k = 0; k < 3; ++k) {
    const Pose2 pose{data.node_blueprint[static_cast<std::size_t>(k)], 0.3 * k};
    data.check_poses.push_back({pose, projector->slamFromBlueprint(pose, OutsidePolicy::kError).pose});
  }
  return data;
}

inline bool samePose(const Pose2& a, const Pose2& b) {
  return a.translation == b.translation && a.heading == b.heading;
}

inline bool sameFrame(const FrameInfo& a, const FrameInfo& b) {
  return a.name == b.name && a.image_sha256 == b.image_sha256 && a.resolution_m_per_px == b.resolution_m_per_px &&
         a.width_px == b.width_px && a.height_px == b.height_px && samePose(a.metric_from_corner, b.metric_from_corner);
}

inline bool sameNumber(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

inline bool sameInfo(const ProjectorInfo& a, const ProjectorInfo& b) {
  const QualityInfo& p = a.quality;
  const QualityInfo& q = b.quality;
  return a.model == b.model && a.scale == b.scale && a.weights == b.weights && a.radius_m == b.radius_m &&
         a.outside == b.outside && a.lattice.cell_size == b.lattice.cell_size &&
         samePose(a.lattice.blueprint_from_lattice, b.lattice.blueprint_from_lattice) &&
         sameFrame(a.blueprint, b.blueprint) && sameFrame(a.slam, b.slam) &&
         sameNumber(p.anchor_rms_m, q.anchor_rms_m) && sameNumber(p.anchor_max_m, q.anchor_max_m) &&
         sameNumber(p.leave_one_out_mean_m, q.leave_one_out_mean_m) &&
         sameNumber(p.leave_one_out_median_m, q.leave_one_out_median_m) &&
         sameNumber(p.leave_one_out_max_m, q.leave_one_out_max_m) && p.anchors_used == q.anchors_used &&
         p.folded_tiles == q.folded_tiles && a.creator == b.creator && a.created == b.created &&
         a.project == b.project && a.note == b.note;
}

inline bool sameProjector(const ProjectorData& a, const ProjectorData& b) {
  const auto samePoses = [](const std::vector<Pose2>& p, const std::vector<Pose2>& q) {
    return std::equal(p.begin(), p.end(), q.begin(), q.end(), samePose);
  };
  const auto sameCheck = [](const CheckPose& p, const CheckPose& q) {
    return samePose(p.in_blueprint, q.in_blueprint) && samePose(p.in_slam, q.in_slam);
  };
  return sameInfo(a.info, b.info) && a.node_blueprint == b.node_blueprint && samePoses(a.node_slam, b.node_slam) &&
         a.node_stretch == b.node_stretch && a.node_tile == b.node_tile && a.edges == b.edges &&
         a.anchors == b.anchors &&
         std::equal(a.check_poses.begin(), a.check_poses.end(), b.check_poses.begin(), b.check_poses.end(), sameCheck);
}

}  // namespace cad2slam::test

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/solver/solution.h"
#include "ui/document/document_state.h"
#include "ui/document/room_map.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cad2slam {

/// Something the installer should know, as values; diagnosis_messages.h puts it into words.
struct Finding {
  enum class Kind {
    kDuplicate,  ///< two anchors share one place on one side and disagree on the other; value: how far [m]
    kMirrored,   ///< a mirrored blueprint would fit much better; value: RMS now, other: RMS mirrored [m]
    kSwapped,    ///< two anchors fit with exchanged counterparts; value: RMS now, other: RMS swapped [m]
    kOutlier,    ///< one anchor does not fit the others; value: by how much [m]
    kFolded,     ///< the mesh turns over near these anchors; value: number of tiles
    kScale,      ///< value: SLAM metres per blueprint metre; other: standard deviation of it; agrees
    kLengths,    ///< what just two anchors say of it, right or wrong; value: blueprint [m], other: SLAM map [m]; agrees
    kClose,      ///< two anchors too near to each other for a rotation; value: distance [m]; place: far away
    kCollinear,  ///< all anchors on one line; place: farthest beside it
    kOneRoom,    ///< all anchors in one room; place: the largest of the others
    kEmptyRooms,        ///< rooms without anchor; value: how many, place: in the largest
    kSimilarityEnough,  ///< bending gains nothing; value: median error without bending [m]
    kOutsideImage,      ///< these anchors lie beside the image of a side
    kUnknownGround,     ///< these anchors lie where the map of a side shows neither floor nor wall
    kUnpredicted,       ///< anchors are far from where the others put them; value: typically [m], place: far from all
    kHalfTurn,          ///< each anchor taken for the one opposite fits about as well; value: RMS then, other: now [m]
  };
  Kind kind = Kind::kOutlier;
  std::vector<AnchorId> anchors;
  double value = 0.0;
  double other = 0.0;
  std::optional<Eigen::Vector2d> place;  ///< [m] blueprint frame
  Side side = Side::kBlueprint;          ///< of kOutsideImage and kUnknownGround
  std::string agrees = {};               ///< another SLAM map to which the blueprint is true to scale, or empty
};

/// Part by which a scale may be off without being called wrong.
inline constexpr double kScaleTolerance = 0.02;

/// What a map shows around a place.
enum class Ground { kKnown, kUnknown, kOutsideImage };

struct DiagnosisInput {
  AnchorList anchors;
  /// Under each anchor, in their order; empty where nobody has looked.
  std::vector<Ground> ground_in_blueprint;
  std::vector<Ground> ground_in_slam;
  ClassLimits limits;
  double slam_m_per_px = 0.05;
  double blueprint_m_per_px = 0.05;
  double blueprint_diagonal_m = 0.0;
  ScaleSettings scale;
  const Solution* solution = nullptr;  ///< of exactly these anchors, or null
  const Projector* projector = nullptr;
  const std::vector<Eigen::Vector2d>* nodes = nullptr;  ///< rest places of the mesh, blueprint frame [m]
  const RoomMap* rooms = nullptr;
  /// SLAM maps of the same blueprint that are not being edited, with their anchors.
  std::vector<std::pair<std::string, AnchorList>> others;
};

/// What is wrong or could be better, most serious first. Only enabled anchors count. Takes milliseconds with hundreds
/// of anchors: run it in a worker.
[[nodiscard]] std::vector<Finding> diagnose(const DiagnosisInput& input);

}  // namespace cad2slam

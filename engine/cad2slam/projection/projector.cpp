// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/projection/projector.h"

#include <Eigen/LU>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "cad2slam/core/large_vector.h"
#include "cad2slam/mesh/tile_index.h"
#include "cad2slam/projection/node_blending.h"
#include "cad2slam/projection/spatial_hash.h"

namespace cad2slam {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kLargestCell = 1e9;             // tile numbers stay far inside 32 bits
constexpr double kLargestStretch = 5.0;          // e^5: no map of a building is 148 times longer than its plan
constexpr double kPaperDistanceOffset_m = 1e-3;  // the authors' guard against dividing by zero

double headingAfter(const Matrix2d& linear, double heading) {
  const Vector2d direction = linear * Vector2d(std::cos(heading), std::sin(heading));
  return wrapAngle(std::atan2(direction.y(), direction.x()));
}

Projection noPose(ProjectionStatus status) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  return {{{kNaN, kNaN}, kNaN}, status};
}

/// Tiles this close belong together: their images overlap only where the mesh folds.
bool isSameSheet(const TileCoordinate& a, const TileCoordinate& b) {
  constexpr std::int32_t kSameSheet = 3;
  return std::abs(a.column - b.column) <= kSameSheet && std::abs(a.row - b.row) <= kSameSheet;
}

tl::unexpected<Error> malformedNode(std::size_t node, const std::string& what) {
  return fail(ErrorCode::kMalformed, "node " + std::to_string(node) + " of the projector " + what);
}

Result<void> checkInfo(const ProjectorInfo& info) {
  const TileLattice& lattice = info.lattice;
  if (!(lattice.cell_size > 0.0) || !std::isfinite(lattice.cell_size) || !lattice.blueprint_from_lattice.isFinite()) {
    return fail(ErrorCode::kMalformed, "the projector has no finite, positive cell size and finite origin");
  }
  if (!(info.scale > 0.0) || !std::isfinite(info.scale)) {
    return fail(ErrorCode::kMalformed, "the projector has no finite, positive scale");
  }
  if (!(info.radius_m > 0.0) || !(info.radius_m <= 1000.0 * lattice.cell_size)) {
    return fail(ErrorCode::kMalformed, "the radius of the projector is not between 0 and 1000 cells");
  }
  return {};
}

}  // namespace

class Projector::Impl {
 public:
  static Result<std::shared_ptr<const Impl>> create(const ProjectorInfo& info, ProjectorArrays&& arrays);

  [[nodiscard]] Projection forward(const Pose2& pose, OutsidePolicy outside) const;
  [[nodiscard]] Projection backward(const Pose2& pose, OutsidePolicy outside, const Vector2d* hint) const;
  [[nodiscard]] Matrix2d jacobian(const Vector2d& point) const;
  [[nodiscard]] std::size_t foldedTileCount() const;
  [[nodiscard]] double distanceToMesh(const Vector2d& point) const;
  [[nodiscard]] std::vector<Vector2d> tileMiddles() const;

  ProjectorInfo info;
  LargeVector<NodePrediction> nodes;

 private:
  struct Extended {
    Blend blend;  ///< at the nearest place of the mesh
    Vector2d position;
    bool inside;
  };
  struct Preimage {
    Vector2d point = Vector2d::Zero();
    Blend blend;
    bool converged = false;
    bool inside = false;
  };

  /// Numbers the nodes in the order in which they lie in memory. Gives the row in the file of each.
  [[nodiscard]] Result<LargeVector<std::uint32_t>> placeTiles(const LargeVector<TileCoordinate>& tiles);
  [[nodiscard]] Result<void> placeNodes(const ProjectorArrays& arrays, const LargeVector<std::uint32_t>& file_order);
  [[nodiscard]] Vector2d cellsOf(const Vector2d& point) const { return cells_from_blueprint_ * point + cells_offset_; }
  [[nodiscard]] bool tileOf(const Vector2d& cells, TileCoordinate& tile) const;
  [[nodiscard]] Blend blendSmooth(const Vector2d& point, const Vector2d& cells, const TileCoordinate& tile) const;
  [[nodiscard]] Blend blendPaper(const Vector2d& point, const TileCoordinate& tile) const;
  [[nodiscard]] Blend blend(const Vector2d& point, const Vector2d& cells, const TileCoordinate& tile) const {
    return info.weights == BlendWeights::kSmooth ? blendSmooth(point, cells, tile) : blendPaper(point, tile);
  }
  [[nodiscard]] Vector2d nearestPlaceOnMesh(const Vector2d& cells) const;
  [[nodiscard]] Extended extended(const Vector2d& point) const;
  [[nodiscard]] Preimage preimageFrom(const Vector2d& start, const Vector2d& target) const;
  [[nodiscard]] Preimage searchPreimage(const Vector2d& target, OutsidePolicy outside) const;
  [[nodiscard]] bool mayCover(std::uint32_t node, double squared_distance) const;
  [[nodiscard]] bool hasOtherPreimage(const Preimage& found, const Vector2d& target) const;
  [[nodiscard]] Vector2d centerOf(std::uint32_t node) const {
    return info.lattice.blueprintFromCells(Vector2d(tiles_[node].column + 0.5, tiles_[node].row + 0.5));
  }
  [[nodiscard]] bool folds(std::uint32_t node) const;
  [[nodiscard]] bool foldsNear(std::uint32_t node) const;
  [[nodiscard]] bool overlapsNear(std::uint32_t node) const;

  TileIndex index_;
  LargeVector<TileCoordinate> tiles_;
  LargeVector<Vector2d> centers_;  // only with the paper's weights, which measure distances to the true centres
  SpatialHash seeds_;
  Matrix2d cells_from_blueprint_ = Matrix2d::Identity();
  Vector2d cells_offset_ = Vector2d::Zero();

  /// What is known of one node. Found out when a query first asks: going through all of them would take longer than
  /// the rest of loading. Threads that ask at the same time all find out the same.
  enum class Known : std::uint8_t { kNothing, kNo, kYes };
  struct FoldMemory {
    std::atomic<Known> folds;
    std::atomic<Known> folds_near;
    std::atomic<Known> overlaps_near;
  };
  mutable std::unique_ptr<FoldMemory[]> fold_memory_;
};

Result<std::shared_ptr<const Projector::Impl>> Projector::Impl::create(const ProjectorInfo& info,
                                                                       ProjectorArrays&& arrays) {
  if (const Result<void> checked = checkInfo(info); !checked) return failAs(checked);
  const std::size_t count = arrays.node_tile.size();
  if (arrays.node_blueprint.size() != count || arrays.node_slam.size() != count ||
      arrays.node_stretch.size() != count) {
    return fail(ErrorCode::kMalformed, "the projector's node arrays differ in length");
  }
  if (count == 0) return fail(ErrorCode::kMalformed, "the projector has no node");
  if (count >= TileIndex::kNone) return fail(ErrorCode::kMalformed, "the projector has too many nodes");

  const TileLattice& lattice = info.lattice;
  auto impl = std::make_shared<Impl>();
  impl->info = info;
  impl->cells_from_blueprint_ = rotationMatrix(-lattice.blueprint_from_lattice.heading) / lattice.cell_size;
  impl->cells_offset_ = -(impl->cells_from_blueprint_ * lattice.blueprint_from_lattice.translation);

  // From here on it matters what is in memory at the same time.
  const Result<LargeVector<std::uint32_t>> file_order = impl->placeTiles(arrays.node_tile);
  if (!file_order) return failAs(file_order);
  freeMemory(arrays.node_tile);
  if (const Result<void> placed = impl->placeNodes(arrays, *file_order); !placed) return failAs(placed);
  freeMemory(arrays.node_blueprint);
  freeMemory(arrays.node_stretch);
  const auto placeOf = [&](std::size_t i) { return Vector2d(arrays.node_slam[(*file_order)[i]].data()); };
  impl->seeds_ = SpatialHash(count, placeOf, 2.0 * info.scale * lattice.cell_size);
  freeMemory(arrays.node_slam);
  impl->fold_memory_ = std::make_unique<FoldMemory[]>(count);
  return impl;
}

Result<LargeVector<std::uint32_t>> Projector::Impl::placeTiles(const LargeVector<TileCoordinate>& tiles) {
  const auto isFar = [](std::int32_t number) { return std::abs(static_cast<double>(number)) > kLargestCell; };
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (isFar(tiles[i].column) || isFar(tiles[i].row)) return malformedNode(i, "lies on a tile outside any building");
  }
  std::optional<TileIndex> index = TileIndex::create(info.lattice, tiles.data(), tiles.size());
  if (!index) return fail(ErrorCode::kMalformed, "the projector has two nodes on one tile");
  index_ = std::move(*index);
  LargeVector<std::uint32_t> file_order = index_.renumberInMemoryOrder();
  tiles_.resize(tiles.size());
  for (std::size_t i = 0; i < tiles.size(); ++i) tiles_[i] = tiles[file_order[i]];
  return file_order;
}

Result<void> Projector::Impl::placeNodes(const ProjectorArrays& arrays, const LargeVector<std::uint32_t>& file_order) {
  nodes.resize(file_order.size());
  if (info.weights == BlendWeights::kPaper) centers_.resize(file_order.size());
  for (std::size_t i = 0; i < file_order.size(); ++i) {
    const std::size_t row = file_order[i];
    const Vector2d center(arrays.node_blueprint[row].data());
    const Vector2d in_slam(arrays.node_slam[row].data());
    const double heading = arrays.node_slam[row][2];
    const Vector2d stretch(arrays.node_stretch[row].data());
    if (!center.allFinite() || !in_slam.allFinite() || !std::isfinite(heading) || !stretch.allFinite()) {
      return malformedNode(row, "is not finite");
    }
    if (stretch.cwiseAbs().maxCoeff() > kLargestStretch) return malformedNode(row, "is stretched beyond reason");
    const Vector2d off_middle = cellsOf(center) - Vector2d(tiles_[i].column + 0.5, tiles_[i].row + 0.5);
    if (off_middle.cwiseAbs().maxCoeff() > 1.0) return malformedNode(row, "does not lie on its tile");
    const Vector2d factors = info.scale * stretch.array().exp().matrix();
    nodes[i].linear = rotationMatrix(heading) * factors.asDiagonal();
    nodes[i].offset = in_slam - nodes[i].linear * center;
    if (!centers_.empty()) centers_[i] = center;
  }
  return {};
}

bool Projector::Impl::tileOf(const Vector2d& cells, TileCoordinate& tile) const {
  if (!(cells.cwiseAbs().maxCoeff() < kLargestCell)) return false;
  tile = {static_cast<std::int32_t>(std::floor(cells.x())), static_cast<std::int32_t>(std::floor(cells.y()))};
  return true;
}

Blend Projector::Impl::blendSmooth(const Vector2d& point, const Vector2d& cells, const TileCoordinate& tile) const {
  const SplineWeights across(cells.x() - tile.column);
  const SplineWeights up(cells.y() - tile.row);
  const std::array<std::uint32_t, 9> around = index_.neighbourhood(tile.column, tile.row);
  BlendSums sums;
  for (std::size_t k = 0; k < 9; ++k) {
    if (around[k] == TileIndex::kNone) continue;
    const std::size_t column = k % 3;
    const std::size_t row = k / 3;
    sums.add(nodes[around[k]], point, across.value[column] * up.value[row], across.slope[column] * up.value[row],
             across.value[column] * up.slope[row]);
  }
  return blendOf(sums, cells_from_blueprint_);
}

Blend Projector::Impl::blendPaper(const Vector2d& point, const TileCoordinate& tile) const {
  const auto reach = static_cast<std::int32_t>(std::ceil(info.radius_m / info.lattice.cell_size)) + 1;
  BlendSums sums;
  for (std::int32_t dy = -reach; dy <= reach; ++dy) {
    for (std::int32_t dx = -reach; dx <= reach; ++dx) {
      const std::uint32_t node = index_.at(tile.column + dx, tile.row + dy);
      if (node == TileIndex::kNone) continue;
      const Vector2d to_query = point - centers_[node];
      const double distance = to_query.norm();
      if (distance >= info.radius_m && !(dx == 0 && dy == 0)) continue;  // the query's own tile always counts
      const double weight = 1.0 / (distance + kPaperDistanceOffset_m);
      const Vector2d slope = distance > 0.0 ? Vector2d(-weight * weight / distance * to_query) : Vector2d::Zero();
      sums.add(nodes[node], point, weight, slope.x(), slope.y());
    }
  }
  return blendOf(sums, Matrix2d::Identity());
}

Projection Projector::Impl::forward(const Pose2& pose, OutsidePolicy outside) const {
  if (!pose.isFinite()) return noPose(ProjectionStatus::kInvalid);
  const Vector2d cells = cellsOf(pose.translation);
  TileCoordinate tile;
  if (tileOf(cells, tile) && index_.at(tile.column, tile.row) != TileIndex::kNone) {
    const Blend here = blend(pose.translation, cells, tile);
    if (!(here.jacobian.determinant() > 0.0)) return noPose(ProjectionStatus::kFolded);
    return {{here.position, headingAfter(here.linear, pose.heading)}, ProjectionStatus::kInside};
  }
  if (outside == OutsidePolicy::kError) return noPose(ProjectionStatus::kOutside);
  const Extended beyond = extended(pose.translation);
  if (!(beyond.blend.jacobian.determinant() > 0.0)) return noPose(ProjectionStatus::kFolded);
  return {{beyond.position, headingAfter(beyond.blend.linear, pose.heading)}, ProjectionStatus::kExtrapolated};
}

/// In cells; the place is just inside the half-open square of its tile.
Vector2d Projector::Impl::nearestPlaceOnMesh(const Vector2d& cells) const {
  const TileCoordinate tile = index_.nearestTile(cells);
  const Vector2d low(tile.column, tile.row);
  constexpr double kJustInside = 1.0 - 1e-10;
  return cells.cwiseMax(low).cwiseMin(Vector2d(low.array() + kJustInside));
}

/// The forward function continued beyond the mesh: the nearest place of the mesh carries the query along rigidly.
Projector::Impl::Extended Projector::Impl::extended(const Vector2d& point) const {
  const Vector2d cells = cellsOf(point);
  TileCoordinate tile;
  if (tileOf(cells, tile) && index_.at(tile.column, tile.row) != TileIndex::kNone) {
    const Blend here = blend(point, cells, tile);
    return {here, here.position, true};
  }
  const Vector2d near_cells = nearestPlaceOnMesh(cells);
  (void)tileOf(near_cells, tile);
  const Vector2d near_point = info.lattice.blueprintFromCells(near_cells);
  const Blend near = blend(near_point, near_cells, tile);
  return {near, near.position + near.linear * (point - near_point), false};
}

Matrix2d Projector::Impl::jacobian(const Vector2d& point) const {
  const Extended at = extended(point);
  return at.inside ? at.blend.jacobian : at.blend.linear;
}

/// Newton's method on the continued forward function. Steps are kept below a cell and a half, so that the iteration
/// cannot leave the sheet of the mesh it started on.
Projector::Impl::Preimage Projector::Impl::preimageFrom(const Vector2d& start, const Vector2d& target) const {
  constexpr int kIterations = 40;
  constexpr double kTolerance_m = 1e-10;
  const double largest_step = 1.5 * info.lattice.cell_size;
  Preimage preimage;
  preimage.point = start;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const Extended at = extended(preimage.point);
    preimage.blend = at.blend;
    preimage.inside = at.inside;
    const Vector2d missing = target - at.position;
    if (missing.squaredNorm() < kTolerance_m * kTolerance_m) {
      preimage.converged = true;
      return preimage;
    }
    const Matrix2d& slope = at.inside ? at.blend.jacobian : at.blend.linear;
    const double determinant = slope.determinant();
    if (!(determinant > 1e-6 * info.scale * info.scale)) return preimage;
    Vector2d step = slope.inverse() * missing;
    if (const double length = step.norm(); at.inside && length > largest_step) step *= largest_step / length;
    preimage.point += step;
    if (!preimage.point.allFinite()) return preimage;
  }
  return preimage;
}

/// Newton's method from the middles of the tiles whose images are nearest, until one leads to a place on the mesh.
Projector::Impl::Preimage Projector::Impl::searchPreimage(const Vector2d& target, OutsidePolicy outside) const {
  Preimage best;
  const auto tryFrom = [&](std::uint32_t node) {
    const Preimage preimage = preimageFrom(centerOf(node), target);
    const bool better = preimage.converged && (!best.converged || (preimage.inside && !best.inside));
    if (better) best = preimage;
  };
  const SpatialHash::Candidates seeds = seeds_.near(target);
  for (std::size_t k = 0; k < seeds.count && !(best.converged && best.inside); ++k) {
    // Once there is an answer beyond the mesh, only tiles that may cover the target are worth trying.
    if (best.converged && !mayCover(seeds.nodes[k], seeds.squared_distances[k])) continue;
    tryFrom(seeds.nodes[k]);
  }
  if (!best.converged && outside == OutsidePolicy::kRigid && seeds.count == 0) tryFrom(seeds_.nearest(target));
  return best;
}

Projection Projector::Impl::backward(const Pose2& pose, OutsidePolicy outside, const Vector2d* hint) const {
  if (!pose.isFinite()) return noPose(ProjectionStatus::kInvalid);
  const Vector2d& target = pose.translation;
  Preimage best;
  if (hint != nullptr) {
    const Preimage from_hint = preimageFrom(*hint, target);
    if (from_hint.converged && from_hint.inside) best = from_hint;  // otherwise a bad hint, which changes nothing
  }
  if (!best.converged) best = searchPreimage(target, outside);
  if (!best.converged) return noPose(ProjectionStatus::kOutside);
  if (!best.inside) {
    // Rounding may put the preimage of a border place a hair outside: that is still the border.
    const Vector2d cells = cellsOf(best.point);
    const Vector2d border = nearestPlaceOnMesh(cells);
    constexpr double kHair_cells = 1e-8;
    if ((border - cells).norm() < kHair_cells) {
      best.point = info.lattice.blueprintFromCells(border);
      best.inside = true;
    }
  }
  if (!best.inside && outside == OutsidePolicy::kError) return noPose(ProjectionStatus::kOutside);
  if (!(best.blend.jacobian.determinant() > 0.0) || (best.inside && hasOtherPreimage(best, target))) {
    return noPose(ProjectionStatus::kFolded);
  }
  return {{best.point, headingAfter(best.blend.linear.inverse(), pose.heading)},
          best.inside ? ProjectionStatus::kInside : ProjectionStatus::kExtrapolated};
}

/// Whether a tile may cover a place of the SLAM frame this far from the tile's middle: a bound of what its half
/// diagonal may become, with room for the curvature of the blend.
bool Projector::Impl::mayCover(std::uint32_t node, double squared_distance) const {
  constexpr double kRoom = 1.5;
  const double half_diagonal = 0.5 * info.lattice.cell_size * nodes[node].linear.norm();
  return squared_distance <= kRoom * kRoom * half_diagonal * half_diagonal;
}

/// Whether another place of the mesh lands on the same target: where the mesh folds, or where two distant parts of it
/// overlap in the SLAM frame.
bool Projector::Impl::hasOtherPreimage(const Preimage& found, const Vector2d& target) const {
  TileCoordinate tile;
  (void)tileOf(cellsOf(found.point), tile);
  const std::uint32_t own = index_.at(tile.column, tile.row);
  const bool folds = own != TileIndex::kNone && foldsNear(own);
  if (!folds && (own == TileIndex::kNone || !overlapsNear(own))) return false;
  const SpatialHash::Candidates seeds = seeds_.near(target);
  for (std::size_t k = 0; k < seeds.count; ++k) {
    if (!folds && isSameSheet(tiles_[seeds.nodes[k]], tile)) continue;
    const Preimage preimage = preimageFrom(centerOf(seeds.nodes[k]), target);
    if (preimage.converged && preimage.inside &&
        (preimage.point - found.point).norm() > 1e-6 * info.lattice.cell_size) {
      return true;
    }
  }
  return false;
}

/// Whether the forward function turns over at the middle or a corner of a tile.
bool Projector::Impl::folds(std::uint32_t node) const {
  std::atomic<Known>& memory = fold_memory_[node].folds;
  if (const Known known = memory.load(std::memory_order_relaxed); known != Known::kNothing) return known == Known::kYes;
  constexpr double kEdge = 1e-9;
  const Vector2d samples[] = {
      {0.5, 0.5}, {kEdge, kEdge}, {1 - kEdge, kEdge}, {kEdge, 1 - kEdge}, {1 - kEdge, 1 - kEdge}};
  const Vector2d corner(tiles_[node].column, tiles_[node].row);
  const bool found = std::any_of(std::begin(samples), std::end(samples), [&](const Vector2d& sample) {
    const Vector2d cells = corner + sample;
    return !(blend(info.lattice.blueprintFromCells(cells), cells, tiles_[node]).jacobian.determinant() > 0.0);
  });
  memory.store(found ? Known::kYes : Known::kNo, std::memory_order_relaxed);
  return found;
}

/// Whether a tile or one within two tiles of it folds.
bool Projector::Impl::foldsNear(std::uint32_t node) const {
  std::atomic<Known>& memory = fold_memory_[node].folds_near;
  if (const Known known = memory.load(std::memory_order_relaxed); known != Known::kNothing) return known == Known::kYes;
  constexpr std::int32_t kReach = 2;
  bool found = false;
  for (std::int32_t dy = -kReach; dy <= kReach; ++dy) {
    for (std::int32_t dx = -kReach; dx <= kReach; ++dx) {
      const std::uint32_t other = index_.at(tiles_[node].column + dx, tiles_[node].row + dy);
      found = found || (other != TileIndex::kNone && folds(other));
    }
  }
  memory.store(found ? Known::kYes : Known::kNo, std::memory_order_relaxed);
  return found;
}

/// Whether a distant part of the mesh comes so close in the SLAM frame that both may cover one place.
bool Projector::Impl::overlapsNear(std::uint32_t node) const {
  std::atomic<Known>& memory = fold_memory_[node].overlaps_near;
  if (const Known known = memory.load(std::memory_order_relaxed); known != Known::kNothing) return known == Known::kYes;
  const Vector2d place = nodes[node].linear * centerOf(node) + nodes[node].offset;
  const bool found =
      seeds_.anyAround(place, [&](std::uint32_t other) { return !isSameSheet(tiles_[other], tiles_[node]); });
  memory.store(found ? Known::kYes : Known::kNo, std::memory_order_relaxed);
  return found;
}

std::size_t Projector::Impl::foldedTileCount() const {
  std::size_t count = 0;
  for (std::uint32_t node = 0; node < nodes.size(); ++node) count += folds(node) ? 1 : 0;
  return count;
}

double Projector::Impl::distanceToMesh(const Vector2d& point) const {
  if (!point.allFinite()) return std::numeric_limits<double>::infinity();
  const Vector2d cells = cellsOf(point);
  TileCoordinate tile;
  if (tileOf(cells, tile) && index_.at(tile.column, tile.row) != TileIndex::kNone) return 0.0;
  return (nearestPlaceOnMesh(cells) - cells).norm() * info.lattice.cell_size;
}

std::vector<Vector2d> Projector::Impl::tileMiddles() const {
  std::vector<Vector2d> middles;
  middles.reserve(tiles_.size());
  for (std::uint32_t node = 0; node < tiles_.size(); ++node) middles.push_back(centerOf(node));
  return middles;
}

Result<Projector> Projector::create(const ProjectorInfo& info, ProjectorArrays&& arrays) {
  Result<std::shared_ptr<const Impl>> impl = Impl::create(info, std::move(arrays));
  if (!impl) return failAs(impl);
  return Projector(std::move(*impl));
}

Result<Projector> Projector::create(const ProjectorData& data) {
  return create(data.info, arraysOf(data));
}

const ProjectorInfo& Projector::info() const noexcept {
  return impl_->info;
}
std::size_t Projector::nodeCount() const noexcept {
  return impl_->nodes.size();
}
std::size_t Projector::foldedTileCount() const noexcept {
  return impl_->foldedTileCount();
}

Projection Projector::slamFromBlueprint(const Pose2& pose_in_blueprint, OutsidePolicy outside) const noexcept {
  return impl_->forward(pose_in_blueprint, outside);
}
Projection Projector::blueprintFromSlam(const Pose2& pose_in_slam, OutsidePolicy outside) const noexcept {
  return impl_->backward(pose_in_slam, outside, nullptr);
}
Projection Projector::blueprintFromSlam(const Pose2& pose_in_slam, OutsidePolicy outside,
                                        const Eigen::Vector2d& hint_in_blueprint) const noexcept {
  return impl_->backward(pose_in_slam, outside, &hint_in_blueprint);
}
Projection Projector::slamFromBlueprint(const Pose2& pose_in_blueprint) const noexcept {
  return impl_->forward(pose_in_blueprint, impl_->info.outside);
}
Projection Projector::blueprintFromSlam(const Pose2& pose_in_slam) const noexcept {
  return impl_->backward(pose_in_slam, impl_->info.outside, nullptr);
}

Eigen::Matrix2d Projector::jacobian(const Eigen::Vector2d& point_in_blueprint) const noexcept {
  return impl_->jacobian(point_in_blueprint);
}

double Projector::distanceToMesh(const Eigen::Vector2d& point_in_blueprint) const noexcept {
  return impl_->distanceToMesh(point_in_blueprint);
}

std::vector<Eigen::Vector2d> Projector::tileMiddles() const {
  return impl_->tileMiddles();
}

}  // namespace cad2slam

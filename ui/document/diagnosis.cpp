// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/diagnosis.h"

#include "cad2slam/geometry/similarity_fit.h"
#include "ui/document/judgement.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cad2slam {
namespace {

using Kind = Finding::Kind;
using Eigen::Vector2d;

constexpr double kScaleSigmas = 2.0;         // how sure one must be of it
constexpr double kNeighbours = 4.0;          // anchors that are wrong together
constexpr double kLineWidth = 0.05;          // width over length of anchors that count as one line
constexpr double kCloseShare = 0.15;         // of the blueprint's diagonal, for two anchors
constexpr double kMirrorGain = 0.35;         // a mirrored fit has to be better by this factor
constexpr double kSwapGain = 0.5;            // and a swap by this one
constexpr std::size_t kSwapCandidates = 12;  // worst anchors among which swaps are tried
constexpr double kOutlierRatio = 4.0;        // against the median of the others
constexpr std::size_t kOutlierFrom = 5;      // with fewer nobody knows which one is wrong
constexpr double kOppositeShare = 0.1;       // of the anchors' extent, for two that lie opposite to each other
constexpr double kHalfTurnLoss = 1.25;       // a half turn may fit worse by this factor and still be possible
constexpr double kLargestJudged_m = 1e8;     // of a coordinate; files may hold larger ones

/// Finite, and not so large that squares of differences are no numbers any more.
bool isUsable(const Vector2d& point) {
  return point.allFinite() && point.cwiseAbs().maxCoeff() < kLargestJudged_m;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class Diagnosis {
 public:
  explicit Diagnosis(const DiagnosisInput& input) : input_(input) {
    for (const Anchor& anchor : input.anchors) {
      if (!anchor.enabled || !isUsable(anchor.in_blueprint) || !isUsable(anchor.in_slam)) continue;
      used_.push_back(&anchor);
      pairs_.push_back({anchor.in_blueprint, anchor.in_slam});
    }
    look_m_ = std::max(input.limits.look_m, input.limits.look_cells * input.slam_m_per_px);
    ok_m_ = std::max(input.limits.ok_m, input.limits.ok_cells * input.slam_m_per_px);
  }

  std::vector<Finding> run() {
    findOutside();
    compare();
    findUnknownGround();
    return std::move(findings_);
  }

 private:
  void compare() {
    findDuplicates();
    if (used_.size() == 2) compareTwo();
    if (used_.size() < 3) return;
    const Result<Similarity2> robust = fitSimilarityRobust(pairs_, std::nullopt);
    if (!robust) return;
    const bool mirrored = findMirrored();
    const bool swapped = !mirrored && findSwapped(*robust);
    if (!mirrored && !swapped) {
      findOutlier();
      findUnpredicted();
      findHalfTurn(*robust);
    }
    if (!mirrored) findScale(*robust);
    findFolds();
    findLine();
    findRooms();
    if (!mirrored && !swapped) findSimilarity();
  }

  void findOutside() { findGround(Ground::kOutsideImage, Kind::kOutsideImage); }
  void findUnknownGround() { findGround(Ground::kUnknown, Kind::kUnknownGround); }

  void findGround(Ground ground, Kind kind) {
    for (const Side side : {Side::kBlueprint, Side::kSlam}) {
      const std::vector<Ground>& found = side == Side::kBlueprint ? input_.ground_in_blueprint : input_.ground_in_slam;
      Finding finding{kind, {}, 0.0, 0.0, {}, side};
      for (std::size_t i = 0; i < std::min(found.size(), input_.anchors.size()); ++i)
        if (input_.anchors[i].enabled && found[i] == ground) finding.anchors.push_back(input_.anchors[i].id);
      finding.value = static_cast<double>(finding.anchors.size());
      if (!finding.anchors.empty()) add(std::move(finding));
    }
  }

  void findDuplicates() {
    const double same_blueprint = 2.0 * input_.blueprint_m_per_px;
    const double same_slam = 2.0 * input_.slam_m_per_px;
    for (std::size_t i = 0; i < used_.size(); ++i) {
      for (std::size_t j = i + 1; j < used_.size(); ++j) {
        const double in_blueprint = (used_[i]->in_blueprint - used_[j]->in_blueprint).norm();
        const double in_slam = (used_[i]->in_slam - used_[j]->in_slam).norm();
        const bool disagree =
            (in_blueprint <= same_blueprint && in_slam > look_m_) || (in_slam <= same_slam && in_blueprint > look_m_);
        if (disagree)
          add({Kind::kDuplicate, {used_[i]->id, used_[j]->id}, std::max(in_blueprint, in_slam), in_blueprint, {}});
      }
    }
  }

  void compareTwo() {
    const double in_blueprint = (used_[0]->in_blueprint - used_[1]->in_blueprint).norm();
    const double in_slam = (used_[0]->in_slam - used_[1]->in_slam).norm();
    const std::vector<AnchorId> both{used_[0]->id, used_[1]->id};
    if (in_blueprint < kCloseShare * input_.blueprint_diagonal_m)
      return add({Kind::kClose, both, in_blueprint, 0.0, farthestNode()});
    if (input_.scale.rule == ScaleRule::kToScale && in_blueprint > 0.0)
      add({Kind::kLengths, both, in_blueprint, in_slam, {}, Side::kBlueprint, agreeingMap()});
  }

  /// Where another anchor would tell most: the node that is farthest from all anchors.
  [[nodiscard]] std::optional<Vector2d> farthestNode() const {
    return bestNode([this](const Vector2d& node) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const PointPair& pair : pairs_) nearest = std::min(nearest, (node - pair.source).norm());
      return nearest;
    });
  }

  template <class Worth>
  [[nodiscard]] std::optional<Vector2d> bestNode(const Worth& worth) const {
    if (!input_.nodes || input_.nodes->empty()) return std::nullopt;
    return *std::max_element(input_.nodes->begin(), input_.nodes->end(),
                             [&](const Vector2d& a, const Vector2d& b) { return worth(a) < worth(b); });
  }

  [[nodiscard]] Vector2d middleOfAnchors() const {
    Vector2d sum = Vector2d::Zero();
    for (const PointPair& pair : pairs_) sum += pair.source;
    return sum / static_cast<double>(pairs_.size());
  }

  struct Line {
    Vector2d middle = Vector2d::Zero();
    Vector2d across = Vector2d::UnitY();
    double width_over_length = 0.0;
  };

  /// Along the anchors' spread in the blueprint.
  [[nodiscard]] Line lineThroughAnchors() const {
    Line line;
    line.middle = middleOfAnchors();
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const PointPair& pair : pairs_)
      spread += (pair.source - line.middle) * (pair.source - line.middle).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
    const Vector2d extent = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    if (extent.y() > 0.0) line.width_over_length = extent.x() / extent.y();
    line.across = axes.eigenvectors().col(0);
    return line;
  }

  bool findMirrored() {
    const Result<Similarity2> plain = fitSimilarity(pairs_, std::nullopt);
    const Result<Similarity2> mirrored = fitMirroredSimilarity(pairs_, std::nullopt);
    if (!plain || !mirrored) return false;
    const double rms = rmsResidual(*plain, pairs_);
    std::vector<PointPair> flipped = pairs_;
    for (PointPair& pair : flipped) pair.source.y() = -pair.source.y();
    const double rms_mirrored = rmsResidual(*mirrored, flipped);
    if (rms < 2.0 * look_m_ || rms_mirrored > kMirrorGain * rms) return false;
    // Anchors near one line fit either way: no verdict from them.
    if (lineThroughAnchors().width_over_length < kLineWidth) return false;
    add({Kind::kMirrored, {}, rms, rms_mirrored, {}});
    return true;
  }

  bool findSwapped(const Similarity2& robust) {
    if (used_.size() < 4) return false;
    std::vector<std::size_t> worst(used_.size());
    std::iota(worst.begin(), worst.end(), std::size_t{0});
    const auto residual = [&](std::size_t i) { return (robust * pairs_[i].source - pairs_[i].target).norm(); };
    std::sort(worst.begin(), worst.end(), [&](std::size_t a, std::size_t b) { return residual(a) > residual(b); });
    worst.resize(std::min(worst.size(), kSwapCandidates));
    const Result<Similarity2> plain = fitSimilarity(pairs_, std::nullopt);
    if (!plain) return false;
    const double rms = rmsResidual(*plain, pairs_);
    if (rms < look_m_) return false;
    double best = kSwapGain * rms;
    std::optional<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t a = 0; a < worst.size(); ++a) {
      for (std::size_t b = a + 1; b < worst.size(); ++b) {
        std::vector<PointPair> trial = pairs_;
        std::swap(trial[worst[a]].target, trial[worst[b]].target);
        const Result<Similarity2> fit = fitSimilarity(trial, std::nullopt);
        if (!fit) continue;
        const double rms_trial = rmsResidual(*fit, trial);
        if (rms_trial >= best) continue;
        best = rms_trial;
        found = {worst[a], worst[b]};
      }
    }
    if (!found) return false;
    add({Kind::kSwapped, {used_[found->first]->id, used_[found->second]->id}, rms, best, {}});
    return true;
  }

  void findOutlier() {
    if (!input_.solution || used_.size() < kOutlierFrom) return;
    const AnchorFit* worst = nullptr;
    std::vector<double> errors;
    for (const AnchorFit& fit : input_.solution->anchors) {
      if (!fit.used || !std::isfinite(fit.leave_one_out_m)) continue;
      errors.push_back(fit.leave_one_out_m);
      if (!worst || fit.leave_one_out_m > worst->leave_one_out_m) worst = &fit;
    }
    if (worst && worst->leave_one_out_m > look_m_ && worst->leave_one_out_m > kOutlierRatio * median(errors))
      add({Kind::kOutlier, {worst->id}, worst->leave_one_out_m, 0.0, {}});
  }

  void findUnpredicted() {
    if (!input_.solution) return;
    const AlignmentSummary summary = summarize(input_.anchors, input_.solution->anchors);
    if (!isUnpredicted(summary, input_.limits, input_.slam_m_per_px)) return;
    add({Kind::kUnpredicted, {}, *summary.median_leave_one_out_m, 0.0, farthestNode()});
  }

  /// The corners of a building look alike from both ends. No residual tells which end is which when each anchor has
  /// another one opposite.
  void findHalfTurn(const Similarity2& robust) {
    if (used_.size() < 4) return;
    const Vector2d middle = middleOfAnchors();
    double extent = 0.0;
    for (const PointPair& pair : pairs_) extent = std::max(extent, (pair.source - middle).norm());
    std::vector<PointPair> turned = pairs_;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Vector2d opposite = 2.0 * middle - pairs_[i].source;
      const auto found = std::min_element(pairs_.begin(), pairs_.end(), [&](const PointPair& a, const PointPair& b) {
        return (a.source - opposite).squaredNorm() < (b.source - opposite).squaredNorm();
      });
      if ((found->source - opposite).norm() > kOppositeShare * extent) return;
      turned[i].target = found->target;
    }
    const Result<Similarity2> fit = fitSimilarity(turned, std::nullopt);
    if (!fit) return;
    const double rms_turned = rmsResidual(*fit, turned);
    const double rms = rmsResidual(robust, pairs_);
    if (rms_turned <= std::max(kHalfTurnLoss * rms, look_m_)) add({Kind::kHalfTurn, {}, rms_turned, rms, {}});
  }

  void findScale(const Similarity2& robust) {
    if (input_.scale.rule != ScaleRule::kToScale || std::abs(robust.scale - 1.0) < kScaleTolerance) return;
    const Vector2d mean = middleOfAnchors();
    std::vector<double> residuals;
    double spread = 0.0;
    for (const PointPair& pair : pairs_) {
      residuals.push_back((robust * pair.source - pair.target).norm());
      spread += (pair.source - mean).squaredNorm();
    }
    // Neighbouring places are wrong together in a SLAM map, so the usual 1/sqrt(n) would be too sure by far.
    const double independent = std::max(1.0, static_cast<double>(pairs_.size()) / kNeighbours);
    const double sigma =
        median(residuals) / std::sqrt(spread / static_cast<double>(pairs_.size())) / std::sqrt(independent);
    if (std::abs(robust.scale - 1.0) > kScaleSigmas * sigma)
      add({Kind::kScale, {}, robust.scale, sigma, {}, Side::kBlueprint, agreeingMap()});
  }

  /// Another SLAM map whose anchors say that the blueprint is true to scale: then it is this map that is not, and to
  /// rescale the blueprint would only move the fault.
  [[nodiscard]] std::string agreeingMap() const {
    for (const auto& [name, anchors] : input_.others) {
      std::vector<PointPair> pairs;
      for (const Anchor& anchor : anchors)
        if (anchor.enabled && isUsable(anchor.in_blueprint) && isUsable(anchor.in_slam))
          pairs.push_back({anchor.in_blueprint, anchor.in_slam});
      if (pairs.size() < 3) continue;
      const Result<Similarity2> fit = fitSimilarityRobust(pairs, std::nullopt);
      if (fit && std::abs(fit->scale - 1.0) < kScaleTolerance) return name;
    }
    return {};
  }

  void findFolds() {
    if (!input_.projector || !input_.nodes || input_.projector->foldedTileCount() == 0) return;
    Finding finding{Kind::kFolded, {}, static_cast<double>(input_.projector->foldedTileCount()), 0.0, {}};
    for (const Vector2d& node : *input_.nodes) {
      if (input_.projector->jacobian(node).determinant() > 0.0) continue;
      finding.place = node;
      break;
    }
    if (finding.place) {
      std::vector<const Anchor*> near = used_;
      const auto distance = [&](const Anchor* anchor) { return (anchor->in_blueprint - *finding.place).norm(); };
      std::partial_sort(near.begin(), near.begin() + 2, near.end(),
                        [&](const Anchor* a, const Anchor* b) { return distance(a) < distance(b); });
      finding.anchors = {near[0]->id, near[1]->id};
    }
    add(std::move(finding));
  }

  void findLine() {
    const Line line = lineThroughAnchors();
    if (line.width_over_length >= kLineWidth) return;
    add({Kind::kCollinear, {}, line.width_over_length, 0.0, bestNode([&](const Vector2d& node) {
           return std::abs(line.across.dot(node - line.middle));
         })});
  }

  void findRooms() {
    if (!input_.rooms || input_.rooms->rooms().size() < 2) return;
    const auto& rooms = input_.rooms->rooms();
    std::vector<bool> has_anchor(rooms.size(), false);
    bool all_known = true;
    for (const Anchor* anchor : used_) {
      const std::optional<std::size_t> room = input_.rooms->roomAt(anchor->in_blueprint);
      all_known = all_known && room.has_value();
      if (room) has_anchor[*room] = true;
    }
    const auto with_anchor = std::count(has_anchor.begin(), has_anchor.end(), true);
    std::optional<std::size_t> largest;
    for (std::size_t i = 0; i < rooms.size(); ++i)
      if (!has_anchor[i] && (!largest || rooms[i].area_m2 > rooms[*largest].area_m2)) largest = i;
    if (!largest) return;
    if (all_known && with_anchor == 1) return add({Kind::kOneRoom, {}, 0.0, 0.0, rooms[*largest].center});
    const auto empty = static_cast<double>(rooms.size()) - static_cast<double>(with_anchor);
    if (used_.size() >= 4)
      add({Kind::kEmptyRooms, {}, empty, static_cast<double>(rooms.size()), rooms[*largest].center});
  }

  void findSimilarity() {
    if (!input_.solution || used_.size() < kOutlierFrom) return;
    std::vector<double> bent;
    for (const AnchorFit& fit : input_.solution->anchors)
      if (fit.used && std::isfinite(fit.leave_one_out_m)) bent.push_back(fit.leave_one_out_m);
    std::vector<double> rigid;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      std::vector<PointPair> others = pairs_;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      const Result<Similarity2> fit = fitSimilarity(others, std::nullopt);
      if (!fit) return;
      rigid.push_back((*fit * pairs_[i].source - pairs_[i].target).norm());
    }
    // The answer may hold a share of the similarity itself and is then never far from it.
    constexpr double kAsGood = 1.1;
    constexpr double kNothing_m = 1e-3;
    if (median(rigid) <= ok_m_ && median(rigid) <= kAsGood * median(bent) + kNothing_m)
      add({Kind::kSimilarityEnough, {}, median(rigid), median(bent), {}});
  }

  void add(Finding finding) { findings_.push_back(std::move(finding)); }

  const DiagnosisInput& input_;
  std::vector<const Anchor*> used_;
  std::vector<PointPair> pairs_;
  double look_m_ = 0.0;
  double ok_m_ = 0.0;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> diagnose(const DiagnosisInput& input) {
  return Diagnosis(input).run();
}

}  // namespace cad2slam

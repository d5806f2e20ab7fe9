// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/normal_matrix.h"

#include "cad2slam/solver/blas.h"
#include "cad2slam/solver/normal_layout.h"
#include "cad2slam/solver/second_thread.h"

#include <cholmod.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <memory>
#include <utility>

namespace cad2slam {
namespace {

using Vector5d = Eigen::Matrix<double, 5, 1>;
using Matrix5d = Eigen::Matrix<double, 5, 5>;
using Matrix25d = Eigen::Matrix<double, 2, 5>;

constexpr std::size_t kMostChangedAnchors = 4;  // since a factor; each takes about a step of the minimiser
constexpr double kLeastHeld = 1e-4;             // of a place by all but the anchor that a factor gives up
constexpr std::size_t kManyNodes = 1500;        // worth a thread for their layout
constexpr int kFormColumns = 16;                // right-hand sides that share one walk through the factor
using FormRows = Eigen::Matrix<double, Eigen::Dynamic, kFormColumns, Eigen::RowMajor>;

double weightOf(const Objective& objective, const AnchorTerm& anchor, const double* x) {
  return objective.anchor_information *
         lossWeight(residualOf(objective, anchor, x).squaredNorm(), objective.loss_width_m);
}

bool isSameBlend(const NodeBlend& a, const NodeBlend& b) {
  return a.count == b.count && std::equal(a.nodes.begin(), a.nodes.begin() + a.count, b.nodes.begin()) &&
         std::equal(a.weights.begin(), a.weights.begin() + a.count, b.weights.begin());
}

}  // namespace

class NormalMatrix::Impl {
 public:
  Impl() = default;
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  bool analyse(const Objective& objective);
  bool factorise(const Objective& objective, const double* x, double damping);
  bool adaptFactor(const Objective& objective, const double* x);
  bool solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution);
  [[nodiscard]] std::vector<Eigen::Matrix4d> inverseForms(const std::vector<SparseColumns>& forms) const;
  [[nodiscard]] double operations() { return takeLayout() ? layout_->operations : 0.0; }
  [[nodiscard]] bool isOutOfMemory() { return !takeLayout(); }
  void forgetFactor() { factorised_.reset(); }
  [[nodiscard]] bool hasFactorFor(const Objective& objective) const {
    return factorised_ && factorised_->unknowns == objective.unknowns && nodes_ == objective.active_nodes;
  }

 private:
  struct FactorisedAnchor {
    NodeBlend blend;
    double weight = 0.0;
    std::array<Matrix25d, NodeBlend::kCapacity> derivatives;
  };
  struct FormWorkspace {
    FormRows rows;
    std::vector<bool> on_path;
  };
  struct FormBatch {
    std::vector<const SparseColumns*> forms;
    std::vector<Eigen::Matrix4d*> grams;
    int columns = 0;
  };
  using Columns = Eigen::Ref<const Eigen::MatrixXd>;
  [[nodiscard]] bool takeLayout();
  [[nodiscard]] static FactorisedAnchor atPoint(const Objective& objective, const AnchorTerm& anchor, const double* x);
  bool solveWithFactor(const Columns& right, Eigen::Ref<Eigen::MatrixXd> solution);
  [[nodiscard]] std::vector<int> pathsOf(const FormBatch& batch, std::vector<bool>& on_path) const;
  void solveBatch(const FormBatch& batch, FormWorkspace& workspace) const;
  template <int kUnknowns>
  void assemble(const Objective& objective, const double* x);
  template <int kUnknowns>
  void addBlock(std::uint32_t row_node, std::uint32_t column_node, const Matrix5d& block);

  std::future<std::shared_ptr<NormalLayout>> coming_layout_;
  std::shared_ptr<NormalLayout> layout_;      // as last analysed, unless one is coming
  std::shared_ptr<NormalLayout> factorised_;  // of the last factor, which may be of before the last edit
  std::vector<NodeIndex> nodes_;              // of the mesh that are factorised
  std::vector<FactorisedAnchor> anchors_;     // in the factor
  // Of anchors that are new since the factor or gone, see adaptFactor(): N^-1 J^T and (S^-1 + J N^-1 J^T)^-1.
  Eigen::MatrixXd changed_;
  Eigen::MatrixXd changed_core_;
  mutable std::array<FormWorkspace, 2> form_workspaces_;  // one for each thread
  Eigen::MatrixXd in_places_;                             // right-hand sides in the order of the matrix
  cholmod_dense* solution_ = nullptr;                     // workspaces that cholmod_solve2 reuses
  cholmod_dense* work_y_ = nullptr;
  cholmod_dense* work_e_ = nullptr;
  CholmodSession solving_;
};

NormalMatrix::Impl::~Impl() {
  cholmod_common* common = solving_.get();
  cholmod_free_dense(&solution_, common);
  cholmod_free_dense(&work_y_, common);
  cholmod_free_dense(&work_e_, common);
}

bool NormalMatrix::Impl::analyse(const Objective& objective) {
  static_cast<void>(takeLayout());  // of a solve that was over before it needed one
  Couplings couplings = couplingsOf(objective);
  if (layout_ && layout_->isFor(couplings, objective.unknowns)) return true;
  layout_.reset();
  // The factor of before often serves for all steps of a solve: what comes after it is laid out meanwhile.
  if (hasFactorFor(objective) && objective.nodeCount() >= kManyNodes) {
    coming_layout_ = onSecondThread([couplings, unknowns = objective.unknowns]() mutable {
      return NormalLayout::create(std::move(couplings), unknowns);
    });
  }
  if (!coming_layout_.valid()) layout_ = NormalLayout::create(std::move(couplings), objective.unknowns);
  return coming_layout_.valid() || layout_ != nullptr;
}

/// False: there was no memory for it.
bool NormalMatrix::Impl::takeLayout() {
  if (coming_layout_.valid()) layout_ = coming_layout_.get();
  return layout_ != nullptr;
}

NormalMatrix::Impl::FactorisedAnchor NormalMatrix::Impl::atPoint(const Objective& objective, const AnchorTerm& anchor,
                                                                 const double* x) {
  FactorisedAnchor at{anchor.blend, weightOf(objective, anchor, x), {}};
  for (std::size_t k = 0; k < anchor.blend.count; ++k) at.derivatives[k] = derivativeOf(objective, anchor, k, x);
  return at;
}

/// Adds to the block of these rows and columns, or to its transpose: whichever lies in the lower triangle.
template <int kUnknowns>
void NormalMatrix::Impl::addBlock(std::uint32_t row_node, std::uint32_t column_node, const Matrix5d& block) {
  auto* values = static_cast<double*>(layout_->matrix->x);
  const auto* starts = static_cast<const int*>(layout_->matrix->p);
  const std::uint32_t row = layout_->places[row_node];
  const std::uint32_t column = layout_->places[column_node];
  const auto columnOf = [&](std::uint32_t place, int q) {
    return values + starts[place * kUnknowns + static_cast<std::uint32_t>(q)];
  };
  if (row == column) {
    for (int q = 0; q < kUnknowns; ++q) {
      for (int p = q; p < kUnknowns; ++p) columnOf(row, q)[p - q] += block(p, q);
    }
    return;
  }
  const std::vector<std::uint32_t>& later = layout_->later[std::min(row, column)];
  const auto place = std::lower_bound(later.begin(), later.end(), std::max(row, column)) - later.begin();
  for (int q = 0; q < kUnknowns; ++q) {
    double* target = columnOf(std::min(row, column), q) + (kUnknowns - q) + place * kUnknowns;
    for (int p = 0; p < kUnknowns; ++p) target[p] += row > column ? block(p, q) : block(q, p);
  }
}

template <int kUnknowns>
void NormalMatrix::Impl::assemble(const Objective& objective, const double* x) {
  auto* values = static_cast<double*>(layout_->matrix->x);
  std::fill(values, values + static_cast<const int*>(layout_->matrix->p)[layout_->matrix->ncol], 0.0);
  const Vector5d smoothness =
      Vector5d(0.0, 0.0, objective.sqrt_lambda_theta, objective.sqrt_lambda_stretch, objective.sqrt_lambda_stretch)
          .array()
          .square();
  for (const EdgeTerm& edge : objective.edges) {
    const EdgeLinearisation at = linearise(objective, edge, x + edge.from * kUnknowns, x + edge.to * kUnknowns);
    Matrix5d own_from = at.from.transpose() * at.from;
    Matrix5d own_to = at.to.transpose() * at.to;
    own_from.diagonal() += smoothness;
    own_to.diagonal() += smoothness;
    addBlock<kUnknowns>(edge.from, edge.from, own_from);
    addBlock<kUnknowns>(edge.to, edge.to, own_to);
    Matrix5d across = at.from.transpose() * at.to;
    across.diagonal() -= smoothness;
    addBlock<kUnknowns>(edge.from, edge.to, across);
  }
  Matrix5d prior = Matrix5d::Zero();
  prior(3, 3) = prior(4, 4) = 2.0 * objective.sqrt_prior * objective.sqrt_prior;  // of (a_x - a_y)^2 + (a_x + a_y)^2
  for (std::uint32_t node = 0; node < objective.nodeCount(); ++node) {
    prior(2, 2) = objective.heading_prior.empty() ? 0.0 : objective.heading_prior[node] * objective.heading_prior[node];
    addBlock<kUnknowns>(node, node, prior);
  }
  anchors_.clear();
  for (const AnchorTerm& anchor : objective.anchors) {
    const FactorisedAnchor& at = anchors_.emplace_back(atPoint(objective, anchor, x));
    for (std::size_t i = 0; i < at.blend.count; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        addBlock<kUnknowns>(at.blend.nodes[i], at.blend.nodes[j],
                            at.weight * at.derivatives[i].transpose() * at.derivatives[j]);
      }
    }
  }
}

bool NormalMatrix::Impl::factorise(const Objective& objective, const double* x, double damping) {
  factorised_.reset();
  changed_.resize(0, 0);
  if (!takeLayout()) return false;
  if (objective.unknowns == kRigidUnknowns) {
    assemble<kRigidUnknowns>(objective, x);
  } else {
    assemble<kStretchUnknowns>(objective, x);
  }
  if (damping > 0.0) {
    auto* values = static_cast<double*>(layout_->matrix->x);
    const auto* starts = static_cast<const int*>(layout_->matrix->p);
    for (std::size_t column = 0; column < layout_->matrix->ncol; ++column) values[starts[column]] *= 1.0 + damping;
  }
  cholmod_common* common = layout_->session();
  cholmod_factor* factor = layout_->factor;
  if (cholmod_factorize(layout_->matrix, factor, common) == 0 || common->status != CHOLMOD_OK) return false;
  if (factor->minor != factor->n) return false;
  factorised_ = layout_;
  nodes_ = objective.active_nodes;
  return true;
}

/// The solution for each column of `right`, with the factor alone.
bool NormalMatrix::Impl::solveWithFactor(const Columns& right, Eigen::Ref<Eigen::MatrixXd> solution) {
  const std::vector<std::uint32_t>& places = factorised_->places;
  const int unknowns = factorised_->unknowns;
  in_places_.resize(right.rows(), right.cols());
  for (std::size_t node = 0; node < places.size(); ++node) {
    in_places_.middleRows(places[node] * unknowns, unknowns) =
        right.middleRows(static_cast<Eigen::Index>(node) * unknowns, unknowns);
  }
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(right.rows());
  view.ncol = static_cast<std::size_t>(right.cols());
  view.nzmax = view.nrow * view.ncol;
  view.d = view.nrow;
  view.x = in_places_.data();
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  if (cholmod_solve2(CHOLMOD_A, factorised_->factor, &view, nullptr, &solution_, nullptr, &work_y_, &work_e_,
                     solving_.get()) == 0) {
    return false;
  }
  const Eigen::Map<const Eigen::MatrixXd> solved(static_cast<const double*>(solution_->x), right.rows(), right.cols());
  for (std::size_t node = 0; node < places.size(); ++node) {
    solution.middleRows(static_cast<Eigen::Index>(node) * unknowns, unknowns) =
        solved.middleRows(places[node] * unknowns, unknowns);
  }
  return solution.allFinite();
}

/// By the identity of Woodbury: (N + J^T S J)^-1 = N^-1 - N^-1 J^T (S^-1 + J N^-1 J^T)^-1 J N^-1, where S holds the
/// weights W of new anchors and -W of those that are gone. With D = sign(S) + W^1/2 J N^-1 J^T W^1/2 the inverse in the
/// middle is W^1/2 D^-1 W^1/2, also for weights of zero. What is left without the anchors that are gone is positive
/// definite just where D has one negative eigenvalue for each of their rows.
bool NormalMatrix::Impl::adaptFactor(const Objective& objective, const double* x) {
  if (!hasFactorFor(objective)) return false;
  changed_.resize(0, 0);
  std::vector<FactorisedAnchor> changed;
  std::vector<bool> stays(anchors_.size(), false);
  for (const AnchorTerm& anchor : objective.anchors) {
    std::size_t same = 0;
    while (same < anchors_.size() && (stays[same] || !isSameBlend(anchors_[same].blend, anchor.blend))) ++same;
    if (same < anchors_.size()) {
      stays[same] = true;
    } else if (changed.size() < kMostChangedAnchors) {
      changed.push_back(atPoint(objective, anchor, x));
    } else {
      return false;
    }
  }
  const auto added_rows = static_cast<Eigen::Index>(2 * changed.size());
  for (std::size_t i = 0; i < anchors_.size(); ++i) {
    if (!stays[i]) changed.push_back(anchors_[i]);
  }
  if (changed.empty()) return true;
  if (changed.size() > kMostChangedAnchors) return false;

  const auto rows = static_cast<Eigen::Index>(2 * changed.size());
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(objective.size()), rows);
  Eigen::VectorXd root_weights(rows);
  for (std::size_t c = 0; c < changed.size(); ++c) {
    const auto first = static_cast<Eigen::Index>(2 * c);
    for (std::size_t k = 0; k < changed[c].blend.count; ++k) {
      jacobian.block(changed[c].blend.nodes[k] * objective.unknowns, first, objective.unknowns, 2) =
          changed[c].derivatives[k].leftCols(objective.unknowns).transpose();
    }
    root_weights.segment<2>(first).setConstant(std::sqrt(changed[c].weight));
  }
  Eigen::MatrixXd solved(jacobian.rows(), rows);
  if (!solveWithFactor(jacobian, solved)) return false;
  Eigen::MatrixXd middle = root_weights.asDiagonal() * (jacobian.transpose() * solved) * root_weights.asDiagonal();
  middle.diagonal().head(added_rows).array() += 1.0;
  middle.diagonal().tail(rows - added_rows).array() -= 1.0;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(middle);
  if (!modes.eigenvalues().allFinite()) return false;
  if ((modes.eigenvalues().array() < -kLeastHeld).count() != rows - added_rows) return false;
  changed_core_ = root_weights.asDiagonal() * modes.eigenvectors() * modes.eigenvalues().cwiseInverse().asDiagonal() *
                  modes.eigenvectors().transpose() * root_weights.asDiagonal();
  if (!changed_core_.allFinite()) return false;
  changed_ = std::move(solved);
  return true;
}

bool NormalMatrix::Impl::solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution) {
  solution.resize(right.size());
  if (!solveWithFactor(right, solution)) return false;
  if (changed_.cols() > 0) solution -= changed_ * (changed_core_ * (changed_.transpose() * right));
  return true;
}

/// The supernodes on the paths from the non-zeros to the root, in elimination order.
std::vector<int> NormalMatrix::Impl::pathsOf(const FormBatch& batch, std::vector<bool>& on_path) const {
  const cholmod_factor* factor = factorised_->factor;
  const auto* first_columns = static_cast<const int*>(factor->super);
  const auto* row_starts = static_cast<const int*>(factor->pi);
  const auto* row_numbers = static_cast<const int*>(factor->s);
  std::vector<int> path;
  on_path.resize(factor->nsuper, false);
  for (const SparseColumns* form : batch.forms) {
    for (const std::size_t row : form->rows) {
      int supernode = factorised_->supernodeOf(factorised_->placeOf(row));
      while (supernode >= 0 && !on_path[static_cast<std::size_t>(supernode)]) {
        on_path[static_cast<std::size_t>(supernode)] = true;
        path.push_back(supernode);
        const int own = first_columns[supernode + 1] - first_columns[supernode];
        const int all = row_starts[supernode + 1] - row_starts[supernode];
        supernode = all > own
                        ? factorised_->supernodeOf(static_cast<std::size_t>(row_numbers[row_starts[supernode] + own]))
                        : -1;
      }
    }
  }
  for (const int supernode : path) on_path[static_cast<std::size_t>(supernode)] = false;
  std::sort(path.begin(), path.end());
  return path;
}

/// Forward substitution for up to kFormColumns columns at once, side by side in the rows of the workspace.
void NormalMatrix::Impl::solveBatch(const FormBatch& batch, FormWorkspace& workspace) const {
  const cholmod_factor* factor = factorised_->factor;
  const auto* first_columns = static_cast<const int*>(factor->super);
  const auto* row_starts = static_cast<const int*>(factor->pi);
  const auto* value_starts = static_cast<const int*>(factor->px);
  const auto* row_numbers = static_cast<const int*>(factor->s);
  const auto* values = static_cast<const double*>(factor->x);
  // All zero between calls: only rows of the path are ever written, and they are cleared again below.
  FormRows& work = workspace.rows;
  if (work.rows() != static_cast<Eigen::Index>(factor->n)) {
    work = FormRows::Zero(static_cast<Eigen::Index>(factor->n), kFormColumns);
  }
  Eigen::Index column = 0;
  for (const SparseColumns* form : batch.forms) {
    for (std::size_t k = 0; k < form->rows.size(); ++k) {
      work.row(static_cast<Eigen::Index>(factorised_->placeOf(form->rows[k]))).segment(column, form->count) +=
          form->values[k].head(form->count).transpose();
    }
    column += form->count;
  }
  FormRows below;
  for (const int supernode : pathsOf(batch, workspace.on_path)) {
    const int first = first_columns[supernode];
    const int own = first_columns[supernode + 1] - first;
    const int all = row_starts[supernode + 1] - row_starts[supernode];
    const double* block = values + value_starts[supernode];
    auto mine = work.middleRows(first, own);
    solveLowerInPlace<kFormColumns>(block, all, own, mine.data());
    Eigen::Index begin = 0;
    for (std::size_t k = 0; k < batch.forms.size(); ++k) {
      const Eigen::Index count = batch.forms[k]->count;
      const auto part = mine.middleCols(begin, count);
      batch.grams[k]->topLeftCorner(count, count).noalias() += part.transpose().lazyProduct(part);
      begin += count;
    }
    below.resize(all - own, kFormColumns);
    if (all > own) multiply<kFormColumns>(block + own, all, all - own, own, mine.data(), below.data());
    mine.setZero();
    const int* rows = row_numbers + row_starts[supernode] + own;
    for (int k = 0; k < all - own; ++k) work.row(rows[k]) -= below.row(k);
  }
}

std::vector<Eigen::Matrix4d> NormalMatrix::Impl::inverseForms(const std::vector<SparseColumns>& forms) const {
  std::vector<Eigen::Matrix4d> grams(forms.size(), Eigen::Matrix4d::Zero());
  // Neighbours in the elimination order share most of their paths.
  std::vector<std::pair<std::size_t, std::size_t>> order;
  for (std::size_t k = 0; k < forms.size(); ++k) {
    std::size_t last = 0;
    for (const std::size_t row : forms[k].rows) last = std::max(last, factorised_->placeOf(row));
    order.emplace_back(last, k);
  }
  std::sort(order.begin(), order.end());
  std::vector<FormBatch> batches;
  for (const auto& [last, k] : order) {
    if (batches.empty() || batches.back().columns + forms[k].count > kFormColumns) batches.emplace_back();
    FormBatch& batch = batches.back();
    batch.forms.push_back(&forms[k]);
    batch.grams.push_back(&grams[k]);
    batch.columns += forms[k].count;
  }
  const auto solveRange = [&](std::size_t begin, std::size_t end, FormWorkspace& workspace) {
    for (std::size_t k = begin; k < end; ++k) solveBatch(batches[k], workspace);
  };
  constexpr std::size_t kWorthAThread = 60'000;  // rows; small meshes are mostly solved aside of a large one
  std::future<void> second_half;
  if (batches.size() * factorised_->factor->n >= kWorthAThread) {
    second_half = onSecondThread([&] { solveRange(batches.size() / 2, batches.size(), form_workspaces_[1]); });
  }
  const std::size_t middle = second_half.valid() ? batches.size() / 2 : batches.size();
  solveRange(0, middle, form_workspaces_[0]);
  if (second_half.valid()) second_half.get();
  return grams;
}

NormalMatrix::NormalMatrix() : impl_(std::make_unique<Impl>()) {}
NormalMatrix::~NormalMatrix() = default;
NormalMatrix::NormalMatrix(NormalMatrix&&) noexcept = default;
NormalMatrix& NormalMatrix::operator=(NormalMatrix&&) noexcept = default;

bool NormalMatrix::analyse(const Objective& objective) {
  return impl_->analyse(objective);
}
double NormalMatrix::operations() const {
  return impl_->operations();
}
bool NormalMatrix::isOutOfMemory() const {
  return impl_->isOutOfMemory();
}
bool NormalMatrix::factorise(const Objective& objective, const double* x, double damping) {
  return impl_->factorise(objective, x, damping);
}
void NormalMatrix::forgetFactor() {
  impl_->forgetFactor();
}
bool NormalMatrix::hasFactorFor(const Objective& objective) const {
  return impl_->hasFactorFor(objective);
}
bool NormalMatrix::adaptFactor(const Objective& objective, const double* x) {
  return impl_->adaptFactor(objective, x);
}
bool NormalMatrix::solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution) {
  return impl_->solve(right, solution);
}
std::vector<Eigen::Matrix4d> NormalMatrix::inverseForms(const std::vector<SparseColumns>& forms) const {
  return impl_->inverseForms(forms);
}

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/normal_matrix.h"

#include "cad2slam/solver/blas.h"
#include "cad2slam/solver/second_thread.h"

#include <cholmod.h>

#include <algorithm>
#include <array>
#include <future>
#include <numeric>
#include <utility>

namespace cad2slam {
namespace {

using Vector5d = Eigen::Matrix<double, 5, 1>;
using Matrix5d = Eigen::Matrix<double, 5, 5>;
using Matrix25d = Eigen::Matrix<double, 2, 5>;

constexpr int kFormColumns = 16;  // right-hand sides that share one walk through the factor
using FormRows = Eigen::Matrix<double, Eigen::Dynamic, kFormColumns, Eigen::RowMajor>;

/// cholmod_common with our settings; no printing, no abort.
class Session {
 public:
  Session() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_NATURAL;  // the matrix comes in its order of elimination
    common_.postorder = 0;
    common_.final_ll = 1;
    // Supernodes of eight to two dozen mesh nodes, with some zeros in them. CHOLMOD's own choice is made for one
    // unknown a node: three times as many supernodes, whose bookkeeping then takes longer than the arithmetic.
    common_.nrelax[0] = 40;
    common_.nrelax[1] = 60;
    common_.nrelax[2] = 120;
    common_.zrelax[0] = 0.8;
    common_.zrelax[1] = 0.4;
    common_.zrelax[2] = 0.1;
  }
  ~Session() { cholmod_finish(&common_); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_{};
};

/// Couplings between active nodes: for each node the larger nodes it shares a term with, sorted.
using Couplings = std::vector<std::vector<std::uint32_t>>;

Couplings couplingsOf(const Objective& objective) {
  Couplings couplings(objective.nodeCount());
  const auto couple = [&couplings](std::uint32_t a, std::uint32_t b) {
    if (a != b) couplings[std::min(a, b)].push_back(std::max(a, b));
  };
  for (const EdgeTerm& edge : objective.edges) couple(edge.from, edge.to);
  for (const AnchorTerm& anchor : objective.anchors) {
    for (std::size_t i = 0; i < anchor.blend.count; ++i) {
      for (std::size_t j = 0; j < i; ++j) couple(anchor.blend.nodes[i], anchor.blend.nodes[j]);
    }
  }
  for (std::vector<std::uint32_t>& larger : couplings) {
    std::sort(larger.begin(), larger.end());
    larger.erase(std::unique(larger.begin(), larger.end()), larger.end());
  }
  return couplings;
}

/// The pattern of a symmetric matrix with a block of b x b for each coupling, as lower triangle in scalar columns: of
/// node j first its own block from the diagonal down, then its larger neighbours. Null: out of memory.
cholmod_sparse* lowerTriangle(const Couplings& couplings, std::size_t b, int xtype, cholmod_common* common) {
  const std::size_t n = couplings.size() * b;
  std::size_t entries = 0;
  for (const auto& larger : couplings) entries += b * (b + 1) / 2 + b * b * larger.size();
  cholmod_sparse* matrix = cholmod_allocate_sparse(n, n, entries, 1, 1, -1, xtype, common);
  if (matrix == nullptr) return nullptr;
  auto* starts = static_cast<int*>(matrix->p);
  auto* rows = static_cast<int*>(matrix->i);
  int at = 0;
  for (std::size_t node = 0; node < couplings.size(); ++node) {
    for (std::size_t q = 0; q < b; ++q) {
      starts[node * b + q] = at;
      for (std::size_t p = q; p < b; ++p) rows[at++] = static_cast<int>(node * b + p);
      for (const std::uint32_t larger : couplings[node]) {
        for (std::size_t p = 0; p < b; ++p) rows[at++] = static_cast<int>(larger * b + p);
      }
    }
  }
  starts[n] = at;
  return matrix;
}

/// For each node its place in an order that keeps L sparse: approximate minimum degree of all couplings, in 1 ms for
/// 4 000 nodes. Nested dissection of the mesh alone takes twenty times as long and overlooks that each anchor ties nine
/// nodes together: with 200 anchors in an open plan, L takes eight times the arithmetic. Empty: out of memory.
std::vector<std::uint32_t> fillReducingPlaces(const Couplings& couplings) {
  Session session;
  cholmod_common* common = session.get();
  common->supernodal = CHOLMOD_SIMPLICIAL;
  common->method[0].ordering = CHOLMOD_AMD;
  common->postorder = 1;
  cholmod_sparse* graph = lowerTriangle(couplings, 1, CHOLMOD_PATTERN, common);
  if (graph == nullptr) return {};
  cholmod_factor* analysed = cholmod_analyze(graph, common);
  cholmod_free_sparse(&graph, common);
  if (analysed == nullptr) return {};
  std::vector<std::uint32_t> places(couplings.size());
  const auto* order = static_cast<const int*>(analysed->Perm);
  for (std::uint32_t place = 0; place < places.size(); ++place) places[static_cast<std::size_t>(order[place])] = place;
  cholmod_free_factor(&analysed, common);
  return places;
}

/// The same couplings between places.
Couplings renumbered(const Couplings& couplings, const std::vector<std::uint32_t>& places) {
  Couplings renumbered(couplings.size());
  for (std::size_t node = 0; node < couplings.size(); ++node) {
    for (const std::uint32_t larger : couplings[node]) {
      const auto [first, second] = std::minmax(places[node], places[larger]);
      renumbered[first].push_back(second);
    }
  }
  for (std::vector<std::uint32_t>& larger : renumbered) std::sort(larger.begin(), larger.end());
  return renumbered;
}

}  // namespace

class NormalMatrix::Impl {
 public:
  ~Impl() { clear(); }
  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  bool analyse(const Objective& objective);
  bool factorise(const Objective& objective, const double* x, double damping);
  bool solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution);
  [[nodiscard]] std::vector<Eigen::Matrix4d> inverseForms(const std::vector<SparseColumns>& forms) const;
  [[nodiscard]] double operations() const { return operations_; }
  void forgetFactor() { factorised_ = false; }
  [[nodiscard]] bool hasFactor(std::size_t size) const { return factorised_ && matrix_->nrow == size; }

 private:
  void clear();
  struct FormWorkspace {
    FormRows rows;
    std::vector<bool> on_path;
  };
  struct FormBatch {
    std::vector<const SparseColumns*> forms;
    std::vector<Eigen::Matrix4d*> grams;
    int columns = 0;
  };
  [[nodiscard]] std::vector<int> pathsOf(const FormBatch& batch, std::vector<bool>& on_path) const;
  void solveBatch(const FormBatch& batch, FormWorkspace& workspace) const;
  template <int kUnknowns>
  void assemble(const Objective& objective, const double* x);
  template <int kUnknowns>
  void addBlock(std::uint32_t row_node, std::uint32_t column_node, const Matrix5d& block);
  [[nodiscard]] int supernodeOf(std::size_t column) const { return column_supernode_[column]; }
  [[nodiscard]] std::size_t placeOf(std::size_t unknown) const {
    const auto b = static_cast<std::size_t>(unknowns_);
    return places_[unknown / b] * b + unknown % b;
  }

  Session session_;
  // The matrix is kept in its order of elimination, so that CHOLMOD need not copy it for each factorisation.
  Couplings couplings_;                // between nodes
  Couplings later_;                    // between places
  std::vector<std::uint32_t> places_;  // of nodes in the order
  int unknowns_ = 0;
  cholmod_sparse* matrix_ = nullptr;
  cholmod_factor* factor_ = nullptr;
  bool factorised_ = false;
  double operations_ = 0.0;
  std::vector<int> column_supernode_;
  mutable std::array<FormWorkspace, 2> form_workspaces_;  // one for each thread
  Eigen::VectorXd in_places_;                             // a right-hand side in the order of the matrix
  cholmod_dense* solution_ = nullptr;                     // workspaces that cholmod_solve2 reuses
  cholmod_dense* work_y_ = nullptr;
  cholmod_dense* work_e_ = nullptr;
};

void NormalMatrix::Impl::clear() {
  cholmod_common* common = session_.get();
  cholmod_free_sparse(&matrix_, common);
  cholmod_free_factor(&factor_, common);
  cholmod_free_dense(&solution_, common);
  cholmod_free_dense(&work_y_, common);
  cholmod_free_dense(&work_e_, common);
  factorised_ = false;
}

bool NormalMatrix::Impl::analyse(const Objective& objective) {
  Couplings couplings = couplingsOf(objective);
  if (factor_ != nullptr && unknowns_ == objective.unknowns && couplings == couplings_) return true;
  clear();
  couplings_ = std::move(couplings);
  unknowns_ = objective.unknowns;
  places_ = fillReducingPlaces(couplings_);
  if (places_.empty()) return false;
  later_ = renumbered(couplings_, places_);
  matrix_ = lowerTriangle(later_, static_cast<std::size_t>(unknowns_), CHOLMOD_REAL, session_.get());
  if (matrix_ == nullptr) return false;
  factor_ = cholmod_analyze(matrix_, session_.get());
  if (factor_ == nullptr || factor_->is_super == 0) return false;
  operations_ = session_.get()->fl;

  column_supernode_.resize(factor_->n);
  const auto* first_columns = static_cast<const int*>(factor_->super);
  for (std::size_t s = 0; s < factor_->nsuper; ++s) {
    std::fill(column_supernode_.begin() + first_columns[s], column_supernode_.begin() + first_columns[s + 1],
              static_cast<int>(s));
  }
  return true;
}

/// Adds to the block of these rows and columns, or to its transpose: whichever lies in the lower triangle.
template <int kUnknowns>
void NormalMatrix::Impl::addBlock(std::uint32_t row_node, std::uint32_t column_node, const Matrix5d& block) {
  auto* values = static_cast<double*>(matrix_->x);
  const auto* starts = static_cast<const int*>(matrix_->p);
  const std::uint32_t row = places_[row_node];
  const std::uint32_t column = places_[column_node];
  const auto columnOf = [&](std::uint32_t place, int q) {
    return values + starts[place * kUnknowns + static_cast<std::uint32_t>(q)];
  };
  if (row == column) {
    for (int q = 0; q < kUnknowns; ++q) {
      for (int p = q; p < kUnknowns; ++p) columnOf(row, q)[p - q] += block(p, q);
    }
    return;
  }
  const std::vector<std::uint32_t>& later = later_[std::min(row, column)];
  const auto place = std::lower_bound(later.begin(), later.end(), std::max(row, column)) - later.begin();
  for (int q = 0; q < kUnknowns; ++q) {
    double* target = columnOf(std::min(row, column), q) + (kUnknowns - q) + place * kUnknowns;
    for (int p = 0; p < kUnknowns; ++p) target[p] += row > column ? block(p, q) : block(q, p);
  }
}

template <int kUnknowns>
void NormalMatrix::Impl::assemble(const Objective& objective, const double* x) {
  auto* values = static_cast<double*>(matrix_->x);
  std::fill(values, values + static_cast<const int*>(matrix_->p)[matrix_->ncol], 0.0);
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
  for (const AnchorTerm& anchor : objective.anchors) {
    const double weight = objective.anchor_information *
                          lossWeight(residualOf(objective, anchor, x).squaredNorm(), objective.loss_width_m);
    std::array<Matrix25d, NodeBlend::kCapacity> derivatives;
    for (std::size_t k = 0; k < anchor.blend.count; ++k) derivatives[k] = derivativeOf(objective, anchor, k, x);
    for (std::size_t i = 0; i < anchor.blend.count; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        addBlock<kUnknowns>(anchor.blend.nodes[i], anchor.blend.nodes[j],
                            weight * derivatives[i].transpose() * derivatives[j]);
      }
    }
  }
}

bool NormalMatrix::Impl::factorise(const Objective& objective, const double* x, double damping) {
  factorised_ = false;
  if (unknowns_ == kRigidUnknowns) {
    assemble<kRigidUnknowns>(objective, x);
  } else {
    assemble<kStretchUnknowns>(objective, x);
  }
  if (damping > 0.0) {
    auto* values = static_cast<double*>(matrix_->x);
    const auto* starts = static_cast<const int*>(matrix_->p);
    for (std::size_t column = 0; column < matrix_->ncol; ++column) values[starts[column]] *= 1.0 + damping;
  }
  cholmod_common* common = session_.get();
  if (cholmod_factorize(matrix_, factor_, common) == 0 || common->status != CHOLMOD_OK) return false;
  factorised_ = factor_->minor == factor_->n;
  return factorised_;
}

bool NormalMatrix::Impl::solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution) {
  in_places_.resize(right.size());
  for (std::size_t node = 0; node < places_.size(); ++node) {
    in_places_.segment(places_[node] * unknowns_, unknowns_) =
        right.segment(static_cast<Eigen::Index>(node) * unknowns_, unknowns_);
  }
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(right.size());
  view.ncol = 1;
  view.nzmax = view.nrow;
  view.d = view.nrow;
  view.x = in_places_.data();
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  if (cholmod_solve2(CHOLMOD_A, factor_, &view, nullptr, &solution_, nullptr, &work_y_, &work_e_, session_.get()) ==
      0) {
    return false;
  }
  const Eigen::Map<const Eigen::VectorXd> solved(static_cast<const double*>(solution_->x), right.size());
  solution.resize(right.size());
  for (std::size_t node = 0; node < places_.size(); ++node) {
    solution.segment(static_cast<Eigen::Index>(node) * unknowns_, unknowns_) =
        solved.segment(places_[node] * unknowns_, unknowns_);
  }
  return solution.allFinite();
}

/// The supernodes on the paths from the non-zeros to the root, in elimination order.
std::vector<int> NormalMatrix::Impl::pathsOf(const FormBatch& batch, std::vector<bool>& on_path) const {
  const auto* first_columns = static_cast<const int*>(factor_->super);
  const auto* row_starts = static_cast<const int*>(factor_->pi);
  const auto* row_numbers = static_cast<const int*>(factor_->s);
  std::vector<int> path;
  on_path.resize(factor_->nsuper, false);
  for (const SparseColumns* form : batch.forms) {
    for (const std::size_t row : form->rows) {
      int supernode = supernodeOf(placeOf(row));
      while (supernode >= 0 && !on_path[static_cast<std::size_t>(supernode)]) {
        on_path[static_cast<std::size_t>(supernode)] = true;
        path.push_back(supernode);
        const int own = first_columns[supernode + 1] - first_columns[supernode];
        const int all = row_starts[supernode + 1] - row_starts[supernode];
        supernode = all > own ? supernodeOf(static_cast<std::size_t>(row_numbers[row_starts[supernode] + own])) : -1;
      }
    }
  }
  for (const int supernode : path) on_path[static_cast<std::size_t>(supernode)] = false;
  std::sort(path.begin(), path.end());
  return path;
}

/// Forward substitution for up to kFormColumns columns at once, side by side in the rows of the workspace.
void NormalMatrix::Impl::solveBatch(const FormBatch& batch, FormWorkspace& workspace) const {
  const auto* first_columns = static_cast<const int*>(factor_->super);
  const auto* row_starts = static_cast<const int*>(factor_->pi);
  const auto* value_starts = static_cast<const int*>(factor_->px);
  const auto* row_numbers = static_cast<const int*>(factor_->s);
  const auto* values = static_cast<const double*>(factor_->x);
  // All zero between calls: only rows of the path are ever written, and they are cleared again below.
  FormRows& work = workspace.rows;
  if (work.rows() != static_cast<Eigen::Index>(factor_->n)) {
    work = FormRows::Zero(static_cast<Eigen::Index>(factor_->n), kFormColumns);
  }
  Eigen::Index column = 0;
  for (const SparseColumns* form : batch.forms) {
    for (std::size_t k = 0; k < form->rows.size(); ++k) {
      work.row(static_cast<Eigen::Index>(placeOf(form->rows[k]))).segment(column, form->count) +=
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
    for (const std::size_t row : forms[k].rows) last = std::max(last, placeOf(row));
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
  if (batches.size() * factor_->n >= kWorthAThread) {
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
bool NormalMatrix::factorise(const Objective& objective, const double* x, double damping) {
  return impl_->factorise(objective, x, damping);
}
void NormalMatrix::forgetFactor() {
  impl_->forgetFactor();
}
bool NormalMatrix::hasFactorFor(const Objective& objective) const {
  return impl_->hasFactor(objective.size());
}
bool NormalMatrix::solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution) {
  return impl_->solve(right, solution);
}
std::vector<Eigen::Matrix4d> NormalMatrix::inverseForms(const std::vector<SparseColumns>& forms) const {
  return impl_->inverseForms(forms);
}

}  // namespace cad2slam

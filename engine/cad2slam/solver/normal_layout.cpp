// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/normal_layout.h"

#include <algorithm>
#include <utility>

namespace cad2slam {
namespace {

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
  CholmodSession session;
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

CholmodSession::CholmodSession() {
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

NormalLayout::~NormalLayout() {
  cholmod_free_sparse(&matrix, session_.get());
  cholmod_free_factor(&factor, session_.get());
}

std::shared_ptr<NormalLayout> NormalLayout::create(Couplings couplings, int unknowns) {
  std::shared_ptr<NormalLayout> layout(new NormalLayout(std::move(couplings), unknowns));
  layout->places = fillReducingPlaces(layout->couplings_);
  if (layout->places.empty()) return nullptr;
  layout->later = renumbered(layout->couplings_, layout->places);
  layout->matrix = lowerTriangle(layout->later, static_cast<std::size_t>(unknowns), CHOLMOD_REAL, layout->session());
  if (layout->matrix == nullptr) return nullptr;
  layout->factor = cholmod_analyze(layout->matrix, layout->session());
  const cholmod_factor* factor = layout->factor;
  if (factor == nullptr || factor->is_super == 0) return nullptr;
  layout->operations = layout->session()->fl;

  layout->column_supernode_.resize(factor->n);
  const auto* first_columns = static_cast<const int*>(factor->super);
  for (std::size_t s = 0; s < factor->nsuper; ++s) {
    std::fill(layout->column_supernode_.begin() + first_columns[s],
              layout->column_supernode_.begin() + first_columns[s + 1], static_cast<int>(s));
  }
  return layout;
}

}  // namespace cad2slam

// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cholmod.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "cad2slam/solver/objective.h"

namespace cad2slam {

/// cholmod_common with our settings; no printing, no abort.
class CholmodSession {
 public:
  CholmodSession();
  ~CholmodSession() { cholmod_finish(&common_); }
  CholmodSession(const CholmodSession&) = delete;
  CholmodSession& operator=(const CholmodSession&) = delete;
  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_{};
};

/// Couplings between active nodes: for each node the larger nodes it shares a term with, sorted.
using Couplings = std::vector<std::vector<std::uint32_t>>;
[[nodiscard]] Couplings couplingsOf(const Objective& objective);

/// Where the entries of a normal matrix lie, in its order of elimination, so that CHOLMOD need not copy it for each
/// factorisation; and the factor.
class NormalLayout {
 public:
  /// Null: out of memory.
  static std::shared_ptr<NormalLayout> create(Couplings couplings, int unknowns);
  ~NormalLayout();
  NormalLayout(const NormalLayout&) = delete;
  NormalLayout& operator=(const NormalLayout&) = delete;

  [[nodiscard]] bool isFor(const Couplings& couplings, int unknowns_of_node) const {
    return unknowns_of_node == unknowns && couplings == couplings_;
  }
  /// Of a thread that works with the layout; another one may make the next layout meanwhile.
  [[nodiscard]] cholmod_common* session() const { return session_.get(); }
  [[nodiscard]] std::size_t placeOf(std::size_t unknown) const {
    const auto b = static_cast<std::size_t>(unknowns);
    return places[unknown / b] * b + unknown % b;
  }
  [[nodiscard]] int supernodeOf(std::size_t column) const { return column_supernode_[column]; }

  const int unknowns;                 // of a node
  Couplings later;                    // between places
  std::vector<std::uint32_t> places;  // of nodes in the order
  double operations = 0.0;
  cholmod_sparse* matrix = nullptr;
  cholmod_factor* factor = nullptr;

 private:
  NormalLayout(Couplings couplings, int unknowns_of_node)
      : unknowns(unknowns_of_node), couplings_(std::move(couplings)) {}

  Couplings couplings_;  // between nodes
  mutable CholmodSession session_;
  std::vector<int> column_supernode_;
};

}  // namespace cad2slam

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

/// [-] What a query of the tree costs on average, in nodes and leaves visited [MacDonald90].
double compute_query_cost(const AabbTree& tree) noexcept;

/// Follows how costly the queries of a tree become while its surface deforms, a part of the tree at
/// a time, so that no tick pays for all of it.
class TreeCost {
 public:
  static constexpr int kRound = 64;  ///< calls of follow() at most that see the whole tree
  /// A tree whose cost has grown by this is worth building again.
  static constexpr double kWorthRebuilding = 1.5;

  TreeCost() = default;
  /// From now on, against what this tree costs now.
  explicit TreeCost(const AabbTree& tree) noexcept;

  /// Measures the next part; call it once after every refit of the same tree.
  void follow(const AabbTree& tree) noexcept;

  /// [-] The cost over that at the start, as the last whole round found it; 1 before that.
  double growth() const noexcept { return growth_; }

 private:
  double start_ = 0.0;   // the cost
  double growth_ = 1.0;  // of it
  double sum_ = 0.0;     // [m²] of the round so far
  std::size_t next_ = 0;
};

}  // namespace palpate

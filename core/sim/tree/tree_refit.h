// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "palpate/sim/base/cache_aligned.h"

namespace palpate {

/// How a tree follows its surface: which corners bound each leaf, and which boxes each node.
///
/// Corners that the triangles of a leaf share are read once, and every list has one of two fixed
/// lengths, so that the sweep has no branch to guess wrongly. Boxes are rows: those of the nodes
/// in their sequence, then those of the leaves with few corners, of the leaves with many, and one
/// that is empty.
struct TreeRefit {
  static constexpr std::size_t kFew = 6;
  static constexpr std::size_t kMany = 12;

  std::vector<std::array<int, kFew>> few;      ///< filled up with a corner of the same leaf
  std::vector<std::array<int, kMany>> many;    ///< likewise
  std::vector<std::array<int, 8>> child_rows;  ///< per node
  CacheAligned<std::array<double, 8>> rows;    ///< [m] low and high, a fourth number unused

  // the part of it that is followed where not everything moves
  std::vector<int> first_row;                ///< of each particle in leaf_rows, and the end
  std::vector<int> leaf_rows;                ///< rows of the leaves with that particle
  std::vector<int> moving;                   ///< per row: of its corners that move; nodes 0 or 1
  std::vector<int> moving_few, moving_many;  ///< which of the lists; room for all
  std::vector<int> moving_nodes;             ///< children before parents
  std::size_t few_count = 0, many_count = 0, node_count = 0;  ///< that move
  bool listed = true;                                         ///< the lists are those of `moving`

  /// A refit is so many steps: a leaf with few corners each, with many, and then a node each.
  std::size_t step_count() const noexcept { return few.size() + many.size() + child_rows.size(); }
};

}  // namespace palpate

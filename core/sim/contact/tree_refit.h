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
  std::vector<std::array<int, 4>> child_rows;  ///< per node
  CacheAligned<std::array<double, 8>> rows;    ///< [m] low and high, a fourth number unused
};

}  // namespace palpate

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// Pairs of triangles whose boxes overlap that are checked before giving up: some seconds of
/// work. The worst real organ seen (33 nested parts, 164,000 triangles) needs a tenth of it.
inline constexpr std::int64_t kPairBudget = 30'000'000;

/// Triangles that cross or overlap another one, ascending; triangles that only share a corner or
/// an edge, as neighbours do, do not count. Predicates are exact. Works on any list of triangles,
/// manifold or not. nullopt where more than `pair_budget` pairs would have to be checked.
std::optional<std::vector<int>> find_self_intersecting_faces(
    const SurfaceMesh& mesh, std::int64_t pair_budget = kPairBudget);

/// Which groups of triangles cross which, and which triangles cross others of their own group.
struct CrossingGroups {
  std::vector<std::array<int, 2>> pairs;  ///< groups, each pair once and ascending
  std::vector<int> own_faces;             ///< ascending
};

/// The same by groups: `group` has a number for each triangle. Corners and edges that lie in one
/// place are shared, whatever the numbers of their vertices.
std::optional<CrossingGroups> find_crossing_groups(const SurfaceMesh& mesh,
                                                   std::span<const int> group,
                                                   std::int64_t pair_budget = kPairBudget);

}  // namespace palpate::authoring

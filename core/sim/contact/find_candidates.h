// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/contact_lanes.h"
#include "palpate/sim/contact/tool.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

/// Triangles the tool may touch during one tick, ascending, with the area of each [m²].
struct Candidates {
  explicit Candidates(int capacity = 0)
      : triangles(static_cast<std::size_t>(capacity)), areas(static_cast<std::size_t>(capacity)) {}

  std::vector<int> triangles;  ///< capacity; the triangle count of the tissue is always enough
  std::vector<double> areas;   ///< [m²] at rest, so that pressing does not change the law
  int count = 0;
  Vec3 from = Vec3::Zero();  ///< [m] the path they were looked for along
  Vec3 to = Vec3::Zero();    ///< [m]
  ContactLanes lanes;        ///< balance_tool's vector code and its work space; may be empty
};
static_assert(alignof(Candidates) == 8);

/// How far tissue and tool may close in on each other within one tick beside the tool's own path
/// [m].
inline constexpr double kCandidateMargin = 1.2e-3;

/// Finds every triangle within radius + kCandidateMargin of the path from the tool's last position
/// to where the hand is now. Once per tick; the contacts themselves are found in every substep.
/// `rest_areas` [m²] per triangle of the tissue.
void find_candidates(const AabbTree& tree, std::span<const Vec3> x, const Tool& tool,
                     const Vec3& tool_position, const Vec3& hand_position,
                     std::span<const double> rest_areas, Candidates& candidates) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/find_candidates.h"

#include <algorithm>

#include "palpate/sim/tree/queries.h"

namespace palpate {

void find_candidates(const AabbTree& tree, std::span<const Vec3> x, const Tool& tool,
                     const Vec3& tool_position, const Vec3& hand_position,
                     std::span<const double> rest_areas, Candidates& candidates) noexcept {
  const int found = find_near_segment(tree, x, tool_position, hand_position,
                                      tool.radius + kCandidateMargin, candidates.triangles);
  candidates.from = tool_position;
  candidates.to = hand_position;
  candidates.near.knows_compliance = candidates.near.found = false;
  candidates.count = std::min(found, static_cast<int>(candidates.triangles.size()));
  for (std::size_t i = 0; i < static_cast<std::size_t>(candidates.count); ++i) {
    candidates.areas[i] = rest_areas[static_cast<std::size_t>(candidates.triangles[i])];
  }
}

}  // namespace palpate

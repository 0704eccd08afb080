// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/broad_phase.h"

#include <algorithm>
#include <limits>

#include "palpate/sim/tree/private/box.h"
#include "palpate/sim/tree/private/crossing.h"
#include "palpate/sim/tree/private/tree_kernels.h"

namespace palpate {

int find_leaves_near_segment(const AabbTree& tree, const Vec3& from, const Vec3& to, double radius,
                             std::span<int> out) noexcept {
  if (tree.nodes().empty() || !(radius >= 0.0) || !from.allFinite() || !to.allFinite()) return 0;
  const Segment segment{from, to - from, 1.0,
                        radius + compute_slack(tree.low(), tree.high(), from, to)};
  return tree_kernels::best().list_near_segment(tree, segment, out);
}

void choose_candidates(const AabbTree& tree, std::span<const Vec3> x, const Tool& tool,
                       const Vec3& tool_position, const Vec3& hand_position,
                       std::span<const double> rest_areas, std::span<const int> broad_candidates,
                       Candidates& candidates) noexcept {
  const double slack = compute_slack(tree.low(), tree.high(), tool_position, hand_position);
  const Segment segment{tool_position, hand_position - tool_position, 1.0,
                        (tool.radius + kCandidateMargin) + slack};
  std::size_t found = 0;
  for (const int t : broad_candidates) {
    const Box box = bound_triangle(x, tree.triangles()[static_cast<std::size_t>(t)]);
    if (enter_box(segment, box.low, box.high) > std::numeric_limits<double>::max()) continue;
    if (found < candidates.triangles.size()) candidates.triangles[found++] = t;
  }
  std::sort(candidates.triangles.begin(),
            candidates.triangles.begin() + static_cast<std::ptrdiff_t>(found));
  candidates.from = tool_position;
  candidates.to = hand_position;
  candidates.count = static_cast<int>(found);
  for (std::size_t i = 0; i < found; ++i) {
    candidates.areas[i] = rest_areas[static_cast<std::size_t>(candidates.triangles[i])];
  }
}

}  // namespace palpate

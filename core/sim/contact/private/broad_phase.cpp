// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/broad_phase.h"

#include <algorithm>
#include <limits>

#include "palpate/sim/contact/private/axes.h"
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

void keep_each_once(int parts, std::size_t found, std::span<const double> rest_areas,
                    Candidates& candidates) noexcept {
  const auto begin = candidates.triangles.begin();
  auto end = begin + static_cast<std::ptrdiff_t>(found);
  if (parts > 1) {
    std::sort(begin, end);
    end = std::unique(begin, end);
  }
  candidates.count = static_cast<int>(end - begin);
  candidates.at_border = false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(candidates.count); ++i) {
    const auto t = static_cast<std::size_t>(candidates.triangles[i]);
    candidates.areas[i] = rest_areas[t];
    candidates.at_border |= !candidates.border.empty() && candidates.border[t] != 0;
  }
}

void choose_candidates(const AabbTree& tree, std::span<const Vec3> x, const Sweep& sweep,
                       const Vec3& tool_position, const Vec3& hand_position,
                       std::span<const double> rest_areas, std::span<const int> broad_candidates,
                       Candidates& candidates) noexcept {
  std::size_t found = 0;
  for (const SweptPart& part : sweep.list()) {
    const double slack = compute_slack(tree.low(), tree.high(), part.from, part.to);
    const Segment segment{part.from, part.to - part.from, 1.0,
                          (part.radius + kCandidateMargin) + slack};
    for (const int t : broad_candidates) {
      const Box box = bound_triangle(x, tree.triangles()[static_cast<std::size_t>(t)]);
      if (enter_box(segment, box.low, box.high) > std::numeric_limits<double>::max()) continue;
      if (found < candidates.triangles.size()) candidates.triangles[found++] = t;
    }
  }
  std::sort(candidates.triangles.begin(),
            candidates.triangles.begin() + static_cast<std::ptrdiff_t>(found));
  candidates.from = tool_position;
  candidates.to = hand_position;
  keep_each_once(sweep.count, found, rest_areas, candidates);
}

}  // namespace palpate

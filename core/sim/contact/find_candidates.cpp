// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/find_candidates.h"

#include <algorithm>
#include <limits>

#include "palpate/sim/contact/box.h"
#include "palpate/sim/contact/crossing.h"
#include "palpate/sim/contact/queries.h"

namespace palpate {

namespace {

void fill_areas(std::span<const double> rest_areas, Candidates& candidates) noexcept {
  for (std::size_t i = 0; i < static_cast<std::size_t>(candidates.count); ++i) {
    candidates.areas[i] = rest_areas[static_cast<std::size_t>(candidates.triangles[i])];
  }
}

}  // namespace

void find_candidates(const AabbTree& tree, std::span<const Vec3> x, const Tool& tool,
                     const Vec3& tool_position, const Vec3& hand_position,
                     std::span<const double> rest_areas, Candidates& candidates) noexcept {
  const int found = find_near_segment(tree, x, tool_position, hand_position,
                                      tool.radius + kCandidateMargin, candidates.triangles);
  candidates.from = tool_position;
  candidates.to = hand_position;
  candidates.count = std::min(found, static_cast<int>(candidates.triangles.size()));
  fill_areas(rest_areas, candidates);
}

void choose_candidates(const AabbTree& tree, std::span<const Vec3> x, const Tool& tool,
                       const Vec3& tool_position, const Vec3& hand_position,
                       std::span<const double> rest_areas, std::span<const int> suspects,
                       Candidates& candidates) noexcept {
  const double slack = compute_slack(tree.low(), tree.high(), tool_position, hand_position);
  const Way way{tool_position, hand_position - tool_position, 1.0,
                (tool.radius + kCandidateMargin) + slack};
  std::size_t found = 0;
  for (const int t : suspects) {
    const Box box = bound_triangle(x, tree.triangles()[static_cast<std::size_t>(t)]);
    if (enter_box(way, box.low, box.high) > std::numeric_limits<double>::max()) continue;
    if (found < candidates.triangles.size()) candidates.triangles[found++] = t;
  }
  std::sort(candidates.triangles.begin(),
            candidates.triangles.begin() + static_cast<std::ptrdiff_t>(found));
  candidates.from = tool_position;
  candidates.to = hand_position;
  candidates.count = static_cast<int>(found);
  fill_areas(rest_areas, candidates);
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/find_candidates.h"

#include <algorithm>

#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/broad_phase.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {

Sweep::Sweep(const Tool& tool, const Axes& axes, const Vec3& tool_position,
             const Vec3& hand_position) noexcept {
  if (axes.count == 0) {
    parts[0] = {tool_position, hand_position, tool.radius};
    count = 1;
    return;
  }
  const Vec3 middle = 0.5 * (tool_position + hand_position);
  const double half = 0.5 * (hand_position - tool_position).norm();
  for (const Capsule& axis : axes.list()) {
    parts[static_cast<std::size_t>(count++)] = {middle + axis.from, middle + axis.to,
                                                tool.radius + half};
  }
}

void find_candidates(const AabbTree& tree, std::span<const Vec3> x, const Tool& tool,
                     const Vec3& tool_position, const Vec3& hand_position,
                     std::span<const double> rest_areas, Candidates& candidates,
                     const Quaternion& orientation, double jaw_angle) noexcept {
  find_candidates(tree, x, {tool, Axes(tool, orientation, jaw_angle), tool_position, hand_position},
                  tool_position, hand_position, rest_areas, candidates);
}

void find_candidates(const AabbTree& tree, std::span<const Vec3> x, const Sweep& sweep,
                     const Vec3& tool_position, const Vec3& hand_position,
                     std::span<const double> rest_areas, Candidates& candidates) noexcept {
  std::size_t found = 0;
  for (const SweptPart& part : sweep.list()) {
    const auto rest = std::span(candidates.triangles).subspan(found);
    const int more =
        find_near_segment(tree, x, part.from, part.to, part.radius + kCandidateMargin, rest);
    found += std::min(static_cast<std::size_t>(more), rest.size());
  }
  candidates.from = tool_position;
  candidates.to = hand_position;
  candidates.near.knows_compliance = candidates.near.found = false;
  keep_each_once(sweep.count, found, rest_areas, candidates);
}

}  // namespace palpate

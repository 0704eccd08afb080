// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "palpate/sim/base/private/limit.h"
#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/contact/private/axes.h"

namespace palpate {

// find_candidates() with a tree that is a little behind its surface.

/// Triangles of all leaves whose boxes, as they stand, meet the segment when grown by `radius` [m]:
/// where no triangle has left its boxes by more than a part of the radius, all of them that are
/// within the rest of it. In any order; returns how many there are, never more than `out` holds.
int find_leaves_near_segment(const AabbTree& tree, const Vec3& from, const Vec3& to, double radius,
                             std::span<int> out) noexcept;

/// find_candidates() from `broad_candidates`, which hold every triangle that find_candidates()
/// would find and perhaps others, in any order: only their positions need be up to date, and no box
/// is looked at.
void choose_candidates(const AabbTree& tree, std::span<const Vec3> x, const Sweep& sweep,
                       const Vec3& tool_position, const Vec3& hand_position,
                       std::span<const double> rest_areas, std::span<const int> broad_candidates,
                       Candidates& candidates) noexcept;

/// find_candidates() of one part of a tool, a jaw for one.
void find_candidates(const AabbTree& tree, std::span<const Vec3> x, const Sweep& sweep,
                     const Vec3& tool_position, const Vec3& hand_position,
                     std::span<const double> rest_areas, Candidates& candidates) noexcept;

/// Ends a search of `parts` of a tool one after the other, which has found so many triangles: sorts
/// out those that more than one of them is near to, and fills in the areas.
void keep_each_once(int parts, std::size_t found, std::span<const double> rest_areas,
                    Candidates& candidates) noexcept;

/// [m] How far p lies beside the path that candidates were looked for along.
inline double measure_beside(const Candidates& candidates, const Vec3& p) noexcept {
  const Vec3 path = candidates.to - candidates.from;
  const double squared_length = path.squaredNorm();
  if (!(squared_length > 0.0)) return (p - candidates.from).norm();
  const double t = std::clamp((p - candidates.from).dot(path) / squared_length, 0.0, 1.0);
  return (p - (candidates.from + t * path)).norm();
}

/// A step from p that goes no more than `margin` [m], at most kCandidateMargin, beside the path:
/// beyond that there may be triangles nobody looked for. A tool that slides so far waits for the
/// next tick. It stops short, for a pull back to the path would be a step that knows no surface.
inline Vec3 keep_near_path(const Candidates& candidates, const Vec3& p, const Vec3& step,
                           double margin) noexcept {
  if (measure_beside(candidates, p + step) <= margin) return step;
  return limit(step, std::max(0.0, margin - measure_beside(candidates, p)));
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

}  // namespace palpate

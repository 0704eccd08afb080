// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/contact/tool.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

/// Puts a tool that is nowhere yet where the hand is, and returns whether it is in the scene.
///
/// A hand that begins inside the tissue has no tool: nothing is touched or felt until it has come
/// out, and as far as two fifths of the tool's `radius` [m]. Put inside, the tool would be
/// behind every triangle and be shot out where it breaks through; put deep in the surface, it would
/// tear that; put on the nearest outside, the hand would be struck with all the force there is.
bool place_tool(const AabbTree& tree, std::span<const Vec3> x, const Vec3& hand_position,
                double radius, ToolState& tool) noexcept;

/// Whether a tool may be put there: outside of the surface, and no deeper in it than that.
bool has_room(const AabbTree& tree, std::span<const Vec3> x, const Vec3& hand_position,
              double radius) noexcept;

/// How often the surface goes round `p`: 1 inside of a closed surface, 0 outside, and for an open
/// one what is in between: the share of all directions from `p` that the surface covers.
double compute_winding_number(std::span<const Triangle> triangles, std::span<const Vec3> x,
                              const Vec3& p) noexcept;

}  // namespace palpate

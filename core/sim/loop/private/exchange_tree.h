// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

/// A tree, and what its queries cost when it was built.
struct BuiltTree {
  AabbTree tree;
  TreeCost cost;
};

/// A tree built over these positions [m] of the surface. Allocates.
BuiltTree build_over(std::span<const Vec3> surface, std::span<const Triangle> triangles);

/// Whether the queries of a body's tree have become so costly that another is worth building.
bool wants_tree(const SoftState& body) noexcept;

/// Between two ticks: the body goes on with this tree, which gets the old one and is to be freed
/// where that harms nobody. The surface may have moved on since it was built. No answer to a query
/// depends on the shape of the tree, so forces stay the same to the bit, only sooner had.
void exchange_tree(BuiltTree& built, SoftState& body) noexcept;

}  // namespace palpate

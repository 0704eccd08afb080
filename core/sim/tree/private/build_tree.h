// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

/// The shape of a tree: its nodes without their boxes, and its triangles by leaf.
struct TreeShape {
  CacheAligned<AabbTree::Node> nodes;
  std::vector<int> order;
};

/// The same surface gives the same tree on every machine.
TreeShape build_tree(std::span<const Vec3> x, std::span<const Triangle> triangles);

/// What follows a surface with a tree of this shape.
TreeRefit plan_refit(const TreeShape& shape, std::span<const Triangle> triangles,
                     std::size_t particle_count);

/// Fills the lists of what moves from the corners that do.
void list_moving(std::size_t node_count, TreeRefit& refit) noexcept;

}  // namespace palpate

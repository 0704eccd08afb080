// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/contact/aabb_tree.h"

namespace palpate {

/// What a refit works on: leaves hold blocks of particles, inner nodes stand behind one another so
/// that children come before their parents.
struct TreeBoxes {
  static constexpr int kBlock = AabbTree::kBlock;
  using Leaf = AabbTree::Leaf;

  std::span<const Vec3> x;
  std::span<const Leaf> leaves;
  std::span<const int> particles;
  std::span<const int> inner;
  std::span<AabbTree::Node> nodes;
};

/// Makes the boxes of all nodes fit their particles. Leaves and inner nodes each have a sweep of
/// their own, and no branch in them depends on the tree. Smallest and largest are exact, so that
/// vector code gives the same boxes to the last bit.
void refit_boxes(const TreeBoxes& boxes) noexcept;

}  // namespace palpate

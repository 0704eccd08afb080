// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/haptics/exchange_tree.h"

#include <algorithm>
#include <utility>

namespace palpate {

BuiltTree build_over(std::span<const Vec3> surface, std::span<const Triangle> triangles) {
  AabbTree tree(surface, triangles);
  const TreeCost cost(tree);
  return {std::move(tree), cost};
}

bool wants_tree(const World& world) noexcept {
  return !world.alarm && world.tree_cost.growth() >= TreeCost::kWorthRebuilding;
}

void exchange_tree(BuiltTree& built, World& world) noexcept {
  std::swap(world.tree, built.tree);
  std::swap(world.tree_cost, built.cost);
  world.tree.refit(surface_position(world));
  // the new tree follows nothing yet; the next tick tells it what moves
  world.lag.next = 0;
  std::fill(world.in_tree.begin(), world.in_tree.end(), static_cast<unsigned char>(0));
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/private/exchange_tree.h"

#include <algorithm>
#include <utility>

#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {

BuiltTree build_over(std::span<const Vec3> surface, std::span<const Triangle> triangles) {
  AabbTree tree(surface, triangles);
  const TreeCost cost(tree);
  return {std::move(tree), cost};
}

bool wants_tree(const World& world) noexcept {
  return !world.alarm && internals(world).tree_cost.growth() >= TreeCost::kWorthRebuilding;
}

void exchange_tree(BuiltTree& built, World& world) noexcept {
  std::swap(world.tree, built.tree);
  std::swap(internals(world).tree_cost, built.cost);
  world.tree.refit(surface_position(world));
  // the new tree follows nothing yet; the next tick tells it what moves
  if (PackedKernel* packed = find_packed(world)) {
    packed->lag.next = 0;
    std::ranges::fill(packed->in_tree, static_cast<unsigned char>(0));
  }
}

}  // namespace palpate

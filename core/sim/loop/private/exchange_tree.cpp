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

bool wants_tree(const SoftState& body) noexcept {
  return internals(body).tree_cost.growth() >= TreeCost::kWorthRebuilding;
}

void exchange_tree(BuiltTree& built, SoftState& body) noexcept {
  std::swap(body.tree, built.tree);
  std::swap(internals(body).tree_cost, built.cost);
  body.tree.refit(surface_position(body));
  // the new tree follows nothing yet; the next tick tells it what moves
  if (PackedKernel* packed = find_packed(body)) {
    packed->lag.next = 0;
    std::ranges::fill(packed->in_tree, static_cast<unsigned char>(0));
  }
}

}  // namespace palpate

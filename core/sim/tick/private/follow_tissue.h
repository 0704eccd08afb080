// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

// What a tick needs of the tissue in double: all of it, or under World::follows_all off only what
// the tool may touch, found with boxes that are a little behind and grown by how far anything can
// have gone since.

/// Brings tissue and skin up to where the last tick has left them. The tree stays as it is. Costs a
/// fraction of a tick; nothing where nothing is behind.
void catch_up(const Scene& scene, World& world) noexcept;

/// Begins a tick: brings the tree to where the last one has left the tissue, or the next part of
/// it.
void follow_tissue(const Scene& scene, World& world) noexcept;

/// find_candidates() for the path of the tool to the hand [m], and their corners up to date.
void find_touchable(const Scene& scene, const Vec3& hand, World& world) noexcept;

/// [m] How far the surface may have left the boxes of world.tree since they were made.
double bound_lag(const World& world) noexcept;

/// Whether ticks of this world follow only a part of it.
bool lags(const World& world) noexcept;

/// Whether tissue and skin are not all what the last tick has left.
bool is_behind(const World& world) noexcept;

/// [m] Where vertex v of a skin is with the particles at x.
inline Vec3 place_on_skin(const Skin& skin, std::size_t v, std::span<const Vec3> x) noexcept {
  const auto& [a, b, c, d] = skin.corners[v];
  const auto& w = skin.weights[v];
  return w[0] * x[static_cast<std::size_t>(a)] + w[1] * x[static_cast<std::size_t>(b)] +
         w[2] * x[static_cast<std::size_t>(c)] + w[3] * x[static_cast<std::size_t>(d)];
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

// What a tick needs of the tissue in double: all of it, or under World::follows_all off only what
// the tool may touch, found with boxes that are a little behind and grown by how far anything can
// have gone since.

/// Brings tissues and skins up to where the last tick has left them. Trees stay as they are. Costs
/// a fraction of a tick; nothing where nothing is behind.
void catch_up(const Scene& scene, World& world) noexcept;
void catch_up(const SoftBody& body, SoftState& state) noexcept;

/// Begins a tick: brings the tree of a body to where the last one has left its tissue, or the next
/// part of it.
void follow_tissue(const Scene& scene, std::size_t body, World& world) noexcept;

/// find_candidates() of a body for the path of a tool to its hand [m], and their corners up to
/// date.
void find_touchable(const Scene& scene, std::size_t instrument, std::size_t body, const Vec3& hand,
                    World& world) noexcept;

/// [m] How far the surface may have left the boxes of its tree since they were made.
double bound_lag(const SoftState& state) noexcept;

/// Whether ticks of this world follow only a part of that body.
bool lags(const World& world, const SoftState& state) noexcept;

/// Whether tissue and skin are not all what the last tick has left.
bool is_behind(const SoftState& state) noexcept;

/// [m] Where vertex v of a skin is with the particles at x.
inline Vec3 place_on_skin(const Skin& skin, std::size_t v, std::span<const Vec3> x) noexcept {
  const auto& [a, b, c, d] = skin.corners[v];
  const auto& w = skin.weights[v];
  return w[0] * x[static_cast<std::size_t>(a)] + w[1] * x[static_cast<std::size_t>(b)] +
         w[2] * x[static_cast<std::size_t>(c)] + w[3] * x[static_cast<std::size_t>(d)];
}

}  // namespace palpate

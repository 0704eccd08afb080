// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

// Instruments on what is hard [contact: scenery]: as on tissue, but for what that does.

/// Makes what a world needs of all scenery and rigid bodies.
void build_hard_surfaces(const Scene& scene, World& world);

/// Finds what an instrument may touch of all that is hard on its path to where the hand is [m].
void find_touchable_hard(const Scene& scene, std::size_t instrument, const Vec3& hand,
                         World& world) noexcept;

/// has_room() with all that is hard.
bool has_room_at_hard(World& world, const Vec3& hand, const Tool& tool,
                      const ToolState& state) noexcept;

/// As this instrument touches them, with one of its jaws where it has some.
void list_hard_surfaces(const Scene& scene, std::size_t instrument, std::size_t jaw, World& world,
                        std::span<TouchedSurface> list) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {

/// [m] How far the hand has gone on since its spring could pull no harder: by so much a tool that
/// is held has slid in its grip.
double measure_slip(const Coupling& coupling, const Vec3& hand_position,
                    const ToolState& state) noexcept;

/// [N] What all holds together carry, each whatever its direction; the loads of the surfaces are
/// what they did in the last substep.
double measure_held_load(const ToolState& state, std::span<const TouchedSurface> surfaces) noexcept;

/// [J] No less than what the hand's spring, contacts and holds can give before the hand moves
/// again; the loads of the surfaces are what they did in the last substep.
double bound_stored_energy(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                           const ToolState& state,
                           std::span<const TouchedSurface> surfaces) noexcept;

}  // namespace palpate

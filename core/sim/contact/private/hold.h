// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/balance_tool.h"

namespace palpate {

/// [m] How far the hand has gone on since its spring could pull no harder: by so much a tool that
/// is held has slid in its grip.
double measure_slip(const Coupling& coupling, const Vec3& hand_position,
                    const ToolState& state) noexcept;

/// [N] What all holds together carry, each whatever its direction; `load` is what they did in the
/// last substep.
double measure_held_load(const ToolState& state, const Load& load) noexcept;

/// [J] No less than what the hand's spring, contacts and holds can give before the hand moves
/// again; `load` is what they did in the last substep.
double bound_stored_energy(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                           const ToolState& state, const Load& load) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

// The tissue's part of a tick, under any kernel (world_internals.h). Between begin and end all but
// the reference keep world.tissue up to date where the tool may touch it and nowhere else.

/// Finds what the tool may touch, once the candidates are known.
void begin_moving(const Scene& scene, World& world) noexcept;

/// One substep of dt [s] under world.load; `last` of its tick. Returns the work [J] of the pushes.
double move_tissue(const Scene& scene, double dt, bool last, World& world) noexcept;

/// Brings world.tissue up to date, all of it unless it lags (follow_tissue.h), and checks it after
/// a tick in which pushes have done `work` [J].
Alarm end_moving(const Scene& scene, double work, World& world) noexcept;

}  // namespace palpate

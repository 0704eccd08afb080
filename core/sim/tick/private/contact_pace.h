// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {

// How often a tick looks at what its bodies may touch of each other [contact: bodies]. Once, as
// long as their surfaces do not go far in it; else again and again within it. Nothing here
// allocates.

/// Finds the contacts again where they would not hold for the substep s of dt [s] that follows.
void follow_pace(const Scene& scene, int s, double dt, World& world) noexcept;

/// Ends the substeps of a tick: trees are where they have left the surfaces.
void end_pace(World& world) noexcept;

/// Where the tick that has been done, of dt [s], has moved surfaces farther than the contacts that
/// it had found bear: takes it and its alarm back, and has it look for contacts more often. Its
/// steps are to be fitted and done again. False where all is well, or there is nothing better.
bool take_back_outrun(const Scene& scene, double dt, World& world) noexcept;

/// Whether all of a body is followed in every substep of this tick.
bool is_followed_within(std::size_t body, World& world) noexcept;

/// [m] How far a surface has gone at most in a tick of dt [s] that has been done: of one that is
/// stepped in double, at the speed that it has now.
double measure_move(double dt, const SoftState& state) noexcept;

}  // namespace palpate

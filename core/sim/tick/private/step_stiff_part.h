// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

// Implicit Euler on a few particles, where implicit damping is not enough [motion: ladder].
// Allocates, as implicit integrators do.

/// Before the substeps of a tick of dt [s], and of each try to do it again: which particles
/// implicit Euler moves, of the bodies that need it.
void choose_stiff_parts(const Scene& scene, double dt, World& world) noexcept;

/// A substep of dt [s] of such a body. Where it fails, no later one of the tick moves the body.
void step_stiff_part(const SoftBody& body, SoftState& state) noexcept;

}  // namespace palpate

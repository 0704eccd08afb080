// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

// The safeguards of a body between an alarm and the freeze [motion: ladder]. Nothing here
// allocates; of what they step with, implicit Euler does.

/// Once a tick knows what it may touch, before its first substep: what the substeps will change is
/// kept.
void keep_checkpoint(World& world) noexcept;

/// Back to there: all tissues up to date, tools and the guards' memory as they were.
void rewind(const Scene& scene, World& world) noexcept;

/// Begins a tick of dt [s]: bodies that have been calm for long enough go one safeguard down.
void calm_down(const Scene& scene, double dt, World& world) noexcept;

/// After an alarm: takes the alarm back, rewinds, and gives its body the next safeguard there is
/// for it; where the first did not help, its body begins where the tick before did. False where
/// there is none, the alarm is of no body, or steps do not help against it.
bool climb(const Scene& scene, World& world) noexcept;

/// After fit_substeps() has changed the steps of a tick: bodies that slept through the ones of
/// before are woken where they would not through these.
void wake_again(const Scene& scene, double dt, World& world) noexcept;

/// How many substeps a safeguard makes of `wanted`: no more than the body's substeps_max.
int refine(const SoftBody& body, Safeguard safeguard, int wanted) noexcept;

/// Whether a body is stepped in double, by symplectic Euler with implicit damping or with implicit
/// Euler, whatever its kernel.
inline bool is_stepped_in_double(const SoftState& state) noexcept {
  return state.safeguard >= Safeguard::implicit_damping;
}

// Implicit Euler on a few particles, where implicit damping is not enough [motion: ladder].
// Allocates, as implicit integrators do.

/// Before the substeps of a tick of dt [s], and of each try to do it again: which particles
/// implicit Euler moves, of the bodies that need it.
void choose_stiff_parts(const Scene& scene, double dt, World& world) noexcept;

/// A substep of dt [s] of such a body. Where it fails, no later one of the tick moves the body.
void step_stiff_part(const SoftBody& body, SoftState& state) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

// A body sleeps where a tick has been seen to map it onto itself, bit by bit: as long as nothing
// about the tick changes, the next one does so too, and is left out. Under the active set that is
// where none of it is in motion any more. Beside other bodies, vector code sleeps where it has all
// but stopped as well: alone it would be felt no sooner for that, and records of one body stay as
// they are.

/// Ends a tick of a body that is awake: falls asleep where it is at rest.
void fall_asleep(const Scene& scene, std::size_t body, double dt, World& world) noexcept;

/// Once candidates, holds and substeps of a tick of dt [s] are known: wakes every body that an
/// instrument may touch in it, or whose step has changed.
void wake_bodies(double dt, World& world) noexcept;
void wake_body(std::size_t body, double dt, World& world) noexcept;

/// What is left of a tick of dt [s] for a body that sleeps: its time, and the guard's memory.
Alarm end_asleep(const Scene& scene, std::size_t body, double dt, World& world) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

// A body's part of a tick, under any kernel (world_internals.h). Between begin and end all but the
// reference keep SoftState::tissue up to date where a tool may touch it and nowhere else.

/// Finds what the tools may touch, once the candidates are known.
void begin_moving(const Scene& scene, std::size_t body, World& world) noexcept;

/// One substep of dt [s] under the load of the body; `last` of its tick. Returns the work [J] of
/// the pushes.
double move_tissue(const Scene& scene, std::size_t body, double dt, bool last,
                   World& world) noexcept;

/// Brings the tissue up to date, all of it unless it lags (follow_tissue.h), and checks it after a
/// tick in which pushes have done `work` [J].
Alarm end_moving(const Scene& scene, std::size_t body, double work, World& world) noexcept;

/// Ends a tick of dt [s] in which no body has raised an alarm: what is held of a body tears where
/// it has been stretched too far for long enough, and what has torn fades [contact: tear].
void tear_links(const Scene& scene, std::size_t body, double dt, World& world) noexcept;

/// Likewise: what moves is listed again.
void settle_moving(SoftState& state) noexcept;

}  // namespace palpate

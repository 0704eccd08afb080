// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {

// A linear solid's part of a tick, under the response kernel.

/// [m] per vertex of the surface: how far it may be moved, kShallow of what lies under it along its
/// normal; infinite where nothing does. `tree` of the surface at rest.
std::vector<double> compute_shallow_depths(const TissueModel& tissue, const AabbTree& tree);

/// How many substeps the coming tick of dt [s] has; `travel` [m] is how far the hand has come.
int count_linear_substeps(const Scene& scene, double travel, double dt,
                          const ResponseKernel& kernel, World& world) noexcept;

/// [-] of the path to where the pushes hold it, which the tissue goes in a substep of dt [s].
double choose_linear_share(const Scene& scene, double dt, const ResponseKernel& kernel,
                           World& world) noexcept;

/// One substep of dt [s] under world.load; only what the tool may touch is brought up to date.
void move_linear(const Scene& scene, double dt, ResponseKernel& kernel, World& world) noexcept;

/// [-] How far the farthest vertex that is pushed or pulled has gone of how far it may.
double measure_deepest_share(const Scene& scene, const ResponseKernel& kernel,
                             const World& world) noexcept;

/// Brings all of world.tissue up to date and checks that the press is still shallow.
Alarm end_linear(const Scene& scene, ResponseKernel& kernel, World& world) noexcept;

}  // namespace palpate

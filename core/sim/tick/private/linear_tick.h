// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {

// A linear solid's part of a tick, under the response kernel.

/// [m] per vertex of the surface: how far it may be moved, kShallow of what lies under it along its
/// normal; infinite where nothing does. `tree` of the surface at rest.
std::vector<double> compute_shallow_depths(const TissueModel& tissue, const AabbTree& tree);

/// How many substeps the coming tick of dt [s] asks for; the hands in the workspace of the world.
int count_linear_substeps(const Scene& scene, std::size_t body, double dt,
                          const ResponseKernel& kernel, World& world) noexcept;

/// [-] of the path to where the pushes hold it, which the tissue goes in a substep of dt [s].
double choose_linear_share(const Scene& scene, std::size_t body, double dt,
                           const ResponseKernel& kernel, World& world) noexcept;

/// One substep of dt [s] under the body's load; only what a tool may touch is brought up to date.
void move_linear(const Scene& scene, std::size_t body, double dt, ResponseKernel& kernel,
                 World& world) noexcept;

/// [-] How far the farthest vertex that is pushed or pulled has gone of how far it may.
double measure_deepest_share(const SoftBody& body, const ResponseKernel& kernel,
                             const SoftState& state) noexcept;

/// Brings all of the tissue up to date and checks that the press is still shallow.
Alarm end_linear(const Scene& scene, std::size_t body, ResponseKernel& kernel,
                 World& world) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/tick/world.h"

namespace palpate {

/// Whether an instrument holds a body, or may touch it in this tick.
bool is_near(World& world, std::size_t instrument, std::size_t body) noexcept;

/// [1/s²] bound_contact_stiffness() of an instrument and a body.
double bound_instrument_stiffness(const Scene& scene, std::size_t instrument, std::size_t body,
                                  World& world) noexcept;

/// How many substeps a body asks for in the coming tick of dt [s], from the world as the last tick
/// left it, its candidates, and the hands in its workspace. Between substeps and substeps_max of
/// the body.
int count_substeps(const Scene& scene, std::size_t body, double dt, World& world) noexcept;

/// Writes SoftState::substeps of all bodies: what each asks for, or more, so that each number
/// divides the largest. Returns that.
int choose_substeps(const Scene& scene, double dt, World& world) noexcept;

/// The same from what each has asked for in this tick, under the safeguards as they are now.
int fit_substeps(const Scene& scene, World& world) noexcept;

/// Raises numbers until each divides the largest, which is raised by up to a quarter where that
/// lowers the sum of `cost` times number. The largest of one body alone stays as it is.
void make_divisors(std::span<const double> cost, std::span<int> substeps) noexcept;

}  // namespace palpate

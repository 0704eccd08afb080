// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "palpate/sim/contact/private/hold.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

/// Whether an instrument holds a body, or may touch it in this tick.
bool is_near(World& world, std::size_t instrument, std::size_t body) noexcept;

/// A body as an instrument, or its first (0) or second (1) jaw, may touch it in this tick.
TouchableSurface find_touchable_part(const Scene& scene, std::size_t instrument, std::size_t part,
                                     std::size_t body, World& world) noexcept;

/// Adds what that touches; what is held counts with part 0.
void add_rows(const Scene& scene, std::size_t instrument, std::size_t part, std::size_t body,
              ContactRows& rows, World& world) noexcept;

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

// what build_scene chooses by (substep_need.cpp)

/// Substeps per tick with which a body whose spectrum is known is stable at rest by its integrator,
/// with the reserve of stable_step; not rounded up, infinite where no number is enough. XPBD is
/// stable at any step but far too soft in long ones, and gets as many as symplectic Euler [laws:
/// xpbd].
double count_needed_substeps(double rate, const SoftBody& body);

/// [-] The largest part of all its stiffness and damping with which the body does with so many
/// substeps at rest, rounded down to two digits; 1 where it does as it is, 0 where no part would
/// do.
double find_fitting_part(double rate, const SoftBody& body, double substeps);

/// Throws std::invalid_argument, with what would do, where a body has fewer substeps than that, by
/// more than a hundredth. One that answers from its response has no step to be stable by.
void require_enough_substeps(const std::string& where, double rate, const SoftBody& body);

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/model/load.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

// The reference kernels: double, plain, one law each, read beside the equation. Every one adds
// into its last argument and leaves the total momentum as its law says.

void accumulate_link_forces(const Links& links, DampingLaw law, std::span<const Vec3> x,
                            std::span<const Vec3> v, std::span<Vec3> f) noexcept;

/// Eq 9 and Eq 11 of the paper as edge tensions.
void accumulate_angle_forces(const Angles& angles, std::span<const Vec3> x,
                             std::span<Vec3> f) noexcept;

/// Eq 10 of the paper, as printed but with the sign that reopens a closed angle.
void accumulate_eq10_forces(const Angles& angles, std::span<const Vec3> x,
                            std::span<Vec3> f) noexcept;

/// What resists the transverse shear of a wall; see Prisms.
void accumulate_prism_forces(const Prisms& prisms, std::span<const Vec3> x, std::span<const Vec3> v,
                             std::span<Vec3> f) noexcept;

/// What resists a change of volume; see Volumes.
void accumulate_volume_forces(const Volumes& volumes, std::span<const Vec3> x,
                              std::span<Vec3> f) noexcept;

/// What resists strain; see Elastic. `rest` [m] are the places at rest.
void accumulate_elastic_forces(const Elastic& elastic, std::span<const Vec3> rest,
                               std::span<const Vec3> x, std::span<const Vec3> v,
                               std::span<Vec3> f) noexcept;

/// What resists finite strain; see Hyperelastic. `rest` [m] are the places at rest.
void accumulate_corotated_forces(const Hyperelastic& table, std::span<const Vec3> rest,
                                 std::span<const Vec3> x, std::span<const Vec3> v,
                                 std::span<Vec3> f) noexcept;
void accumulate_neo_hookean_forces(const Hyperelastic& table, std::span<const Vec3> rest,
                                   std::span<const Vec3> x, std::span<const Vec3> v,
                                   std::span<Vec3> f) noexcept;

void accumulate_home_forces(std::span<const double> home, std::span<const Vec3> rest,
                            std::span<const Vec3> x, std::span<Vec3> f) noexcept;

void accumulate_pressure_forces(std::span<const Triangle> triangles, double pressure,
                                std::span<const Vec3> x, std::span<Vec3> f) noexcept;

void accumulate_gravity(std::span<const double> mass, const Vec3& gravity,
                        std::span<Vec3> f) noexcept;

void accumulate_drag(std::span<const double> mass, double drag, std::span<const Vec3> v,
                     std::span<Vec3> f) noexcept;

/// Triangles are those of particles, or of a skin that is not empty.
void accumulate_push_forces(std::span<const Triangle> triangles, const Skin& skin,
                            std::span<const Push> pushes, std::span<Vec3> f) noexcept;

/// Sets `f` to all of the above for a model under a load. The entries of fixed particles hold
/// what the support must carry. `internal` is State::internal; none stands for zeros.
void compute_forces(const TissueModel& model, const Load& load, std::span<const Vec3> x,
                    std::span<const Vec3> v, std::span<Vec3> f,
                    std::span<const double> internal = {}) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/dynamics/state.h"

// A law has
//     table                              its entry in the table of laws
//     kEnergy                            the member of Energy that its energy counts in
//     kStiffens                          how its tangent grows with strain (StretchSpectrum)
//     accumulate(laws, f)                adds its forces [N]
//     compute_energy(model, at, internal)   [J]
// and where it has them
//     compute_stiffness(model, x, projection), compute_damping(model, x)
//     accumulate_damping(model, x, v, f)    what of its forces is linear in v
//     count_internal(model), advance_internal(model, x, dt, internal)   variables of its own
//     scale_links(model)                 how many times as stiff as alone it makes links

namespace palpate {

struct Load;

/// Adds to f [N] all that a load does but its gravity.
void accumulate_load_forces(const TissueModel& model, const Load& load, std::span<Vec3> f) noexcept;

/// Ends a step of dt [s] that has moved the particles: internal variables follow, each law by its
/// own equation, over the step as a whole. Forces within a step take them as they were before it.
void advance_internal(const TissueModel& model, double dt, State& state) noexcept;

// What of the forces in forces.h follows from velocities v [m/s], alone: each is linear in v, and
// added to `f` [N].

void accumulate_link_damping(const Links& links, DampingLaw law, std::span<const Vec3> x,
                             std::span<const Vec3> v, std::span<Vec3> f) noexcept;

void accumulate_prism_damping(const Prisms& prisms, std::span<const Vec3> x,
                              std::span<const Vec3> v, std::span<Vec3> f) noexcept;

void accumulate_viscous_damping(const Hyperelastic& table, std::span<const Vec3> rest,
                                std::span<const Vec3> x, std::span<const Vec3> v,
                                std::span<Vec3> f) noexcept;

/// Adds -C(x) v, of all laws and drag: f(x, v) is f(x, 0) and this.
void accumulate_damping(const TissueModel& model, std::span<const Vec3> x, std::span<const Vec3> v,
                        std::span<Vec3> f) noexcept;

}  // namespace palpate

namespace palpate::laws {

/// What laws pull on. `internal` are the variables of the one law that is asked; none stand for
/// zeros.
struct Configuration {
  const TissueModel& model;
  std::span<const Vec3> x, v;
  std::span<const double> internal;
};

enum class Stiffens {
  as_links,       ///< by how taut they are
  as_sides,       ///< with one over the squared length of sides
  as_volumes,     ///< by how far they are squeezed
  as_strains,     ///< by the principal stretches of tetrahedra
  not_at_all,     ///< linear
  as_the_others,  ///< whatever stands beside it
};

}  // namespace palpate::laws

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
//     count_internal(model), advance_internal(model, x, dt, internal)   variables of its own
//     scale_links(model)                 how many times as stiff as alone it makes links

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
  not_at_all,     ///< linear
  as_the_others,  ///< whatever stands beside it
};

}  // namespace palpate::laws

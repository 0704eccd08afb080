// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

// Which constants of the molecular model hold a triangle together. A stretch-bend term alone is
// indefinite whatever its sign, and a bond may be negative where the other terms make up for it,
// so nothing less than the whole triangle can be judged.

/// [N/m] (3, 3) second derivative, at rest, of the energy of triangle `row` (its bond shares,
/// angles and stretch-bend terms) in the lengths of its three sides.
Mat3 compute_rest_stiffness(const Angles& angles, int row) noexcept;

/// [N/m] (3, 3) what a change of each side's length at rest does to the tension of each side: under
/// AngleLaw::gradient the same as compute_rest_stiffness, under eq10 not symmetric.
Mat3 compute_rest_slopes(const Angles& angles, int row, AngleLaw law) noexcept;

/// True when all eigenvalues are positive by more than rounding.
bool is_positive_definite(const Mat3& stiffness) noexcept;

/// [N] K_btheta lies strictly between the two; either may be infinite.
struct CouplingRange {
  double low, high;
};

/// The K_btheta for which triangle `row` is positive definite when its three stretch_coupling are
/// K_btheta times `proportion`; none if no number helps.
std::optional<CouplingRange> find_coupling_range(const Angles& angles, int row,
                                                 const std::array<double, 3>& proportion);

/// Throws std::invalid_argument on the first triangle that does not hold, with the numbers its
/// stretch_coupling may have. Under AngleLaw::gradient a triangle holds where its stiffness at
/// rest is positive definite. AngleLaw::eq10 has no energy and an asymmetric stiffness: there it
/// holds without stretch-bend terms where its bond shares are positive and its bend_stiffness is
/// not negative, which leaves its stiffness without a zero, or where the symmetric part of that
/// stiffness is positive definite. Then it cannot give way; that it may flutter without damping is
/// in the nature of Eq 10.
void check_definiteness(const Angles& angles, AngleLaw law);

/// "-0.058 to 54 N", drawn in by a hair so that the numbers shown are themselves admissible.
std::string describe(const CouplingRange& range);

}  // namespace palpate

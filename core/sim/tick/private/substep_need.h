// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "palpate/sim/tick/scene.h"

namespace palpate {

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

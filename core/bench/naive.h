// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/load.h"
#include "palpate/sim/dynamics/state.h"

namespace palpate::bench {

// What a first, straightforward program would do with the same model: the yardstick every speed
// in Palpate is stated against, measured in the same process. Same physics, same order of
// particles, same number of steps; only the form is plain. Tests hold them against the kernels.

/// Symplectic Euler with one loop per law over plain arrays; the angle and stretch-bend terms as
/// textbook vector gradients per corner, through the arccosine (Eq 9 and 11, AngleLaw::gradient).
void step_naively(const TissueModel& model, const Load& load, double dt, State& state) noexcept;

}  // namespace palpate::bench

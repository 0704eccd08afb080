// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/state.h"

namespace palpate {

/// Ends a step of dt [s] that has moved the particles: internal variables follow, each law by its
/// own equation, over the step as a whole. Forces within a step take them as they were before it.
void advance_internal(const TissueModel& model, double dt, State& state) noexcept;

}  // namespace palpate

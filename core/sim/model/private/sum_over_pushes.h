// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/model/load.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// Sum over the pushes of force times `field` where they push: [W] for the velocities of the
/// particles, which times the substep is the pushes' work to the last bit, because symplectic Euler
/// moves particles with the new velocity; [J], but for a constant, for their positions.
double sum_over_pushes(std::span<const Push> pushes, const TissueModel& tissue,
                       std::span<const Vec3> field) noexcept;

}  // namespace palpate

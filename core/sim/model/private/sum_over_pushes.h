// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "palpate/sim/model/load.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// Sum over the pushes of force times `field` where they push: [W] for the velocities of the
/// particles, which times the substep is the pushes' work to the last bit, because symplectic Euler
/// moves particles with the new velocity; [J], but for a constant, for their positions.
double sum_over_pushes(std::span<const Push> pushes, const TissueModel& tissue,
                       std::span<const Vec3> field) noexcept;

/// Calls take(particle, weight) for each of the four particles on which each corner of a triangle
/// of a skin hangs: what the weights [-] of a push in the triangle are on particles.
template <class Take>
void for_each_carrier(const TissueModel& tissue, const Triangle& corners, const Vec3& weights,
                      Take take) noexcept {
  for (std::size_t c = 0; c < 3; ++c) {
    const auto v = static_cast<std::size_t>(corners[c]);
    const double weight = weights[static_cast<Eigen::Index>(c)];
    for (std::size_t k = 0; k < 4; ++k) {
      take(static_cast<std::size_t>(tissue.skin.corners[v][k]), weight * tissue.skin.weights[v][k]);
    }
  }
}

}  // namespace palpate

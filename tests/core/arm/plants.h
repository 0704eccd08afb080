// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/arm/plant.h"

namespace palpate {

/// Where the links are at a right angle and the tip's three directions do not mix [rad].
inline const Vec3 kHome = {0.0, 0.5236, 0.5236};

/// An arm of mass and the damping of its motors, held by no hand: the premises of [Colgate97].
inline Plant bare_plant() {
  Plant plant;
  plant.masses.balance = 1.0;
  plant.dry_friction.setZero();
  plant.viscous_friction.setZero();
  return plant;
}

/// A plant whose hand holds the tip as if it were bolted down where it is wanted.
inline Plant clamped_plant() {
  Plant plant;
  plant.hand = {.mass = 1.0, .stiffness = 1e5, .damping = 400.0};
  plant.dry_friction.setZero();
  return plant;
}

}  // namespace palpate

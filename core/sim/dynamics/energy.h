// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/state.h"

namespace palpate {

/// [J] each. AngleLaw::eq10 has no energy and counts 0.
struct Energy {
  double kinetic = 0.0;
  double links = 0.0;    ///< springs and bonds, Eq 8
  double angles = 0.0;   ///< Eq 9 and Eq 11
  double prisms = 0.0;   ///< transverse shear of walls
  double volumes = 0.0;  ///< of tetrahedra
  double strain = 0.0;   ///< of linear solids
  double home = 0.0;
  double gravity = 0.0;   ///< relative to the origin
  double pressure = 0.0;  ///< -p V; its gradient is the pressure force on closed surfaces
  double total() const noexcept { return kinetic + elastic() + gravity + pressure; }
  double elastic() const noexcept { return links + angles + prisms + volumes + strain + home; }
};

Energy compute_energy(const TissueModel& model, const Vec3& gravity, const State& state) noexcept;

}  // namespace palpate

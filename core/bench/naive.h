// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/load.h"

namespace palpate::bench {

// What a first, straightforward program would do with the same model: the yardstick every speed
// in Palpate is stated against, measured in the same process. Same physics, same order of
// particles, same number of steps; only the form is plain. Tests hold them against the kernels.

/// What a first program keeps beside the state of a solid: the volumes around every particle.
struct NaiveVolumes {
  NaiveVolumes() = default;
  explicit NaiveVolumes(const Volumes& volumes);

  std::vector<double> rest;      ///< [m³] per particle
  std::vector<double> bulk;      ///< [Pa] per particle, the mean
  std::vector<double> now;       ///< [m³] per particle
  std::vector<double> pressure;  ///< [Pa] per particle
};

/// Symplectic Euler with one loop per law over plain arrays; the angle and stretch-bend terms as
/// textbook vector gradients per corner, through the arccosine (Eq 9 and 11, AngleLaw::gradient);
/// the sides of prisms by the reference kernel. `kept` is that of the model's volumes.
void step_naively(const TissueModel& model, const Load& load, double dt, State& state,
                  NaiveVolumes& kept) noexcept;

/// The same of a tissue without volumes.
void step_naively(const TissueModel& model, const Load& load, double dt, State& state) noexcept;

}  // namespace palpate::bench

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// Everything about a tissue that changes from step to step.
struct State {
  State() = default;
  /// The tissue at rest, at time zero. All memory a step needs is allocated here.
  explicit State(const TissueModel& model);

  double time = 0.0;   ///< [s]
  Vec3Array position;  ///< [m]
  Vec3Array velocity;  ///< [m/s]
  Vec3Array force;     ///< [N] of the last evaluation, loads included
  /// What laws with a memory keep, law by law (dynamics/private/laws.h); empty without one.
  std::vector<double> internal;

  /// Work space of the explicit integrators; no meaning between steps.
  struct Scratch {
    Vec3Array position, velocity, slope_position, slope_velocity;
  } scratch;
};

/// How many internal variables a state of the model has.
std::size_t count_internal(const TissueModel& model) noexcept;

/// [J] each. AngleLaw::eq10 has no energy and counts 0.
struct Energy {
  double kinetic = 0.0;
  double links = 0.0;    ///< springs and bonds, Eq 8
  double angles = 0.0;   ///< Eq 9 and Eq 11
  double prisms = 0.0;   ///< transverse shear of walls
  double volumes = 0.0;  ///< of tetrahedra
  double strain = 0.0;   ///< of linear, corotated and neo-Hookean solids
  double home = 0.0;
  double gravity = 0.0;   ///< relative to the origin
  double pressure = 0.0;  ///< -p V; its gradient is the pressure force on closed surfaces
  double total() const noexcept { return kinetic + elastic() + gravity + pressure; }
  double elastic() const noexcept { return links + angles + prisms + volumes + strain + home; }
};

Energy compute_energy(const TissueModel& model, const Vec3& gravity, const State& state) noexcept;

}  // namespace palpate

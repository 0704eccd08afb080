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

  /// Work space of the explicit integrators; no meaning between steps.
  struct Scratch {
    Vec3Array position, velocity, slope_position, slope_velocity;
  } scratch;
};

}  // namespace palpate

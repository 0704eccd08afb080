// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/state.h"

namespace palpate {

State::State(const TissueModel& model)
    : position(model.rest_position),
      velocity(model.rest_position.size(), Vec3::Zero()),
      force(model.rest_position.size(), Vec3::Zero()) {
  scratch.position = scratch.velocity = force;
  scratch.slope_position = scratch.slope_velocity = force;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "palpate/sim/base/types.h"
#include "palpate/sim/device/device.h"

namespace palpate {

/// A body as a reader sees it.
struct BodySnapshot {
  Vec3Array position;  ///< [m] of the vertices of the surface
  int substeps = 0;
};

/// What a reader outside the haptic thread sees: the world as it was at most 8 ms ago.
struct Snapshot {
  long tick = 0;
  double time = 0.0;                 ///< [s]
  std::vector<BodySnapshot> bodies;  ///< as Scene::bodies
  HapticSample sample;
  Vec3 tool_position = Vec3::Zero();
  Vec3 force = Vec3::Zero();  ///< [N] on the hand; none while the motors are not on
  bool touching = false;
  MotorState motors = MotorState::on;  ///< of the device
  double cost = 0.0;                   ///< [s] of the last tick
  double lateness = 0.0;               ///< [s] of the last tick
  long missed_ticks = 0;
};
static_assert(alignof(Snapshot) == 8);

}  // namespace palpate

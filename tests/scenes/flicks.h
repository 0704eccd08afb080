// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "palpate/sim/tick/scene.h"
#include "palpate/sim/tick/tick.h"
#include "palpate/sim/tick/world.h"

namespace palpate::scenes {

inline HapticSample hand_at(const Vec3& position) {
  HapticSample sample;
  sample.position = position;
  return sample;
}

struct Flicks {
  int crossed = 0, touched = 0, alarms = 0;
};

/// A hand straight down from each start, `reach` [m] at `speed` [m/s], a world for each;
/// `is_through(scene, world)` is asked after every tick of 1 ms.
template <class IsThrough>
Flicks flick_down(const Scene& scene, const std::vector<Vec3>& starts, double reach, double speed,
                  IsThrough is_through) {
  constexpr double kTick = 1e-3;
  const int ticks = static_cast<int>(std::ceil(reach / speed / kTick)) + 20;
  Flicks found;
  for (const Vec3& start : starts) {
    World world(scene);
    bool crossed = false, felt = false;
    for (int i = 0; i <= ticks; ++i) {
      const Vec3 hand = start - Vec3(0.0, 0.0, std::min(reach, speed * kTick * i));
      felt = tick(scene, hand_at(hand), kTick, world).force.norm() > 0.0 || felt;
      crossed = crossed || is_through(scene, world);
    }
    found.crossed += crossed;
    found.touched += felt;
    found.alarms += static_cast<bool>(world.alarm);
  }
  return found;
}

}  // namespace palpate::scenes

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "palpate/sim/device/device.h"
#include "palpate/sim/device/safe_device.h"

/// A device of your own. As it stands it is a mass on a spring, so that there is something to read;
/// the four places marked FILL IN are where your driver comes in.
class MyDevice : public palpate::HapticDevice {
 public:
  palpate::HapticSample read(double time) noexcept override {
    // FILL IN 1: where the hand is [m]. Here, a mass of 100 g swings under the last force.
    move_to(time);
    palpate::HapticSample sample;
    sample.time = time;
    sample.position = position_;
    // FILL IN 2: orientation (a unit quaternion), buttons and grip, if there are any.
    for (int axis = 0; axis < 3; ++axis) {
      sample.velocity[axis] = speeds_[axis].add(time, position_[axis]);
    }
    return sample;
  }

  void write(const palpate::HapticCommand& command) noexcept override {
    // FILL IN 3: push the hand with this force [N] until the next command.
    force_ = command.force;
  }

  std::string name() const override { return "my device"; }

  bool failed() const noexcept override {
    // FILL IN 4: true once it is unplugged or has fallen silent, and from then on.
    return false;
  }

 private:
  void move_to(double time) noexcept {
    const double dt = time > time_ && time - time_ < 0.1 ? time - time_ : 0.0;
    time_ = time;
    velocity_ += dt / 0.1 * (force_ - 50.0 * position_ - 1.0 * velocity_);
    position_ += dt * velocity_;
  }

  palpate::Vec3 position_ = {0.01, 0.0, 0.0}, velocity_ = palpate::Vec3::Zero();
  palpate::Vec3 force_ = palpate::Vec3::Zero();
  double time_ = 0.0;
  palpate::VelocityWindow speeds_[3] = {palpate::VelocityWindow(1e-6, 4),
                                        palpate::VelocityWindow(1e-6, 4),
                                        palpate::VelocityWindow(1e-6, 4)};
};

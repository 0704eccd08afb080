// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include "palpate/sim/device/safe_device.h"
#include "scenes/grasped.h"

// G5: what jaws hold when their hand is gone [contact: jaws].

using namespace palpate;
using scenes::GraspingHand;

namespace {

/// A hand with a grip axis that is unplugged.
struct Unplugged : HapticDevice {
  HapticSample read(double time) noexcept override {
    sample.time = time;
    return sample;
  }
  void write(const HapticCommand& command) noexcept override { pushed = command.force; }
  std::string name() const override { return "unplugged"; }
  DeviceDynamics dynamics() const noexcept override { return {.position_source = true}; }
  bool failed() const noexcept override { return gone; }

  HapticSample sample;
  Vec3 pushed = Vec3::Zero();
  bool gone = false;
};

}  // namespace

TEST_CASE("G5: jaws whose hand is unplugged let go as if it had opened") {
  const Scene scene = scenes::make_grasped_slab(scenes::make_grasper(0.5, 1.0), 500.0);
  GraspingHand hand(scene);
  Unplugged device;
  device.sample = hand.sample();
  SafeDevice safe(device);
  double time = 0.0, worst = 0.0;
  const auto run = [&](int ticks, double way = 0.0) {
    for (int i = 0; i < ticks; ++i, time += 1e-3) {
      const Vec3 last = hand.force();
      device.sample.position.x() += way / ticks;
      hand.sample() = safe.read(time);
      hand.step();
      safe.write({.force = hand.force()});
      worst = std::max(worst, (hand.force() - last).norm());
    }
  };
  run(300);
  device.sample.grip = scene.instruments[0].tool.jaws->open;
  run(250);
  run(150, 0.003);
  run(300);
  const double held = hand.force().norm();
  CHECK(hand.tool().pinches);
  CHECK(device.pushed.norm() > 0.2);
  device.gone = true;
  worst = 0.0;
  run(1);
  CHECK(device.pushed == Vec3::Zero());
  run(149);
  CHECK(device.pushed == Vec3::Zero());
  CHECK(worst < 0.2 * held);
  CHECK(hand.tool().anchor_count == 0);
  CHECK(hand.force().norm() == 0.0);
  CHECK_FALSE(hand.world().alarm);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/haptics/device_bench.h"

using namespace palpate;

// The paper drove its motors with all they have as soon as the tip touched, and not at all before.
// The same contact under that rule and under a spring as Eq 12 has it, through driver, firmware and
// arm.

namespace {

constexpr double kFull = 1.6;         // [N] of the motors, straight out of the wall
constexpr double kStiffness = 200.0;  // [N/m] of the spring
constexpr double kPress = 2e-3;       // [m] how deep the hand wants to be

struct Contact {
  double given = 0.0;      ///< [J] that the motors gave the hand on the whole
  double swing = 0.0;      ///< [m] to and fro, once settled
  double overshoot = 0.0;  ///< [m] thrown out of the wall after the first touch
};

/// A hand goes into a wall below the middle of the workspace and stays there for two seconds.
template <class Rule>
Contact press(Rule rule) {
  DeviceBench bench;
  const double wall = Workspace{}.center.z();
  const auto held = [&](double z) {
    bench.core.hold(
        {{Workspace{}.center.x(), Workspace{}.center.y(), wall + z}, Vec3::Zero(), true});
  };
  held(5e-3);
  bench.start();
  Contact contact;
  double lowest = 1.0, highest = -1.0, last = 0.0;
  const auto tick = [&](const HapticSample& sample) {
    const double z = find_tip(bench.core.plant(), bench.core.state()).z() - wall;
    contact.given += bench.core.motor_force().z() * (z - last);
    last = z;
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
    return Vec3(0.0, 0.0, rule(wall - sample.position.z()));
  };
  last = find_tip(bench.core.plant(), bench.core.state()).z() - wall;
  for (int k = 0; k < 200; ++k) {
    held(5e-3 - (5e-3 + kPress) * k / 200.0);
    bench.run(1e-3, tick);
  }
  contact.given = 0.0;
  highest = -1.0;
  bench.run(1.0, tick);
  contact.overshoot = std::max(0.0, highest);
  lowest = 1.0, highest = -1.0;
  bench.run(1.0, tick);
  contact.swing = highest - lowest;
  return contact;
}

}  // namespace

TEST_CASE(
    "all the torque there is upon contact throws the hand to and fro; a spring lets it rest") {
  const Contact full = press([](double depth) { return depth > 0.0 ? kFull : 0.0; });
  const Contact spring = press([](double depth) { return kStiffness * std::max(0.0, depth); });
  MESSAGE("full torque: ", 1e3 * full.given, " mJ given in 2 s, swing ", 1e3 * full.swing,
          " mm, thrown out by ", 1e3 * full.overshoot, " mm; spring: ", 1e3 * spring.given, " mJ, ",
          1e3 * spring.swing, " mm, ", 1e3 * spring.overshoot, " mm");

  CHECK(full.swing > 0.2e-3);
  CHECK(full.given > 5e-3);
  CHECK(full.overshoot > 0.05e-3);
  CHECK(spring.swing < 1e-6);
  CHECK(spring.given < 0.1e-3);
  CHECK(spring.overshoot == 0.0);
}

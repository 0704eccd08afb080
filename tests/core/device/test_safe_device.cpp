// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

#include "palpate/sim/device/safe_device.h"

using namespace palpate;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Says what it is told to say and remembers what it was told to push.
struct Puppet : HapticDevice {
  HapticSample read(double time) noexcept override {
    ++reads;
    hand.time = time;
    return hand;
  }
  void write(const HapticCommand& command) noexcept override { pushed = command.force; }
  std::string name() const override { return "puppet"; }

  HapticSample hand;
  Vec3 pushed = Vec3::Constant(-1.0);
  int reads = 0;
};

/// Runs `ticks` of 1 ms with the same force; returns what was pushed last.
Vec3 run(SafeDevice& safe, Puppet& puppet, const Vec3& force, int ticks, double& time) {
  for (int i = 0; i < ticks; ++i, time += 1e-3) {
    safe.read(time);
    safe.write({.force = force});
  }
  return puppet.pushed;
}

/// One tick without force, which lets the next ones be of any size. Returns when the next one is.
double begin(SafeDevice& safe) {
  safe.read(0.0);
  safe.write({});
  return 1e-3;
}

}  // namespace

TEST_CASE("a force within the limits passes unchanged once the start-up ramp is over") {
  Puppet puppet;
  SafeDevice safe(puppet);
  double time = 0.0;

  run(safe, puppet, {0.1, -0.2, 0.3}, 300, time);

  CHECK(puppet.pushed == Vec3(0.1, -0.2, 0.3));
  CHECK(safe.limited_count() == 0);
  CHECK(safe.name() == "puppet");
}

TEST_CASE("a force beyond the limit keeps its direction and loses its excess") {
  Puppet puppet;
  SafeDevice safe(puppet, {.force_max = 2.0});
  double time = begin(safe);

  run(safe, puppet, {30.0, 0.0, 40.0}, 300, time);

  CHECK(puppet.pushed.norm() == doctest::Approx(2.0));
  CHECK((puppet.pushed - Vec3(1.2, 0.0, 1.6)).norm() < 1e-12);
  CHECK(safe.limited_count() == 300);
}

TEST_CASE("a force too large to be squared is still clamped, not lost") {
  Puppet puppet;
  SafeDevice safe(puppet, {.force_max = 2.0});
  double time = begin(safe);

  run(safe, puppet, {1e200, 0.0, 0.0}, 300, time);

  CHECK(puppet.pushed.x() == doctest::Approx(2.0));
}

TEST_CASE("forces fade in over the ramp from the first command on") {
  Puppet puppet;
  SafeDevice safe(puppet, {.force_max = 5.0, .slew_max = 1e6, .ramp_time = 0.2});
  double time = 3.0;

  CHECK(run(safe, puppet, {0, 0, 0.4}, 1, time).z() == 0.0);
  CHECK(run(safe, puppet, {0, 0, 0.4}, 100, time).z() == doctest::Approx(0.2));
  CHECK(run(safe, puppet, {0, 0, 0.4}, 100, time).z() == doctest::Approx(0.4));
  CHECK(run(safe, puppet, {0, 0, 0.4}, 50, time).z() == doctest::Approx(0.4));
}

TEST_CASE("a step of the force arrives at no more than the slew limit") {
  Puppet puppet;
  SafeDevice safe(puppet, {.force_max = 5.0, .slew_max = 500.0, .ramp_time = 0.01});
  double time = 0.0;
  run(safe, puppet, Vec3::Zero(), 20, time);

  for (int i = 1; i <= 4; ++i) {
    CHECK(run(safe, puppet, {0, 0, 2.0}, 1, time).z() == doctest::Approx(0.5 * i));
  }
  CHECK(run(safe, puppet, {0, 0, 2.0}, 1, time).z() == doctest::Approx(2.0));
  CHECK(safe.limited_count() == 3);
}

TEST_CASE("a pause saves up no slew for a jump of the force") {
  Puppet puppet;
  SafeDevice safe(puppet, {.force_max = 5.0, .slew_max = 500.0, .ramp_time = 0.01});
  double time = 0.0;
  run(safe, puppet, Vec3::Zero(), 20, time);

  time += 1.0;
  run(safe, puppet, {0, 0, 5.0}, 1, time);

  CHECK(puppet.pushed.z() == doctest::Approx(1.0));  // two ticks' worth
}

TEST_CASE("a sample that is not finite latches: the hand stays and the force is zero for good") {
  for (const double poison : {kNan, kInfinity, -kInfinity}) {
    Puppet puppet;
    puppet.hand.position = Vec3(0.01, 0.02, 0.03);
    puppet.hand.buttons = kAttachButton;
    puppet.hand.grip = 0.5;
    SafeDevice safe(puppet);
    double time = begin(safe);
    run(safe, puppet, {0, 0, 1}, 300, time);
    REQUIRE(puppet.pushed.z() == 1.0);

    puppet.hand.position.y() = poison;
    const HapticSample sample = safe.read(time);
    safe.write({.force = {0, 0, 1}});

    CHECK(sample.position == Vec3(0.01, 0.02, 0.03));
    CHECK(sample.buttons == 0);
    CHECK(sample.grip == 0.0);  // or jaws would hold on for ever
    CHECK(puppet.pushed == Vec3::Zero());
    CHECK(safe.fault() == DeviceFault::sample_not_finite);

    puppet.hand.position.y() = 0.5;
    CHECK(run(safe, puppet, {0, 0, 1}, 10, time) == Vec3::Zero());
    CHECK(safe.read(time).position == Vec3(0.01, 0.02, 0.03));
  }
}

TEST_CASE("every number of a sample is checked") {
  const auto faults = [](auto poison) {
    Puppet puppet;
    poison(puppet.hand);
    SafeDevice safe(puppet);
    safe.read(0.0);
    return safe.fault() == DeviceFault::sample_not_finite;
  };

  CHECK(faults([](HapticSample& s) { s.position.x() = kNan; }));
  CHECK(faults([](HapticSample& s) { s.orientation.x() = kNan; }));
  CHECK(faults([](HapticSample& s) { s.velocity.z() = kInfinity; }));
  CHECK(faults([](HapticSample& s) { s.grip = kNan; }));
  CHECK_FALSE(faults([](HapticSample&) {}));
}

TEST_CASE("a hand where no device reaches, or faster than any, latches and is named as such") {
  for (const double far : {1e300, -1e300, 11.0}) {
    Puppet puppet;
    puppet.hand.position = Vec3(0.01, 0.02, 0.03);
    SafeDevice safe(puppet);
    double time = begin(safe);
    run(safe, puppet, {0, 0, 1}, 300, time);

    puppet.hand.position.x() = far;
    CHECK(safe.read(time).position == Vec3(0.01, 0.02, 0.03));
    safe.write({.force = {0, 0, 1}});
    CHECK(puppet.pushed == Vec3::Zero());
    CHECK(safe.fault() == DeviceFault::sample_out_of_reach);
    CHECK(safe.fault_value() == std::abs(far));
  }
  Puppet fast;
  fast.hand.velocity.y() = -1e200;
  SafeDevice safe(fast);
  safe.read(0.0);
  CHECK(safe.fault() == DeviceFault::sample_too_fast);
  CHECK(safe.fault_value() == 1e200);
}

TEST_CASE("a force that is not finite latches and never reaches the device") {
  for (const double poison : {kNan, kInfinity}) {
    Puppet puppet;
    SafeDevice safe(puppet);
    double time = begin(safe);
    run(safe, puppet, {0, 0, 1}, 300, time);

    CHECK(run(safe, puppet, {0, poison, 0}, 1, time) == Vec3::Zero());
    CHECK(safe.fault() == DeviceFault::force_not_finite);
    CHECK(run(safe, puppet, {0, 0, 1}, 10, time) == Vec3::Zero());
    CHECK(safe.sent().force == Vec3::Zero());
  }
}

TEST_CASE("a rest is a zero force at once, and the force after it fades in as the first did") {
  Puppet puppet;
  SafeDevice safe(puppet, {.slew_max = 1e6, .ramp_time = 0.2});
  double time = begin(safe);
  run(safe, puppet, {0, 0, 1}, 300, time);
  REQUIRE(puppet.pushed.z() == 1.0);

  safe.rest();
  CHECK(puppet.pushed == Vec3::Zero());
  CHECK(safe.sent().force == Vec3::Zero());

  CHECK(run(safe, puppet, {0, 0, 1}, 1, time) == Vec3::Zero());
  CHECK(run(safe, puppet, {0, 0, 1}, 100, time).z() == doctest::Approx(0.5).epsilon(0.02));
  CHECK(run(safe, puppet, {0, 0, 1}, 150, time).z() == 1.0);
}

TEST_CASE("limits that are not positive are refused") {
  Puppet puppet;

  CHECK_THROWS_AS(SafeDevice(puppet, {.force_max = 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(SafeDevice(puppet, {.slew_max = -1.0}), std::invalid_argument);
  CHECK_THROWS_AS(SafeDevice(puppet, {.ramp_time = kNan}), std::invalid_argument);
  CHECK_THROWS_AS(SafeDevice(puppet, {.force_max = kInfinity}), std::invalid_argument);
  CHECK_THROWS_AS(SafeDevice(puppet, {.force_continuous = 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(SafeDevice(puppet, {.heat_time = -1.0}), std::invalid_argument);
  CHECK_THROWS_AS(SafeDevice(puppet, {.start_force_max = 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(SafeDevice(puppet, {.velocity_max = kNan}), std::invalid_argument);
  CHECK_THROWS_AS(SafeDevice(puppet, {.brake = -1.0}), std::invalid_argument);
  CHECK_THROWS_AS(SafeDevice(puppet, {.energy_max = 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(SafeDevice(puppet, {.damping_max = 0.0}), std::invalid_argument);
}

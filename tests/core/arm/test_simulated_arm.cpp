// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include "palpate/sim/arm/simulated_arm.h"
#include "palpate/sim/device/safe_device.h"
#include "palpate/sim/device/simulated_devices.h"

using namespace palpate;

TEST_CASE("a script moves the simulated arm, which is where the script is but for the arm itself") {
  const Vec3 origin(0.3, 0.2, 0.1);
  ScriptedDevice hand({{0.0, origin + Vec3(0.0, 0.0, 0.03)}, {1.0, origin - Vec3(0.0, 0.0, 0.02)}});
  SimulatedArm arm(hand, origin);
  arm.open();
  double worst = 0.0;

  for (int k = 0; k < 1500; ++k) {
    const HapticSample sample = arm.read(1e-3 * k);
    arm.write({});
    worst = std::max(worst, (sample.position - hand.read(1e-3 * k).position).norm());
  }

  CHECK(worst < 4e-3);  // dry friction and half counts against a hand of 400 N/m
  CHECK(arm.name() == "simulated arm held by script");
  CHECK_FALSE(arm.failed());
  CHECK(hand.last_command.force == Vec3::Zero());
}

TEST_CASE("a force moves the hand by force over stiffness") {
  ScriptedDevice hand({{0.0, Vec3::Zero()}});
  Plant plant;
  plant.dry_friction.setZero();
  SimulatedArm arm(hand, Vec3::Zero(), plant);
  arm.open();
  const auto run = [&](int ticks, const Vec3& force, double& time) {
    Vec3 at;
    for (int k = 0; k < ticks; ++k, time += 1e-3) {
      at = arm.read(time).position;
      arm.write({.force = force});
    }
    return at;
  };
  double time = 0.0;
  const Vec3 before = run(1000, Vec3::Zero(), time);

  const Vec3 after = run(1000, {0.0, 0.0, 0.8}, time);

  CHECK((after - before).z() == doctest::Approx(0.8 / 400.0).epsilon(0.4));  // counts of 0.3 mm
}

TEST_CASE("a hand that wants to leave the workspace stays at its edge, and the arm with it") {
  ScriptedDevice hand({{0.0, Vec3::Zero()}, {0.5, Vec3(0.0, 0.5, 0.0)}});
  SimulatedArm arm(hand);
  arm.open();
  HapticSample sample;

  for (int k = 0; k < 1500; ++k) {
    sample = arm.read(1e-3 * k);
    arm.write({});
  }

  CHECK(sample.position.y() == doctest::Approx(0.06).epsilon(0.05));
  CHECK_FALSE(arm.failed());
}

TEST_CASE("the attach button of the hand comes back through the wire") {
  ScriptedDevice hand({{0.0, Vec3::Zero(), 0}, {0.1, Vec3(1e-3, 0, 0), kAttachButton}});
  SimulatedArm arm(hand);
  arm.open();

  for (int k = 0; k < 90; ++k) CHECK(arm.read(1e-3 * k).buttons == 0);
  HapticSample sample;
  for (int k = 90; k < 120; ++k) sample = arm.read(1e-3 * k);
  CHECK(sample.buttons == kAttachButton);
}

TEST_CASE("a pointer that shows up elsewhere does not fling the arm there") {
  PointerDevice pointer;
  SimulatedArm arm(pointer);
  arm.open();
  Vec3 last = arm.read(0.0).position;
  double fastest = 0.0;

  for (int k = 1; k < 600; ++k) {
    if (k == 100) pointer.set({.position = {0.08, 0.04, 0.05}});
    arm.read(1e-3 * k);
    arm.write({});
    const Vec3 now = find_tip(arm.core().plant(), arm.core().state());
    if (k > 1) fastest = std::max(fastest, (now - last).norm() / 1e-3);
    last = now;
  }

  CHECK(fastest > 0.5);
  CHECK(fastest < 1.5);  // [m/s]
  CHECK((last - Workspace{}.center - Vec3(0.08, 0.04, 0.05)).norm() < 3e-3);
}

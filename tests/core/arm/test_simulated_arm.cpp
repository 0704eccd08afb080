// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arm/turning_hand.h"
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

namespace {

Quaternion turn_about(double angle, const Vec3& axis) {
  return Quaternion(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// [rad] What counts leave open of how the stylus is held: half of one of each of two joints and of
/// the gimbal's three.
double find_resolution(const Plant& plant) { return plant.count + 1.5 * plant.gimbal_count; }

}  // namespace

TEST_CASE("the stylus is turned as the hand turns it, as far as counts tell, by its gimbal alone") {
  const Vec3 axis(0.4, -0.3, 1.0);
  TurningHand hand([&](double time) {
    HapticSample sample;
    sample.position = Vec3(0.05 * std::sin(3.0 * time), 0.0, 0.04 * std::cos(2.0 * time));
    sample.orientation = turn_about(std::sin(2.0 * time), axis);
    return sample;
  });
  SimulatedArm arm(hand);
  arm.open();
  CHECK(arm.read(0.0).orientation.angularDistance(Quaternion::Identity()) <
        find_resolution(arm.core().plant()));
  double worst = 0.0, went = 0.0;

  for (int k = 1; k < 3000; ++k) {
    const HapticSample sample = arm.read(1e-3 * k);
    arm.write({});
    // what is read now was sampled at the tick before
    const Quaternion held = hand.read(1e-3 * (k - 1)).orientation;
    worst = std::max(worst, sample.orientation.angularDistance(held));
    went = std::max(went, arm.core().state().gimbal.cwiseAbs().maxCoeff());
    arm.driver().take_status();
  }

  MESSAGE("turned otherwise by ", worst, " rad at most, gimbal to ", went, " rad");
  CHECK(worst < find_resolution(arm.core().plant()) + 2e-3);  // and a millisecond of 2 rad/s
  CHECK(went > 0.9);
  CHECK_FALSE(arm.failed());
}

TEST_CASE("a hand without orientation holds the stylus upright wherever it goes") {
  ScriptedDevice hand({{0.0, Vec3(-0.09, 0.0, 0.06)},
                       {1.0, Vec3(0.09, 0.05, -0.06)},
                       {1.6, Vec3(0.0, -0.05, 0.0)}});
  SimulatedArm arm(hand);
  arm.open();
  double worst = 0.0, widest = 0.0;

  for (int k = 0; k < 2000; ++k) {
    const HapticSample sample = arm.read(1e-3 * k);
    arm.write({});
    worst = std::max(worst, sample.orientation.angularDistance(Quaternion::Identity()));
    widest = std::max(widest, arm.core().state().gimbal.cwiseAbs().maxCoeff());
  }

  MESSAGE("off upright by ", worst, " rad at most, gimbal to ", widest, " rad");
  CHECK(worst < find_resolution(arm.core().plant()) + 2e-3);
  CHECK(widest > 0.5);
}

TEST_CASE("a stylus is turned no further than its gimbal's sensors read, and no faster than 10/s") {
  Quaternion wanted = Quaternion::Identity();
  TurningHand hand([&](double) { return HapticSample{.orientation = wanted}; });
  SimulatedArm arm(hand);
  arm.open();
  const double most = 500 * arm.core().plant().gimbal_count;
  double time = 0.0, fastest = 0.0;
  const auto run = [&](int ticks) {
    Quaternion held = arm.read(time).orientation, before = held;
    for (int k = 0; k < ticks; ++k) {
      time += 1e-3;
      held = arm.read(time).orientation;
      arm.write({});
      fastest = std::max(fastest, held.angularDistance(before));
      before = held;
    }
    return held;
  };
  run(10);

  wanted = turn_about(3.0, Vec3::UnitZ());
  const Quaternion turned = run(600);
  CHECK(arm.core().state().gimbal.cwiseAbs().maxCoeff() == doctest::Approx(most));
  CHECK(turned.angularDistance(wanted) == doctest::Approx(3.0 - most).epsilon(0.05));
  CHECK(arm.motors() == MotorState::on);  // not at the rail of its sensor
  CHECK(fastest < 10.0 * 1e-3 + 2.0 * find_resolution(arm.core().plant()));

  // what is no orientation turns nothing
  wanted = Quaternion(0.0, 0.0, 0.0, 0.0);
  CHECK(run(50).angularDistance(turned) < 1e-9);
  wanted.w() = std::numeric_limits<double>::quiet_NaN();
  CHECK(run(50).angularDistance(turned) < 1e-9);
}

TEST_CASE("a gimbal sensor whose wire is off is seen in the orientation, and the motors are cut") {
  TurningHand hand([](double) { return HapticSample{}; });
  SimulatedArm arm(hand);
  arm.open();
  for (int k = 0; k < 1000; ++k) {
    arm.read(1e-3 * k);
    arm.write({});
  }
  REQUIRE(arm.motors() == MotorState::on);

  arm.cut_sensor(5, true);
  Quaternion held;
  for (int k = 1000; k < 1020; ++k) {
    held = arm.read(1e-3 * k).orientation;
    arm.write({});
  }

  CHECK(arm.motors() == MotorState::cut);
  CHECK(held.angularDistance(Quaternion::Identity()) > 1.0);
}

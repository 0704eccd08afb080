// SPDX-License-Identifier: GPL-3.0-or-later
// The chip's image moves the simulated arm through the host's own driver: rows 7, 8 and 11 of the
// verification plan with nothing left out but the metal.
#include <doctest/doctest.h>

#include <cstdio>

#include "emulated_bench.h"

using namespace palpate;

namespace {

const auto kNothing = [](const HapticSample&) { return Vec3::Zero(); };
const auto kPush = [](const HapticSample&) { return Vec3(0.0, 0.0, 1.0); };

/// [m] of the tip, after so many seconds in which no force is asked for.
double find_drift(double seconds) {
  EmulatedBench bench;
  bench.start();
  const Vec3 before = find_tip(bench.core.plant(), bench.core.state());
  bench.run(seconds, kNothing);
  return (find_tip(bench.core.plant(), bench.core.state()) - before).norm();
}

/// How far the force is off at most, of that asked for, at so many points of the workspace.
double find_error(int points) {
  EmulatedBench bench(clamped_plant());
  bench.start();
  const double worst = check_forces(bench, 0.06, points);
  std::printf("force at %d points of the workspace: %.1f %% off at most\n", points, 100 * worst);
  return worst;
}

}  // namespace

TEST_CASE("through driver and image, force out is force in within 5 % and a step of the duty") {
  CHECK(find_error(25) < 0.05);
}

TEST_CASE("through driver and image, force out is force in at 100 points of the workspace" *
          doctest::test_suite("verify")) {
  CHECK(find_error(100) < 0.05);
}

TEST_CASE("through driver and image, the stylus is turned as its gimbal is, and its button heard") {
  EmulatedBench bench;
  bench.start();
  const Plant& plant = bench.core.plant();
  const double resolution = plant.count + 1.5 * plant.gimbal_count;
  for (const Vec3& gimbal : {Vec3(0.9, -0.4, 0.2), Vec3(-2.2, 1.3, -1.7), Vec3(0.3, 0.6, 2.2)}) {
    bench.core.state().gimbal = gimbal;
    const int pressed = gimbal[0] > 0.0 ? 1 : 0;
    bench.core.chip().set_buttons(pressed);
    bench.run(0.02, kNothing);

    const Quaternion held = compute_stylus(bench.core.state().joints, gimbal);
    CHECK(bench.sample.orientation.angularDistance(held) < resolution);
    CHECK(bench.sample.buttons == pressed);
  }
}

TEST_CASE("through driver and image, a calibration is stored in the chip and read back from it") {
  EmulatedBench bench;
  bench.device.open();
  Calibration wanted = bench.device.calibration();
  wanted.joints[2].zero += 7;
  wanted.torque_full = {0.31, -0.42, 0.53};
  wanted.serial_number = 4711;

  bench.device.store(wanted);

  const Calibration found = bench.device.calibration();
  CHECK(found.joints[2].zero == wanted.joints[2].zero);
  CHECK(found.torque_full.isApprox(wanted.torque_full, 1e-5));
  CHECK(found.serial_number == 4711);
  CHECK_FALSE(bench.core.drive().enabled);
}

TEST_CASE("through driver and image, the arm left alone for 1 s drifts by less than 0.2 mm") {
  CHECK(find_drift(1.0) < 0.2e-3);
}

TEST_CASE("through driver and image, the arm left alone for 5 s drifts by less than a millimetre" *
          doctest::test_suite("verify")) {
  CHECK(find_drift(5.0) < 1e-3);
}

TEST_CASE("through driver and image, 25 ms after the last command no more than 0.1 N is felt") {
  for (int baud : {1000000, 500000}) {
    for (bool pulled : {false, true}) {
      EmulatedBench bench(clamped_plant(), {.baud = baud});
      bench.start();
      bench.bolt(Workspace{}.center);
      bench.run(0.3, kPush);
      REQUIRE(bench.core.motor_force().norm() > 0.9);

      // the host is killed, or the cable pulled while it goes on
      if (pulled) {
        bench.core.pull_cable();
        bench.run(0.010, kPush);
        CHECK(bench.device.failed());
        bench.core.advance(bench.time + 0.014);
      } else {
        bench.core.advance(bench.time + 0.024);
      }

      CHECK(bench.core.motor_force().norm() <= 0.1);
      CHECK_FALSE(bench.core.drive().enabled);
    }
  }
}

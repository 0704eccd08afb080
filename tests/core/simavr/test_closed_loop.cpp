// SPDX-License-Identifier: GPL-3.0-or-later
// The chip's image moves the simulated arm through the host's own driver: rows 7, 8 and 11 of the
// verification plan with nothing left out but the metal.
#include <doctest/doctest.h>

#include <cstdio>
#include <random>

#include "palpate/sim/haptics/serial_device.h"
#include "palpate/simavr/emulated_core.h"
#include "sim_bench.h"

using namespace palpate;

namespace {

/// A plant whose hand holds the tip as if it were bolted down where it is wanted.
Plant clamped_plant() {
  Plant plant;
  plant.hand = {.mass = 1.0, .stiffness = 1e5, .damping = 400.0};
  plant.dry_friction.setZero();
  return plant;
}

struct EmulatedBench {
  explicit EmulatedBench(const Plant& plant = {}, int baud = 1000000)
      : core(image(baud), plant, {.baud = baud}), device(core, Workspace{}.center) {}

  void start() {
    device.open();
    run(0.7, Vec3::Zero());
    REQUIRE(status().mode == DeviceMode::run);
  }
  void run(double duration, const Vec3& force) {
    for (int k = 0; k < duration / 1e-3 - 1e-9; ++k, time += 1e-3) {
      sample = device.read(time);
      device.write({.force = force});
    }
  }
  const DeviceStatus& status() {
    device.take_status();
    return device.status();
  }
  /// The tip where a hand shall hold it, at rest.
  void bolt(const Vec3& at) {
    core.state().joints = *find_joints(find_arm(core.plant()), at);
    core.state().rates.setZero();
    core.hold({at, Vec3::Zero(), true});
  }

  EmulatedCore core;
  SerialDevice device;
  HapticSample sample;
  double time = 0.0;
};

}  // namespace

TEST_CASE("through driver and image, force out is force in within 5 % and a step of the duty") {
  EmulatedBench bench(clamped_plant());
  bench.start();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-0.5, 0.5), size(0.5, 1.0);
  std::normal_distribution<double> normal;
  const double step = compute_stall_torque(bench.core.plant().motor) / 255.0;  // [N m]
  double worst = 0.0;

  for (int point = 0; point < 100; ++point) {
    const Vec3 at = Workspace{}.center +
                    Vec3(part(random), part(random), part(random)).cwiseProduct(Workspace{}.size);
    const Vec3 force =
        size(random) * Vec3(normal(random), normal(random), normal(random)).normalized();
    bench.bolt(at);
    bench.run(0.06, force);

    const Arm arm = find_arm(bench.core.plant());
    const Vec3 felt = -bench.core.state().hand_force;
    const Vec3 one_step = compute_tip_force(
        arm, bench.core.state().joints,
        compute_weight_torque(arm, bench.core.state().joints) + Vec3::Constant(step));
    REQUIRE(bench.status().mode == DeviceMode::run);
    CHECK((felt - force).norm() < 0.05 * force.norm() + one_step.norm());
    worst = std::max(worst, (felt - force).norm() / force.norm());
  }
  std::printf("force at 100 points of the workspace: %.1f %% off at most\n", 100 * worst);
}

TEST_CASE("through driver and image, the arm left alone drifts by less than a millimetre") {
  EmulatedBench bench;
  bench.start();
  const Vec3 before = find_tip(bench.core.plant(), bench.core.state());

  bench.run(5.0, Vec3::Zero());

  CHECK((find_tip(bench.core.plant(), bench.core.state()) - before).norm() < 1e-3);
}

TEST_CASE("through driver and image, 25 ms after the last command no more than 0.1 N is felt") {
  for (int baud : {1000000, 500000}) {
    for (bool pulled : {false, true}) {
      EmulatedBench bench(clamped_plant(), baud);
      bench.start();
      bench.bolt(Workspace{}.center);
      bench.run(0.3, Vec3(0.0, 0.0, 1.0));
      REQUIRE(bench.core.motor_force().norm() > 0.9);

      // the host is killed, or the cable pulled while it goes on
      if (pulled) {
        bench.core.pull_cable();
        bench.run(0.010, Vec3(0.0, 0.0, 1.0));
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

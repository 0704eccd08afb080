// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <doctest/doctest.h>

#include <random>

#include "core/arm/plants.h"
#include "palpate/sim/arm/serial_device.h"
#include "palpate/sim/arm/simulated_arm.h"

namespace palpate {

/// The driver on a simulated device and its arm, run in virtual time.
template <class Core>
struct BenchOf {
  template <class... Arguments>
  explicit BenchOf(const Arguments&... arguments)
      : core(arguments...), device(core, Workspace{}.center) {}  // the scene's frame is the arm's

  /// Opens, and runs without force until the motors have their full force.
  void start() {
    device.open();
    run(0.7, [](const HapticSample&) { return Vec3::Zero(); });
  }

  /// Ticks of 1 ms in which the hand feels `force(sample)`.
  template <class Force>
  void run(double duration, Force force) {
    for (int k = 0; k < duration / 1e-3 - 1e-9; ++k, time += 1e-3) {
      sample = device.read(time);
      device.write({.force = force(sample)});
    }
  }

  const DeviceStatus& status() {
    device.take_status();
    return device.status();
  }

  /// The tip where a hand shall hold it [m], at rest.
  void bolt(const Vec3& at) {
    core.state().joints = *find_joints(find_arm(core.plant()), at);
    core.state().rates.setZero();
    core.hold({at, Vec3::Zero(), true});
  }

  /// What a step of each duty and the arm's weight are worth at the tip [N].
  double force_of_a_step() const {
    const Arm arm = find_arm(core.plant());
    const Vec3& joints = core.state().joints;
    const Vec3 step = Vec3::Constant(compute_stall_torque(core.plant().motor) / 255.0);
    return compute_tip_force(arm, joints, compute_weight_torque(arm, joints) + step).norm();
  }

  Core core;
  SerialDevice device;
  HapticSample sample;
  double time = 0.0;
};

/// On the firmware's own code, compiled for this machine.
struct DeviceBench : BenchOf<NativeCore> {
  explicit DeviceBench(const Plant& plant = {}, const NativeCoreOptions& options = {})
      : BenchOf(plant, options) {}
};

/// Checks at 100 points of the workspace that a force of 0.5 to 1 N, commanded for `settle` [s], is
/// what a clamped hand feels and what the driver says, within 5 % and a step of the duty. Returns
/// the largest share that it was off by.
template <class Bench>
double check_forces(Bench& bench, double settle, int points = 100) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-0.5, 0.5), size(0.5, 1.0);
  std::normal_distribution<double> normal;
  double worst = 0.0;
  for (int point = 0; point < points; ++point) {
    const Vec3 at = Workspace{}.center +
                    Vec3(part(random), part(random), part(random)).cwiseProduct(Workspace{}.size);
    const Vec3 force =
        size(random) * Vec3(normal(random), normal(random), normal(random)).normalized();
    bench.bolt(at);
    bench.run(settle, [&force](const HapticSample&) { return force; });

    const Vec3 felt = -bench.core.state().hand_force;
    const double allowed = 0.05 * force.norm() + bench.force_of_a_step();
    REQUIRE(bench.status().mode == DeviceMode::run);
    CHECK((felt - force).norm() < allowed);
    CHECK((bench.status().force_applied - felt).norm() < allowed);
    worst = std::max(worst, (felt - force).norm() / force.norm());
  }
  return worst;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/haptics/native_core.h"
#include "palpate/sim/haptics/serial_device.h"

namespace palpate {

/// The driver on the firmware's own code and a simulated arm, run in virtual time.
struct DeviceBench {
  explicit DeviceBench(const Plant& plant = {}, const NativeCoreOptions& options = {})
      : core(plant, options), device(core, Workspace{}.center) {}  // the scene's frame is the arm's

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

  NativeCore core;
  SerialDevice device;
  HapticSample sample;
  double time = 0.0;
};

/// A plant whose hand holds the tip as if it were bolted down where it is wanted.
inline Plant clamped_plant() {
  Plant plant;
  plant.hand = {.mass = 1.0, .stiffness = 1e5, .damping = 400.0};
  plant.dry_friction.setZero();
  return plant;
}

}  // namespace palpate

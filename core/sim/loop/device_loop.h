// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "palpate/sim/device/safe_device.h"

namespace palpate {

/// What the hand shall feel where there is no tissue: a force, and a spring to a place.
struct DeviceTask {
  Vec3 force = Vec3::Zero();  ///< [N]
  double stiffness = 0.0;     ///< [N/m] 0 for no spring
  Vec3 rest = Vec3::Zero();   ///< [m] where the spring draws to
};
static_assert(sizeof(DeviceTask) == 56 && alignof(DeviceTask) == 8);

/// Throws std::invalid_argument naming the field, what it got and what was expected.
void validate(const DeviceTask& task);

/// Keeps a device company at 1 kHz without a tissue, as its window, its test and its calibration
/// need it: F = force + stiffness (rest - x), sent through a SafeDevice. Either in a thread of its
/// own, by the clock; or, for a simulated device, as fast as the machine can, in the caller's.
class DeviceLoop {
 public:
  /// `device` must outlive the loop. Throws as SafeDevice does.
  explicit DeviceLoop(HapticDevice& device, const SafetyLimits& limits = {});
  ~DeviceLoop();  ///< stops and joins

  void start();  ///< throws std::logic_error while it runs; may be started again once stopped
  void stop();   ///< asks and waits; the device gets a zero force last
  bool running() const noexcept;
  /// Ticks for so many [s] in this thread, without waiting. Throws std::logic_error while the
  /// loop's own thread runs, std::invalid_argument for no time or more than a day.
  void run(double seconds);

  /// One calling thread: felt from the next tick on. Throws std::invalid_argument.
  void set_task(const DeviceTask& task);
  /// From any thread: the device hears nothing for so many [s], as if the host had died.
  void fall_silent(double seconds) noexcept;

  double time() const noexcept;  ///< [s] that the loop has run
  long missed_ticks() const noexcept;
  DeviceFault fault() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace palpate

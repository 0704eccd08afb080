// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/haptics/device.h"

namespace palpate {

struct SafetyLimits {
  double force_max = 5.0;    ///< [N] norm
  double slew_max = 2000.0;  ///< [N/s]
  double ramp_time = 0.2;  ///< [s] from the first command, or the first after a rest, to full force
};

enum class DeviceFault { none, sample_not_finite, force_not_finite };

/// Stands between the tick and any device: nothing non-finite passes, forces are limited in norm
/// and slew and fade in at the start. The first fault latches: the force is zero from then on and
/// the hand stays where it was last known.
class SafeDevice : public HapticDevice {
 public:
  /// `device` must outlive this. Throws std::invalid_argument for limits that are not positive.
  explicit SafeDevice(HapticDevice& device, const SafetyLimits& limits = {});

  /// Ramp and slew go by the `time` given here, whatever clock the device may have.
  HapticSample read(double time) noexcept override;
  void write(const HapticCommand& command) noexcept override;
  /// A zero force at once, past the slew limit; the next command fades in as the first one did.
  void rest() noexcept;
  std::string name() const override { return device_.name(); }

  DeviceFault fault() const noexcept { return fault_; }
  /// What was really sent last.
  const HapticCommand& sent() const noexcept { return sent_; }
  /// How often the norm clamp or the slew limit had to act.
  long limited_count() const noexcept { return limited_count_; }

 private:
  HapticDevice& device_;
  SafetyLimits limits_;
  HapticSample last_sample_;
  HapticCommand sent_;
  double now_ = 0.0;         ///< [s] of the last read
  double first_time_ = 0.0;  ///< [s] of the first command
  double last_time_ = 0.0;   ///< [s] of the last command
  bool commanded_ = false;
  DeviceFault fault_ = DeviceFault::none;
  long limited_count_ = 0;
};

}  // namespace palpate

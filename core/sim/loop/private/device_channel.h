// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

#include "palpate/sim/loop/loop.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

/// The device of one instrument in the live loop, behind its safety wrapper, and what it gave.
class DeviceChannel {
 public:
  /// `period` [s] of the ticks.
  DeviceChannel(HapticDevice& device, const SafetyLimits& limits, double period);

  // haptic thread
  SafeDevice& safe() noexcept { return safe_; }
  MotorState motors() const noexcept { return motors_; }  ///< as it was noticed last
  /// Whether the device still gives its force, and what became of it where it does not: told to
  /// `log`, if there is one, as of this tick and instrument.
  void notice(std::int64_t tick, int instrument, TickLog* log) noexcept;
  /// Whether the passivity controller had to act in this tick: told to `log`, if there is one, when
  /// it begins to after a calm.
  void notice_damping(std::int64_t tick, int instrument, TickLog* log) noexcept;
  long interventions() const noexcept { return interventions_.load(std::memory_order_relaxed); }
  /// What the hand really felt of a tick that left its instrument like this.
  void count_force(const InstrumentState& instrument) noexcept;
  void end() noexcept;  ///< a zero force, past the slew limit that would let it linger

  // any thread
  /// [N/m] of find_passive_stiffness at the start.
  double passive_stiffness() const noexcept { return passive_stiffness_; }
  /// [us] by which a force was late then, T/2 + d.
  std::int32_t delay_us() const noexcept { return delay_us_; }
  DeviceFault fault() const noexcept { return fault_.load(std::memory_order_acquire); }
  DeviceReport report() const;

 private:
  HapticDevice& device_;
  SafeDevice safe_;
  const double passive_stiffness_;  // [N/m]
  const std::int32_t delay_us_;
  MotorState motors_ = MotorState::on;
  double touch_force_sum_ = 0.0;   // [N]
  std::int64_t last_damped_ = -1;  // tick; negative before the first
  std::atomic<DeviceFault> fault_{DeviceFault::none};
  std::atomic<double> fault_value_{0.0};
  std::atomic<long> unrendered_{0}, touch_ticks_{0}, damped_{0}, interventions_{0};
  std::atomic<double> peak_force_{0.0}, touch_force_{0.0};  // [N]
  std::atomic<long> follows_tissue_{0};                     // ticks
  std::atomic<double> tissue_stiffness_{0.0};               // [N/m]
  std::atomic<double> stiffness_error_{0.0};                // [-]
};

/// One for each instrument. Throws std::invalid_argument where scene, devices, options and log (or
/// null) do not have as many of them, or a device is there twice.
std::vector<std::unique_ptr<DeviceChannel>> open_channels(const Scene& scene,
                                                          std::span<HapticDevice* const> devices,
                                                          const LoopOptions& options,
                                                          const TickLog* log);

/// Fills in what a report says of all devices together, from what it says of each.
void sum_devices(LoopReport& report);

}  // namespace palpate

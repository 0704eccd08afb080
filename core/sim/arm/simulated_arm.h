// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>

#include "palpate/sim/arm/native_core.h"
#include "palpate/sim/arm/serial_device.h"

namespace palpate {

/// The low-cost device without its metal: a hand holds a simulated arm, whose firmware is the real
/// one, and is felt through the real driver. What the tick gets is what sensors, wire and driver
/// make of where the arm is; what the hand gets is what the motors make of the force.
class SimulatedArm : public HapticDevice {
 public:
  /// `hand` says where the hand wants to be, in the scene, whose place `origin` [m] is the middle
  /// of the arm's workspace; it must outlive this. Throws std::invalid_argument.
  explicit SimulatedArm(HapticDevice& hand, const Vec3& origin = Vec3::Zero(),
                        const Plant& plant = {}, const NativeCoreOptions& options = {});

  /// Puts the arm where the hand begins and makes the link. Throws DeviceError.
  void open();

  HapticSample read(double time) noexcept override;
  void write(const HapticCommand& command) noexcept override;
  void end() noexcept override { driver_.end(); }
  void rest(double seconds) noexcept override;
  std::string name() const override { return "simulated arm held by " + hand_.name(); }
  bool failed() const noexcept override { return driver_.failed(); }
  MotorState motors() const noexcept override { return driver_.motors(); }
  std::string explain_fault() const override { return driver_.explain_fault(); }

  /// From any thread, heard by the next read: whether the hand may leave the workspace and go to
  /// the stops of the joints.
  void widen(bool wide) noexcept { wide_.store(wide, std::memory_order_relaxed); }
  /// Likewise, what can happen to a device; as NativeCore has it.
  void press_stop(bool pressed) noexcept { stopped_.store(pressed, std::memory_order_relaxed); }
  void cut_sensor(int joint, bool cut) noexcept;
  void pull_cable() noexcept { unplugged_.store(true, std::memory_order_relaxed); }
  /// From any thread: [N] of the hand on the stylus, as a scale between them would say.
  Vec3 hand_force() const noexcept;

  NativeCore& core() noexcept { return core_; }
  SerialDevice& driver() noexcept { return driver_; }

 private:
  Vec3 to_arm(const Vec3& position) const noexcept;
  void follow_orders() noexcept;
  void tell_hand_force() noexcept;

  HapticDevice& hand_;
  const Vec3 origin_;
  Vec3 place_ = Workspace{}.center;  ///< [m] where the hand is, in the arm's frame
  double time_ = 0.0;                ///< [s] of the last read
  std::atomic<bool> wide_{false}, stopped_{false}, unplugged_{false};
  std::array<std::atomic<bool>, 6> cut_{};
  std::array<std::atomic<double>, 3> hand_force_{};  ///< [N]
  NativeCore core_;
  SerialDevice driver_;
};

}  // namespace palpate

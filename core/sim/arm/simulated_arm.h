// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <string>

#include "palpate/sim/arm/calibration.h"
#include "palpate/sim/arm/plant.h"
#include "palpate/sim/arm/serial_device.h"
#include "palpate/sim/arm/transport.h"

namespace palpate {

/// How the simulated wire and the clocks at its ends are.
struct NativeCoreOptions {
  double baud = 1e6;             ///< [bit/s]
  double link_delay = 0.0;       ///< [s] of what joins wire and host, each way
  double report_delay = 0.5e-3;  ///< [s] from a tick's samples to the first byte of its report
  double drift = 0.0;            ///< by how much the device's clock is fast, 1e-6 for 1 ppm
  bool calibrated = true;        ///< its EEPROM holds what find_calibration says of the plant
  bool damaged = false;          ///< a byte of that has changed since it was stored
};

/// The firmware's own C code, compiled for this machine, on a simulated arm at the far end of a
/// simulated wire: bytes go in and come out as they would of the real device. The same in every
/// run; no clock but the time it is given.
class NativeCore : public Transport {
 public:
  /// Throws std::invalid_argument.
  explicit NativeCore(const Plant& plant = {}, const NativeCoreOptions& options = {});
  ~NativeCore() override;

  std::size_t read(double time, std::span<std::uint8_t> bytes) noexcept override;
  void write(double time, std::span<const std::uint8_t> bytes) noexcept override;
  bool is_open() const noexcept override;
  std::string name() const override { return "native core"; }

  /// Lives on up to `time` [s] although nobody reads; what it says is then lost.
  void advance(double time) noexcept;
  double time() const noexcept;  ///< [s] of the run, up to which it has lived
  /// Whether and where to a hand moves the stylus.
  void hold(const HandTarget& hand) noexcept;
  void press_buttons(std::uint8_t buttons) noexcept;
  void press_stop(bool pressed) noexcept;         ///< the emergency stop
  void cut_sensor(int joint, bool cut) noexcept;  ///< its wire is off: the reading is at the rail
  void pull_cable() noexcept;                     ///< from then on nothing goes either way
  void reset() noexcept;                          ///< as if its power had failed for a moment

  const Plant& plant() const noexcept;
  /// The arm as it really is.
  const PlantState& state() const noexcept;
  PlantState& state() noexcept;
  /// What the motors get.
  const Drive& drive() const noexcept;
  /// [N] of the motors at the tip, without the arm's own weight.
  Vec3 motor_force() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The low-cost device without its metal: a hand holds a simulated arm, whose firmware is the real
/// one, and is felt through the real driver. What the tick gets is what sensors, wire and driver
/// make of where the arm is and how its gimbal is turned; what the hand gets is what the motors
/// make of the force. The gimbal goes as the hand turns the stylus, and no further than its sensors
/// read.
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
  DeviceDynamics dynamics() const noexcept override { return driver_.dynamics(); }
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
  void turn_hand(const Quaternion& wanted, double most) noexcept;
  void turn_gimbal() noexcept;
  void tell_hand_force() noexcept;

  HapticDevice& hand_;
  const Vec3 origin_;
  Vec3 place_ = Workspace{}.center;           ///< [m] where the hand is, in the arm's frame
  Quaternion turn_ = Quaternion::Identity();  ///< unit, as the hand holds the stylus
  double time_ = 0.0;                         ///< [s] of the last read
  std::atomic<bool> wide_{false}, stopped_{false}, unplugged_{false};
  std::array<std::atomic<bool>, 6> cut_{};
  std::array<std::atomic<double>, 3> hand_force_{};  ///< [N]
  NativeCore core_;
  SerialDevice driver_;
};

/// A simulated device behind a pseudo terminal: a file that any program can open as if it were the
/// serial port of the real one. It lives in real time in a thread of its own.
class PtyDevice {
 public:
  /// A hand holds its stylus in the middle of the workspace. Throws DeviceError where the system
  /// gives no pseudo terminal.
  explicit PtyDevice(const Plant& plant = {}, const NativeCoreOptions& options = {});
  ~PtyDevice();  ///< unplugs it

  std::string path() const;
  /// From any thread: bits 0 and 1.
  void press_buttons(std::uint8_t buttons) noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace palpate

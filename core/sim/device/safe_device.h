// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "palpate/sim/device/device.h"

namespace palpate {

/// The speed of something that is known in steps, from a window that adapts itself: as many of the
/// last readings as one straight line passes within a step of. Slow motion gets a long window
/// and little noise, fast motion a short one and little delay.
///
/// Readings may be missing. Allocates nothing.
class VelocityWindow {
 public:
  static constexpr int kLongest = 32;  ///< readings

  VelocityWindow() = default;
  /// `step` is how far apart two neighbouring readings are, in their unit; `longest` from 2
  /// readings to kLongest. Throws std::invalid_argument.
  explicit VelocityWindow(double step, int longest = 16);

  /// Takes a reading at `time` [s] and returns its speed, in the reading's unit per second; 0 for
  /// the first. The same time again is ignored, an earlier one starts again.
  double add(double time, double value) noexcept;
  double speed() const noexcept { return speed_; }
  /// How many readings the last speed came from.
  int length() const noexcept { return length_; }
  void clear() noexcept;

 private:
  double time_ago(int n) const noexcept { return times_[slot(n)]; }
  double value_ago(int n) const noexcept { return values_[slot(n)]; }
  std::size_t slot(int n) const noexcept {
    return static_cast<std::size_t>((newest_ - n + kLongest) % kLongest);
  }
  bool fits(int n) const noexcept;

  std::array<double, kLongest> times_{}, values_{};
  double step_ = 0.0;
  int longest_ = 16;
  int newest_ = -1, count_ = 0, length_ = 0;
  double speed_ = 0.0;
};

/// What a device may be sent. The defaults suit a device that nothing can hurt; a real one is given
/// its own, as find_safety_limits does for the low-cost arm.
struct SafetyLimits {
  double force_max = 5.0;         ///< [N] norm, at any moment
  double force_continuous = 5.0;  ///< [N] root mean square that the motors stand for ever
  double heat_time = 10.0;        ///< [s] in which they warm up
  double slew_max = 2000.0;       ///< [N/s]
  double ramp_time = 0.2;  ///< [s] from the first command, or the first after a rest, to full force
  double start_force_max = 0.5;  ///< [N] no force at all before one as small as this was asked for
  double velocity_max = 2.0;     ///< [m/s] of the hand; beyond it forces only brake
  double brake = 1.0;            ///< [N·s/m] on what is faster
  double energy_max = 2e-3;      ///< [J] the hand may be given more than it gave; then damping
  double damping_max = 2.0;      ///< [N·s/m] that the passivity controller may add
};

enum class DeviceFault {
  none,
  sample_not_finite,
  force_not_finite,
  device_failed,
  sample_out_of_reach,  ///< a hand beyond 10 m: no device reaches there
  sample_too_fast,      ///< a hand faster than 1000 m/s
  motors_cut,           ///< MotorState::cut; of the live loop alone, for the motors may come back
};

/// One sentence without a stop. `value` is what the fault found, [m] or [m/s] where it has one;
/// what the motors are cut for, or why the device failed, `device` says. From any thread.
std::string describe_fault(DeviceFault fault, double value, const HapticDevice& device);

/// Stands between the tick and any device. What passes is finite and within 10 m, gives the hand no
/// energy it did not put in, never pushes a hand that is too fast, is limited in norm, moment by
/// moment and on the whole, fades in at the start, and changes no faster than the slew limit. The
/// first fault latches: the force is zero from then on and the hand stays where it was last known.
/// While the device's motors are not on nothing is sent, and the force then fades in again.
class SafeDevice : public HapticDevice {
 public:
  /// `device` must outlive this. Throws std::invalid_argument for limits that are not positive, or
  /// a force for ever above the one for moments.
  explicit SafeDevice(HapticDevice& device, const SafetyLimits& limits = {});

  /// Ramp and slew go by the `time` given here, whatever clock the device may have.
  HapticSample read(double time) noexcept override;
  void write(const HapticCommand& command) noexcept override;
  /// [m] Where the tool is that the force of the next command draws the hand to; until this is
  /// told, at the hand. By it is judged how much of what the hand put in it may get back. A place
  /// that is not finite is passed over.
  void set_tool(const Vec3& position) noexcept {
    if (position.allFinite()) tool_ = position;
  }
  void end() noexcept override { device_.end(); }
  /// A zero force at once, past the slew limit; the next command fades in as the first one did.
  void rest(double seconds = 0.0) noexcept override;
  std::string name() const override { return device_.name(); }
  DeviceDynamics dynamics() const noexcept override { return device_.dynamics(); }
  bool failed() const noexcept override { return device_.failed(); }
  /// Cut too once a fault has latched.
  MotorState motors() const noexcept override {
    return fault_ == DeviceFault::none ? device_.motors() : MotorState::cut;
  }
  std::string explain_fault() const override { return device_.explain_fault(); }
  double report_rate() const noexcept override { return device_.report_rate(); }
  bool wait_for_report(std::int64_t latest) noexcept override {
    return device_.wait_for_report(latest);
  }

  DeviceFault fault() const noexcept { return fault_; }
  /// What the fault found: [m] or [m/s], 0 for a fault without a value.
  double fault_value() const noexcept { return fault_value_; }
  /// What was really sent last; nothing while the motors are not on.
  const HapticCommand& sent() const noexcept { return sent_; }
  /// How often a limit had to act.
  long limited_count() const noexcept { return limited_count_; }
  /// How often the passivity controller had to.
  long damped_count() const noexcept { return damped_count_; }
  /// [J] that the hand has been given since it last felt nothing, fading within a second but for
  /// what it put in and may get back. What a force that is held gives it is left out as far as the
  /// device declares to take it up.
  double given_energy() const noexcept { return given_energy_; }
  /// Of what the motors stand for ever, 0 to 1.
  double heat() const noexcept;

 private:
  void follow_hand(double time) noexcept;
  double follow_tool(const Vec3& hand) noexcept;
  void judge(const HapticSample& sample) noexcept;
  void credit_holding(const Vec3& force) noexcept;
  bool may_send(const Vec3& force) noexcept;
  bool may_start(const Vec3& force) noexcept;
  Vec3 damp(const Vec3& force) noexcept;
  Vec3 brake(const Vec3& force) const noexcept;
  double force_limit() const noexcept;
  Vec3 slew(const Vec3& wanted) const noexcept;

  HapticDevice& device_;
  SafetyLimits limits_;
  DeviceDynamics dynamics_;
  HapticSample last_sample_;
  Vec3 last_move_ = Vec3::Zero();  ///< [m] of the hand between the last two reads
  std::optional<Vec3> tool_;       ///< [m] of the command that was sent last
  Vec3 last_tool_ = Vec3::Zero();  ///< [m] of the one before
  Vec3 untouched_ = Vec3::Zero();  ///< [m] where the tool was when the hand last was sent nothing
  double pressed_ = 0.0;           ///< [m] that it was moved against the force since
  HapticCommand sent_;
  bool has_sample_ = false;
  double now_ = 0.0;         ///< [s] of the last read
  double pause_ = 0.0;       ///< [s] between the last two reads
  double first_time_ = 0.0;  ///< [s] of the first command
  double last_time_ = 0.0;   ///< [s] of the last command
  bool started_ = false, commanded_ = false;
  double given_energy_ = 0.0;
  double warmth_ = 0.0;  ///< [N²] running mean of the squared force
  DeviceFault fault_ = DeviceFault::none;
  double fault_value_ = 0.0;
  long limited_count_ = 0, damped_count_ = 0;
};
static_assert(alignof(SafeDevice) == 8);

}  // namespace palpate

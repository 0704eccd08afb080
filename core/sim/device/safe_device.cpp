// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/device/safe_device.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

/// [s] A pause between commands saves up no more slew than this, so that a stall does not end in
/// an impact; two ticks at 1 kHz.
constexpr double kLongestGap = 2e-3;

/// [s] in which energy that the hand was given is forgotten: it has moved the hand by then. So is
/// what it put in, but for what it may get back.
constexpr double kEnergyTime = 1.0;

/// The share of the heat that motors stand from which on the force is taken back.
constexpr double kWarm = 0.8;

// further and faster than any hand; numbers beyond would overflow where they are squared
constexpr double kFarthest = 10.0;   // [m] from the origin, along each axis
constexpr double kFastest = 1000.0;  // [m/s]

void require_positive(const char* field, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw std::invalid_argument(std::string("safety limits: ") + field + ": got " +
                                std::to_string(value) + ", expected a positive number");
  }
}

void validate(const SafetyLimits& limits) {
  require_positive("force_max [N]", limits.force_max);
  require_positive("force_continuous [N]", limits.force_continuous);
  require_positive("heat_time [s]", limits.heat_time);
  require_positive("slew_max [N/s]", limits.slew_max);
  require_positive("ramp_time [s]", limits.ramp_time);
  require_positive("start_force_max [N]", limits.start_force_max);
  require_positive("velocity_max [m/s]", limits.velocity_max);
  require_positive("brake [N s/m]", limits.brake);
  require_positive("energy_max [J]", limits.energy_max);
  require_positive("damping_max [N s/m]", limits.damping_max);
}

bool is_finite(const HapticSample& sample) noexcept {
  return std::isfinite(sample.time) && sample.position.allFinite() &&
         sample.orientation.coeffs().allFinite() && sample.velocity.allFinite() &&
         std::isfinite(sample.grip);
}

}  // namespace

SafeDevice::SafeDevice(HapticDevice& device, const SafetyLimits& limits)
    : device_(device), limits_(limits), dynamics_(device.dynamics()) {
  validate(limits);
  // who sets only the one for short times means no more for long ones
  limits_.force_continuous = std::min(limits.force_continuous, limits.force_max);
}

HapticSample SafeDevice::read(double time) noexcept {
  follow_hand(time);
  if (fault_ != DeviceFault::none) {
    last_sample_.time = time;
    last_sample_.velocity.setZero();
    last_sample_.buttons = 0;
    last_sample_.grip = 0.0;
  }
  return last_sample_;
}

/// Asks the device, and keeps the passivity observer [HannafordRyu02]: the force of the last tick
/// was held while the hand moved on, so the hand has been given
///
///     E += f_{k-1} . (x_k - x_{k-1}).
///
/// What it put in while something was felt is forgotten once nothing is, so a long stroking of
/// tissue, which swallows energy, does not hide what comes after it; and meanwhile as far as it is
/// more than the force can give back (`follow_tool`).
void SafeDevice::follow_hand(double time) noexcept {
  pause_ = std::clamp(time - now_, 0.0, kLongestGap);
  now_ = time;
  if (fault_ != DeviceFault::none) return;
  const HapticSample sample = device_.read(time);
  if (device_.failed()) {
    fault_ = DeviceFault::device_failed;
    return;
  }
  judge(sample);
  if (fault_ != DeviceFault::none) return;
  last_move_.setZero();
  if (has_sample_) {
    last_move_ = sample.position - last_sample_.position;
    given_energy_ += sent_.force.dot(last_move_);
    if (sent_.force.isZero(0.0)) given_energy_ = std::max(given_energy_, 0.0);
    const double kept = std::clamp(-given_energy_, 0.0, follow_tool(sample.position));
    given_energy_ -= (given_energy_ + kept) * std::min(1.0, pause_ / kEnergyTime);
  }
  warmth_ += (sent_.force.squaredNorm() - warmth_) * std::min(1.0, pause_ / limits_.heat_time);
  last_sample_ = sample;
  has_sample_ = true;
}

/// Follows the tool; [J] that the force f can give a hand at x back at most, of whatever gets
/// harder, or no softer, the deeper it is pressed: of what draws the hand to its tool, at p, f . (p
/// - x), however far it was led round a body that holds the tool; and |f| d of what the tool is
/// pressed d into, which is
///
///     d_k = d_{k-1} - f/|f| . (p_k - p_{k-1}),
///
/// of its way against the force, no less than 0 and no more than from where nothing was felt last:
/// so a stroke to and fro makes it no deeper than it is long.
double SafeDevice::follow_tool(const Vec3& hand) noexcept {
  const Vec3 tool = tool_.value_or(hand);
  const Vec3 moved = tool - last_tool_;
  last_tool_ = tool;
  const double norm = sent_.force.norm();
  if (norm == 0.0) {
    untouched_ = tool;
    pressed_ = 0.0;
    return 0.0;
  }
  const double deepest = (tool - untouched_).norm();
  pressed_ = std::clamp(pressed_ - sent_.force.dot(moved) / norm, 0.0, deepest);
  return std::max(0.0, sent_.force.dot(tool - hand)) + norm * pressed_;
}

void SafeDevice::judge(const HapticSample& sample) noexcept {
  const double farthest = sample.position.lpNorm<Eigen::Infinity>();
  const double fastest = sample.velocity.lpNorm<Eigen::Infinity>();
  if (!is_finite(sample)) {
    fault_ = DeviceFault::sample_not_finite;
  } else if (farthest > kFarthest) {
    fault_ = DeviceFault::sample_out_of_reach;
    fault_value_ = farthest;
  } else if (fastest > kFastest) {
    fault_ = DeviceFault::sample_too_fast;
    fault_value_ = fastest;
  }
}

/// While a hand moved by dx the last force was held, which the new one answers. What the hand was
/// given by that alone, (f_{k-1} - f_k) . dx, which of a spring K is K |dx|^2 however slowly it is
/// pressed and let go, is taken up by the device as far as b |dx|^2/T [Colgate97], or drives
/// nothing where no force moves the hand.
void SafeDevice::credit_holding(const Vec3& force) noexcept {
  const double held = (sent_.force - force).dot(last_move_);
  if (!(held > 0.0)) return;
  const double taken_up =
      pause_ > 0.0 ? dynamics_.damping * last_move_.squaredNorm() / pause_ : 0.0;
  given_energy_ -= dynamics_.position_source ? held : std::min(held, taken_up);
}

/// The ramp begins with the first command that is small, or a hand that is in the tissue when the
/// motors come on would be pushed out of it by a force nobody saw coming.
bool SafeDevice::may_start(const Vec3& force) noexcept {
  if (!started_ && force.stableNorm() > limits_.start_force_max) return false;
  if (!commanded_) first_time_ = last_time_ = now_;
  started_ = commanded_ = true;
  return true;
}

/// The passivity controller [HannafordRyu02]: a damper that takes back within this tick what the
/// hand has been given too much, as far as `damping_max` goes,
///
///     f' = f - a v,   a = min(a_max, (E - E_max) / (|v|^2 dt)).
Vec3 SafeDevice::damp(const Vec3& force) noexcept {
  const double excess = given_energy_ - limits_.energy_max;
  const Vec3& v = last_sample_.velocity;
  const double per_damping = v.squaredNorm() * pause_;
  if (!(excess > 0.0) || !(per_damping > 0.0)) return force;
  ++damped_count_;
  return force - std::min(limits_.damping_max, excess / per_damping) * v;
}

/// A hand beyond velocity_max is pushed no harder than before and never along its way, and is
/// braked: f' = f - (f.n)+ n - c (|v| - v_max) n, with n = v/|v|.
Vec3 SafeDevice::brake(const Vec3& force) const noexcept {
  const double speed = last_sample_.velocity.norm();
  if (!(speed > limits_.velocity_max)) return force;
  const Vec3 n = last_sample_.velocity / speed;
  Vec3 wanted = force - std::max(0.0, force.dot(n)) * n;
  const double most = sent_.force.norm();
  if (wanted.norm() > most) wanted *= most / wanted.norm();
  return wanted - limits_.brake * (speed - limits_.velocity_max) * n;
}

double SafeDevice::heat() const noexcept {
  return warmth_ / (limits_.force_continuous * limits_.force_continuous);
}

/// From the peak down to what the motors stand for ever while their heat, a running mean of the
/// squared force, goes from 80 to 100 % of what they stand. It never gets beyond that, for at 100 %
/// no force is left that would heat them further.
double SafeDevice::force_limit() const noexcept {
  const double forever = limits_.force_continuous;
  const double left = std::clamp((1.0 - heat()) / (1.0 - kWarm), 0.0, 1.0);
  return forever + (limits_.force_max - forever) * left;
}

Vec3 SafeDevice::slew(const Vec3& wanted) const noexcept {
  const Vec3 change = wanted - sent_.force;
  const double most = limits_.slew_max * std::clamp(now_ - last_time_, 0.0, kLongestGap);
  return change.norm() > most ? Vec3(sent_.force + change * (most / change.norm())) : wanted;
}

/// What motors that are not on are sent nobody feels: it heats nothing and moves no hand. Once they
/// are, the force fades in, but for a few reports that were missing.
bool SafeDevice::may_send(const Vec3& force) noexcept {
  if (fault_ != DeviceFault::none) return false;
  const MotorState state = device_.motors();
  if (state == MotorState::on) return may_start(force);
  if (state != MotorState::silent) commanded_ = false;
  return false;
}

/// The norm is clamped before the fade-in and the slew limit: a step from a force within the norm
/// towards another stays within it, so the last limit cannot undo the first.
void SafeDevice::write(const HapticCommand& command) noexcept {
  if (!command.force.allFinite() && fault_ == DeviceFault::none) {
    fault_ = DeviceFault::force_not_finite;
  }
  if (!may_send(command.force)) {
    sent_.force.setZero();
    device_.write(sent_);
    return;
  }
  // a huge force must not overflow into a zero, here or in the sums below
  Vec3 wanted = command.force;
  const double most = force_limit();
  const double norm = wanted.stableNorm();
  if (norm > most) wanted *= most / norm;
  const double fade_in = std::clamp((now_ - first_time_) / limits_.ramp_time, 0.0, 1.0);
  credit_holding(fade_in * wanted);
  const Vec3 safe = brake(damp(wanted));
  bool limited = norm > most || safe != wanted;
  wanted = safe.norm() > most ? Vec3(safe * (most / safe.norm())) : safe;
  wanted *= fade_in;

  const Vec3 slewed = slew(wanted);
  limited = limited || slewed != wanted;
  sent_.force = slewed;
  last_time_ = now_;
  limited_count_ += limited;
  device_.write(sent_);
}

void SafeDevice::rest(double seconds) noexcept {
  commanded_ = false;
  sent_.force.setZero();
  device_.rest(seconds);
}

std::string describe_fault(DeviceFault fault, double value, const HapticDevice& device) {
  const std::string told = device.explain_fault();
  switch (fault) {
    case DeviceFault::none:
      return {};
    case DeviceFault::sample_not_finite:
      return "the device told a hand with a number that is not finite";
    case DeviceFault::force_not_finite:
      return "the force that was computed is not finite";
    case DeviceFault::sample_out_of_reach:
      return write_text("the device told a hand at ", value, " m, expected within ", kFarthest,
                        " m");
    case DeviceFault::sample_too_fast:
      return write_text("the device told a hand at ", value, " m/s, expected at most ", kFastest,
                        " m/s");
    case DeviceFault::device_failed:
      return told.empty() ? "the device is gone" : told;
    case DeviceFault::motors_cut:
      break;
  }
  return told.empty() ? "the device's motors are off" : told;
}

}  // namespace palpate

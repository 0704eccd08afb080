// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/haptics/safe_device.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace palpate {
namespace {

/// [s] A pause between commands saves up no more slew than this, so that a stall does not end in
/// a blow; two ticks at 1 kHz.
constexpr double kLongestGap = 2e-3;

void require_positive(const char* field, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw std::invalid_argument(std::string("safety limits: ") + field + ": got " +
                                std::to_string(value) + ", expected a positive number");
  }
}

bool is_finite(const HapticSample& sample) noexcept {
  return std::isfinite(sample.time) && sample.position.allFinite() &&
         sample.orientation.coeffs().allFinite() && sample.velocity.allFinite() &&
         std::isfinite(sample.grip);
}

}  // namespace

SafeDevice::SafeDevice(HapticDevice& device, const SafetyLimits& limits)
    : device_(device), limits_(limits) {
  require_positive("force_max [N]", limits.force_max);
  require_positive("slew_max [N/s]", limits.slew_max);
  require_positive("ramp_time [s]", limits.ramp_time);
}

HapticSample SafeDevice::read(double time) noexcept {
  now_ = time;
  if (fault_ == DeviceFault::none) {
    const HapticSample sample = device_.read(time);
    if (is_finite(sample)) {
      last_sample_ = sample;
    } else {
      fault_ = DeviceFault::sample_not_finite;
    }
  }
  if (fault_ != DeviceFault::none) {
    last_sample_.time = time;
    last_sample_.velocity.setZero();
    last_sample_.buttons = 0;
  }
  return last_sample_;
}

/// Norm clamp, then the fade-in, then the slew limit: a step from a force within the norm towards
/// another stays within it, so the last limit cannot undo the first.
void SafeDevice::write(const HapticCommand& command) noexcept {
  if (!command.force.allFinite() && fault_ == DeviceFault::none) {
    fault_ = DeviceFault::force_not_finite;
  }
  if (fault_ != DeviceFault::none) {
    sent_.force.setZero();
    device_.write(sent_);
    return;
  }
  if (!commanded_) {
    first_time_ = last_time_ = now_;
    commanded_ = true;
  }
  bool limited = false;
  Vec3 wanted = command.force;
  const double norm = wanted.stableNorm();  // a huge force must not overflow into a zero
  if (norm > limits_.force_max) {
    wanted *= limits_.force_max / norm;
    limited = true;
  }
  wanted *= std::clamp((now_ - first_time_) / limits_.ramp_time, 0.0, 1.0);

  const Vec3 change = wanted - sent_.force;
  const double most = limits_.slew_max * std::clamp(now_ - last_time_, 0.0, kLongestGap);
  if (change.norm() > most) {
    sent_.force += change * (most / change.norm());
    limited = true;
  } else {
    sent_.force = wanted;
  }
  last_time_ = now_;
  limited_count_ += limited;
  device_.write(sent_);
}

void SafeDevice::rest() noexcept {
  commanded_ = false;
  sent_.force.setZero();
  device_.write(sent_);
}

}  // namespace palpate

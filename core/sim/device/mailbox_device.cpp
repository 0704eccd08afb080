// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/device/mailbox_device.h"

#include <algorithm>

namespace palpate {
namespace {

constexpr double kLongestWay = 3e-3;  // [s] that the hand goes on without a sample
constexpr double kSilent = 20e-3;     // [s] without one: no force until one comes
constexpr double kCut = 1.0;          // [s] without one: the driver hangs, or its device is gone

}  // namespace

void MailboxDevice::tell(const HapticSample& sample) noexcept {
  samples_.back() = sample;
  samples_.publish();
}

HapticCommand MailboxDevice::take_command() noexcept {
  commands_.take();
  return commands_.front();
}

void MailboxDevice::fail(const std::string& reason) {
  const std::lock_guard guard(reasons_);
  if (failed()) return;
  reason_ = reason;
  failed_.store(true, std::memory_order_release);
}

HapticSample MailboxDevice::read(double time) noexcept {
  if (time < now_) heard_at_ = std::min(heard_at_, time);  // a new run
  now_ = time;
  if (samples_.take()) {
    heard_ = true;
    heard_at_ = time;
  }
  const double since = std::max(0.0, time - heard_at_);
  silence_.store(since, std::memory_order_relaxed);
  HapticSample sample = samples_.front();
  sample.time = time;
  sample.position += std::min(since, kLongestWay) * sample.velocity;
  if (since > kLongestWay) sample.velocity.setZero();
  return sample;
}

void MailboxDevice::write(const HapticCommand& command) noexcept {
  commands_.back() = command;
  commands_.publish();
}

/// In a pause nobody asks where the hand is, so a silence there is none of the run's.
void MailboxDevice::rest(double seconds) noexcept {
  (void)seconds;
  if (samples_.take()) {
    heard_ = true;
    heard_at_ = now_;
    silence_.store(0.0, std::memory_order_relaxed);
  }
  write({});
}

MotorState MailboxDevice::motors() const noexcept {
  if (failed()) return MotorState::cut;
  if (!heard_) return MotorState::off;
  const double silence = silence_.load(std::memory_order_relaxed);
  if (silence > kCut) return MotorState::cut;
  return silence > kSilent ? MotorState::silent : MotorState::on;
}

std::string MailboxDevice::explain_fault() const {
  if (failed()) {
    const std::lock_guard guard(reasons_);
    return name_ + ": " + reason_;
  }
  const bool is_cut = silence_.load(std::memory_order_relaxed) > kCut;
  return is_cut ? name_ + ": has told nothing for a second" : std::string();
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <mutex>
#include <string>

#include "palpate/sim/base/lock_free.h"
#include "palpate/sim/device/device.h"

namespace palpate {

/// A hand that another thread tells of as often as it can, and that takes the newest force from
/// here: a driver in Python, or one that has to wait for its library. Neither side waits for the
/// other.
///
/// Outside of real time: what is felt is late by as long as that thread takes, so a stiff tissue
/// may buzz. Between two samples the hand goes on as it went, for 3 ms at most. Where none comes
/// for 20 ms the force is taken back until one does; after a second the motors count as cut.
class MailboxDevice : public HapticDevice {
 public:
  explicit MailboxDevice(const std::string& title) : name_(title) {}

  /// The other thread: where the hand is now. `time` is filled in by read().
  void tell(const HapticSample& sample) noexcept;
  /// The same thread: the newest force.
  HapticCommand take_command() noexcept;
  /// From any thread: the device is gone for good, and why; the first reason counts.
  void fail(const std::string& reason);

  HapticSample read(double time) noexcept override;
  void write(const HapticCommand& command) noexcept override;
  void rest(double seconds) noexcept override;
  std::string name() const override { return name_; }
  bool failed() const noexcept override { return failed_.load(std::memory_order_acquire); }
  MotorState motors() const noexcept override;
  std::string explain_fault() const override;

 private:
  const std::string name_;

  // between the threads
  Latest<HapticSample> samples_;
  Latest<HapticCommand> commands_;
  std::atomic<bool> failed_{false};
  std::atomic<double> silence_{0.0};  ///< [s] since the last sample, in which it was listened to
  mutable std::mutex reasons_;        ///< never taken by the haptic thread
  std::string reason_;

  // the haptic thread's own
  bool heard_ = false;
  double now_ = 0.0, heard_at_ = 0.0;  ///< [s] of the run
};

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace palpate {

/// Bytes to a device and back, real or simulated. Called from the haptic thread: nothing here
/// waits, allocates, locks, logs or throws.
class Transport {
 public:
  virtual ~Transport() = default;

  /// What has come by `time` [s] since the run began, as much as fits; how many bytes that is. A
  /// simulated device lives on up to that time; where `time` goes back, a new run has begun.
  virtual std::size_t read(double time, std::span<std::uint8_t> bytes) noexcept = 0;
  /// Sent whole, or not at all where there is no room.
  virtual void write(double time, std::span<const std::uint8_t> bytes) noexcept = 0;
  /// False for good once the other end is gone.
  virtual bool is_open() const noexcept = 0;
  /// True if wait can: something of the machine's own tells that bytes have come.
  virtual bool can_wait() const noexcept { return false; }
  /// Until bytes have come, or `latest` [ns of the monotonic clock]. False if none have.
  virtual bool wait(std::int64_t latest) noexcept {
    (void)latest;
    return false;
  }
  /// [s] of the clock that arrivals are told by: that of the machine where the device has its own.
  virtual double now(double time) const noexcept { return time; }
  virtual std::string name() const = 0;
};

}  // namespace palpate

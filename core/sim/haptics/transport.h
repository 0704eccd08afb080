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
  /// [s] of the clock that arrivals are told by: that of the machine where the device has its own.
  virtual double now(double time) const noexcept { return time; }
  virtual std::string name() const = 0;
};

}  // namespace palpate

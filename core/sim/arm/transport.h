// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

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

/// A serial port of this machine, as far as the system knows it.
struct SerialPort {
  std::string path;        ///< to open
  std::string product;     ///< what it calls itself; empty where it does not say
  std::string driver;      ///< of the system
  int latency_timer = -1;  ///< [ms] that the adapter may keep bytes back; -1 where it has none
  bool permitted = false;  ///< this user may open it
};

/// The USB serial adapters of this machine, by path.
std::vector<SerialPort> find_serial_ports();

/// A serial port, or the far end of a PtyDevice. Bytes are told by the machine's own clock; the
/// time that read and write are given does not matter.
///
/// What keeps bytes back is switched off as far as the system and the adapter let it.
class SerialTransport : public Transport {
 public:
  /// Throws DeviceError where the port cannot be opened or does not know the rate [bit/s].
  explicit SerialTransport(const std::string& path, int baud = 1000000);
  ~SerialTransport() override;

  std::size_t read(double time, std::span<std::uint8_t> bytes) noexcept override;
  void write(double time, std::span<const std::uint8_t> bytes) noexcept override;
  bool is_open() const noexcept override;
  bool can_wait() const noexcept override { return true; }
  bool wait(std::int64_t latest) noexcept override;
  double now(double time) const noexcept override;
  std::string name() const override;
  /// What was done about latency, and what could not be, in words.
  std::string latency_note() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace palpate

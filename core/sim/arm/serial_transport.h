// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "palpate/sim/arm/native_core.h"
#include "palpate/sim/arm/transport.h"

namespace palpate {

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

/// A simulated device behind a pseudo terminal: a file that any program can open as if it were the
/// serial port of the real one. It lives in real time in a thread of its own.
class PtyDevice {
 public:
  /// A hand holds its stylus in the middle of the workspace. Throws DeviceError where the system
  /// gives no pseudo terminal.
  explicit PtyDevice(const Plant& plant = {}, const NativeCoreOptions& options = {});
  ~PtyDevice();  ///< unplugs it

  std::string path() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace palpate

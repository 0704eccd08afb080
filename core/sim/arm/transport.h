// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "palpate/sim/device/device.h"

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

// --- what goes wrong on the way, on purpose ------------------------------------------------------

/// What goes wrong, and how often: shares of frames or samples, 0 to 1. The same in every run.
struct Faults {
  double drop = 0.0;     ///< lost
  double corrupt = 0.0;  ///< changed: a bit of a frame, a number of a sample
  double reorder = 0.0;  ///< comes after the one that follows it
  double delay = 0.0;    ///< [s] each way
  double stick_at = std::numeric_limits<double>::infinity();   ///< [s] from then on the same again
  double unplug_at = std::numeric_limits<double>::infinity();  ///< [s] from then on nothing
  /// [s] from then on a device moves but its motors are off; a transport knows of none.
  double cut_at = std::numeric_limits<double>::infinity();
  std::uint64_t seed = 1;
};

/// Throws std::invalid_argument naming the field, what it got and what was expected.
void validate(const Faults& faults);

/// A device to which faults happen: samples are lost (the last one stays), late, swapped, not
/// finite, stuck, or the device is gone; commands are lost or late.
class FaultyDevice : public HapticDevice {
 public:
  /// `device` must outlive this. Throws std::invalid_argument.
  FaultyDevice(HapticDevice& device, const Faults& faults);

  HapticSample read(double time) noexcept override;
  void write(const HapticCommand& command) noexcept override;
  void end() noexcept override { device_.end(); }
  void rest(double seconds) noexcept override;
  std::string name() const override { return "faulty " + device_.name(); }
  DeviceDynamics dynamics() const noexcept override { return device_.dynamics(); }
  bool failed() const noexcept override { return is_unplugged() || device_.failed(); }
  MotorState motors() const noexcept override {
    return is_unplugged() || is_cut() ? MotorState::cut : device_.motors();
  }
  std::string explain_fault() const override;

 private:
  bool is_unplugged() const noexcept { return time_now() >= faults_.unplug_at; }
  bool is_cut() const noexcept { return time_now() >= faults_.cut_at; }
  double time_now() const noexcept { return now_.load(std::memory_order_relaxed); }

  struct Late {
    double time = 0.0;
    HapticSample sample;
    HapticCommand command;
  };
  HapticDevice& device_;
  const Faults faults_;
  std::uint64_t random_;
  std::atomic<double> now_{0.0};
  HapticSample last_, held_;
  bool holding_ = false;
  std::vector<Late> samples_, commands_;  ///< rings of what is in transit
  std::size_t next_sample_ = 0, next_command_ = 0;
};

/// A transport on which faults happen to whole frames, both ways.
class FaultyTransport : public Transport {
 public:
  /// `transport` must outlive this. Throws std::invalid_argument.
  FaultyTransport(Transport& transport, const Faults& faults);

  std::size_t read(double time, std::span<std::uint8_t> bytes) noexcept override;
  void write(double time, std::span<const std::uint8_t> bytes) noexcept override;
  bool is_open() const noexcept override;
  double now(double time) const noexcept override { return transport_.now(time); }
  std::string name() const override { return "faulty " + transport_.name(); }

 private:
  static constexpr std::size_t kLongest = 64;
  struct Parcel {
    double due = 0.0;
    std::size_t count = 0;
    std::array<std::uint8_t, kLongest> bytes{};
  };
  /// Frames on their way in one direction; full, it loses the newest.
  struct Channel {
    std::vector<Parcel> ring;
    std::size_t first = 0, count = 0;
    Parcel held;  ///< waits for the one that shall overtake it
    bool holding = false;
  };
  void pass(double time, Parcel parcel, Channel& channel) noexcept;
  void push(const Parcel& parcel, Channel& channel) const noexcept;
  void pump(double time) noexcept;

  Transport& transport_;
  const Faults faults_;
  std::uint64_t random_;
  double now_ = 0.0;
  Parcel coming_, last_;
  Channel up_, down_;
  std::size_t taken_ = 0;  ///< bytes of the first parcel upwards already handed over
};

}  // namespace palpate

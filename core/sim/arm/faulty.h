// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <vector>

#include "palpate/sim/arm/transport.h"
#include "palpate/sim/device/device.h"

namespace palpate {

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

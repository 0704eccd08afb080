// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "palpate/sim/arm/plant.h"
#include "palpate/sim/arm/transport.h"
#include "palpate/simavr/sim_avr.h"

namespace palpate {

struct EmulatedCoreOptions {
  int baud = 1'000'000;     ///< of the image
  double link_delay = 0.0;  ///< [s] of what joins wire and host, each way
};

/// What NativeCore is with the firmware compiled for this machine, with the chip's own image: the
/// emulated processor and a simulated arm in lock-step, in virtual time. Its sensors' voltages are
/// the arm's angles, its PWM and direction pins move the arm. Slower than real time, and it
/// allocates: for tests and pictures, not for a person's hand.
class EmulatedCore : public Transport {
 public:
  /// `image` is an ELF file for that baud rate. Throws FileError and std::invalid_argument.
  EmulatedCore(const std::string& image, const Plant& plant = {},
               const EmulatedCoreOptions& options = {});
  ~EmulatedCore() override;

  std::size_t read(double time, std::span<std::uint8_t> bytes) noexcept override;
  void write(double time, std::span<const std::uint8_t> bytes) noexcept override;
  bool is_open() const noexcept override;
  std::string name() const override { return "emulated core"; }

  /// Lives on up to `time` [s] although nobody reads; what it says is then lost.
  void advance(double time) noexcept;
  /// Whether and where to a hand moves the stylus.
  void hold(const HandTarget& hand) noexcept;
  void pull_cable() noexcept;  ///< from then on nothing goes either way

  const Plant& plant() const noexcept;
  /// The arm as it really is.
  const PlantState& state() const noexcept;
  PlantState& state() noexcept;
  /// What the motors get.
  const Drive& drive() const noexcept;
  /// [N] of the motors at the tip, without the arm's own weight.
  Vec3 motor_force() const noexcept;
  SimAvr& chip() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace palpate

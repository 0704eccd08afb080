// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "palpate/sim/arm/calibration.h"
#include "palpate/sim/arm/plant.h"
#include "palpate/sim/arm/transport.h"

namespace palpate {

/// How the simulated wire and the clocks at its ends are.
struct NativeCoreOptions {
  double baud = 1e6;             ///< [bit/s]
  double link_delay = 0.0;       ///< [s] of what joins wire and host, each way
  double report_delay = 0.5e-3;  ///< [s] from a tick's samples to the first byte of its report
  double drift = 0.0;            ///< by how much the device's clock is fast, 1e-6 for 1 ppm
  bool calibrated = true;        ///< its EEPROM holds what find_calibration says of the plant
  bool damaged = false;          ///< a byte of that has changed since it was stored
};

/// The firmware's own C code, compiled for this machine, on a simulated arm at the far end of a
/// simulated wire: bytes go in and come out as they would of the real device. The same in every
/// run; no clock but the time it is given.
class NativeCore : public Transport {
 public:
  /// Throws std::invalid_argument.
  explicit NativeCore(const Plant& plant = {}, const NativeCoreOptions& options = {});
  ~NativeCore() override;

  std::size_t read(double time, std::span<std::uint8_t> bytes) noexcept override;
  void write(double time, std::span<const std::uint8_t> bytes) noexcept override;
  bool is_open() const noexcept override;
  std::string name() const override { return "native core"; }

  /// Lives on up to `time` [s] although nobody reads; what it says is then lost.
  void advance(double time) noexcept;
  double time() const noexcept;  ///< [s] of the run, up to which it has lived
  /// Whether and where to a hand moves the stylus.
  void hold(const HandTarget& hand) noexcept;
  void press_buttons(std::uint8_t buttons) noexcept;
  void press_stop(bool pressed) noexcept;         ///< the emergency stop
  void cut_sensor(int joint, bool cut) noexcept;  ///< its wire is off: the reading is at the rail
  void pull_cable() noexcept;                     ///< from then on nothing goes either way
  void reset() noexcept;                          ///< as if its power had failed for a moment

  const Plant& plant() const noexcept;
  /// The arm as it really is.
  const PlantState& state() const noexcept;
  PlantState& state() noexcept;
  /// What the motors get.
  const Drive& drive() const noexcept;
  /// [N] of the motors at the tip, without the arm's own weight.
  Vec3 motor_force() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace palpate

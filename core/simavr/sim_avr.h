// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace palpate {

/// What the processor did since the last start_profile.
struct SimAvrProfile {
  double mean_load = 0.0;               ///< part of the cycles that were not slept
  double worst_load = 0.0;              ///< the same in the worst millisecond, wherever it begins
  std::uint64_t tick_period_min = 0;    ///< [cycles] between two tick interrupts; 16000 is right
  std::uint64_t tick_period_max = 0;    ///< [cycles]
  std::uint64_t receive_delay_max = 0;  ///< [cycles] from a byte's end to its interrupt
  double state_delay_mean = 0.0;        ///< [s] from a tick to the last byte of its frame
  double state_delay_max = 0.0;         ///< [s]
  long ticks = 0;
  long bytes_overrun = 0;  ///< bytes the UART of the real chip would have lost
};

/// The image of the firmware, instruction by instruction, on an emulated ATmega328P in virtual time
/// (libsimavr): the real program on pins that exist in memory. Nothing here looks at a clock, so
/// the same calls give the same cycles on every machine.
class SimAvr {
 public:
  static constexpr std::uint64_t kFrequency = 16'000'000;  ///< [Hz]
  static constexpr std::uint64_t kTick = 16'000;           ///< [cycles] of a millisecond
  static constexpr int kEepromBytes = 1024;

  /// Powers the board up with `image`, an ELF file built for `baud`, and the given EEPROM, blank if
  /// empty. Sensors stand at half scale, the stop line is closed. Throws FileError for an image
  /// that cannot be read and std::invalid_argument for another number of EEPROM bytes.
  SimAvr(const std::string& image, int baud, std::span<const std::uint8_t> eeprom = {});
  ~SimAvr();
  SimAvr(SimAvr&&) noexcept;
  SimAvr& operator=(SimAvr&&) noexcept;

  /// Lets the processor run for so many cycles. Throws DeviceError if it stops for good.
  void run(std::uint64_t cycles);
  std::uint64_t cycle() const;  ///< since power-up

  /// The sensor of joint 0..5, as the counts [0, 1023] its voltage gives.
  void set_position(int joint, int counts);
  void set_stop_open(bool open);
  void set_driver_fault(bool fault);
  /// Clears ADEN, as an error in the program or in the chip would: no sample comes any more.
  void stop_converter();
  /// Bits 0 and 1.
  void set_buttons(int buttons);

  /// What motor 0..2 gets: the duty in its PWM register, -255..255 with its direction pin, and 0
  /// while the drivers are not enabled.
  int duty(int motor) const;
  bool enabled() const;

  /// Bytes that now enter the wire to the device, one after the other at the baud rate.
  void receive(std::span<const std::uint8_t> bytes);
  /// Bytes that have wholly left the device since the last call.
  std::vector<std::uint8_t> take();
  /// When the last byte given to receive will have arrived [cycles].
  std::uint64_t receive_end() const;

  std::array<std::uint8_t, kEepromBytes> eeprom() const;
  /// Puts an endless loop under the main loop's feet, as an error in it would.
  void hang_main_loop();
  /// Takes the endless loop out again, for the program after the reset.
  void restore_main_loop();

  void start_profile();
  SimAvrProfile profile() const;
  /// The most bytes the stack ever took since power-up, and what is there for it.
  int stack_used() const;
  int stack_free() const;

  struct Chip;  ///< the emulator, out of sight

 private:
  std::unique_ptr<Chip> chip_;
};

}  // namespace palpate

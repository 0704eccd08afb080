// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <string>

#include "../../firmware/host_of_device.h"
#include "palpate/simavr/sim_avr.h"

namespace palpate {

inline std::string image(int baud) {
  return std::string(PALPATE_IMAGES) + std::to_string(baud) + ".elf";
}

/// The command with a local law of plausible numbers.
inline palpate_command with_law(palpate_command command) {
  command.has_law = true;
  command.shift = 4;
  for (int m = 0; m < PALPATE_MOTORS; ++m) command.rest[m] = 8000;
  for (int k = 0; k < 6; ++k) command.stiffness[k] = static_cast<std::int16_t>(1000 - 300 * k);
  return command;
}

/// The image in the emulator with a host at its other end; a command each millisecond.
class SimBench {
 public:
  explicit SimBench(int rate = 1000000, bool calibrated = true)
      : baud(rate),
        chip(image(rate), rate, calibrated ? calibrated_eeprom() : std::vector<std::uint8_t>()) {}

  void say(const Bytes& wire) { chip.receive(wire); }
  void wait(double ms = 1.0) {
    chip.run(static_cast<std::uint64_t>(ms * SimAvr::kTick));
    host.hear(chip.take());
  }
  /// A command `phase` into each millisecond.
  void drive(int ms, int a, int b, int c, double phase = 0.35) {
    for (int i = 0; i < ms; ++i) {
      wait(phase);
      say(host.command(a, b, c));
      wait(1.0 - phase);
    }
  }
  int ask(const Bytes& wire) {
    say(wire);
    wait(3);
    if (host.answers.empty()) return -1;
    const palpate_answer answer = host.answers.back();
    host.answers.clear();
    return answer.result;
  }
  void power_up() {
    wait(5);
    say(host.hello());
    wait(3);
    ask(host.clear());
    drive(3, 0, 0, 0);
    say(host.enable());
    drive(PALPATE_RAMP_MS + 10, 0, 0, 0);
  }
  bool is_limp() const {
    return !chip.enabled() && chip.duty(0) == 0 && chip.duty(1) == 0 && chip.duty(2) == 0;
  }
  /// [ms] from now until the motors are off, or `most`.
  double time_until_limp(double most) {
    const std::uint64_t begin = chip.cycle();
    while (!is_limp() && elapsed(begin) < most) chip.run(80);
    return elapsed(begin);
  }
  /// [ms] since a cycle; negative before it.
  double elapsed(std::uint64_t since) const {
    return (static_cast<double>(chip.cycle()) - static_cast<double>(since)) / SimAvr::kTick;
  }

  /// [cycles] that a byte takes on the wire; the chip holds two that were not fetched.
  std::uint64_t byte_cycles() const {
    return 10 * SimAvr::kFrequency / static_cast<unsigned>(baud);
  }

  int baud;
  SimAvr chip;
  HostOfDevice host;
};

}  // namespace palpate

// SPDX-License-Identifier: GPL-3.0-or-later
// The emulated processor and what is wired to it.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

extern "C" {
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
}

#include "palpate/simavr/load_meter.h"
#include "palpate/simavr/sim_avr.h"

namespace palpate {

struct SimAvr::Chip {
  Chip(const std::string& image, int baud, std::span<const std::uint8_t> eeprom);
  ~Chip();
  Chip(const Chip&) = delete;
  Chip& operator=(const Chip&) = delete;

  void run(std::uint64_t cycles);
  void set_pin(char port, int pin, bool high);
  void set_position(int joint, int counts);
  void wire_pins();
  void feed(std::uint8_t byte);
  void watch_interrupts();

  avr_t* avr = nullptr;
  avr_uart_t* uart = nullptr;
  std::uint64_t byte_cycles = 160;
  int stack_bottom = 0;  ///< address above the program's own data

  std::deque<std::pair<std::uint64_t, std::uint8_t>> coming;   ///< (start, byte)
  std::deque<std::pair<std::uint64_t, std::uint8_t>> leaving;  ///< (end, byte)
  std::uint64_t wire_free = 0;                                 ///< end of the last byte given
  std::deque<std::uint64_t> due;  ///< ends of bytes whose interrupt has not come

  std::uint8_t pins_d = 0x40, pins_b = 0x18;  ///< stop closed, no fault, no button
  std::uint64_t slept = 0;                    ///< [cycles] in the call of the emulator that runs
  std::array<int, 6> counts{512, 512, 512, 512, 512, 512};
  bool was_reset = false;  ///< which forgets what the pins were
  LoadMeter meter;
  std::uint32_t patched_at = 0;
  std::uint8_t patched[2] = {0, 0};
};

}  // namespace palpate

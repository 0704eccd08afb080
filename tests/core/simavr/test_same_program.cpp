// SPDX-License-Identifier: GPL-3.0-or-later
// The chip's image and the app compiled for the host are one program: told the same they do the
// same.
#include <doctest/doctest.h>

#include <random>

#include "../../firmware/bench.h"
#include "sim_bench.h"

using namespace palpate;

TEST_CASE("the image and the host's build give the same duty for the same command and position") {
  SimBench chip;
  Bench host;
  chip.power_up();
  host.power_up();
  std::mt19937 random(5);
  for (int i = 0; i < 60; ++i) {
    palpate_command command{};
    command.has_law = i % 2;
    command.shift = static_cast<std::uint8_t>(random() % 9);
    for (int m = 0; m < PALPATE_MOTORS; ++m) {
      command.torque[m] = static_cast<std::int16_t>(random());
      command.rest[m] = static_cast<std::uint16_t>(random() % 16368);
      const int step = static_cast<int>(random() % 60) - 30;
      const int position = std::clamp(host.board.adc[m] + step, 20, 1000);
      host.board.adc[m] = static_cast<std::uint16_t>(position);
      chip.chip.set_position(m, position);
    }
    for (int k = 0; k < 6; ++k) command.stiffness[k] = static_cast<std::int16_t>(random());
    for (int ms = 0; ms < 12; ++ms) {
      host.say(host.host.command(command));
      host.wait();
      chip.wait(0.35);
      chip.say(chip.host.command(command));
      chip.wait(0.65);
    }
    CAPTURE(i);
    for (int m = 0; m < PALPATE_MOTORS; ++m) {
      CHECK(chip.chip.duty(m) == host.board.duty[m]);
      CHECK(chip.host.state.position[m] == host.board.adc[m]);
    }
  }
  CHECK(chip.host.state.mode == PALPATE_RUN);
  CHECK(host.host.state.mode == PALPATE_RUN);
}

TEST_CASE("positions in STATE are the counts of the voltages, all six, and buttons its two bits") {
  SimBench bench;
  bench.wait(5);
  bench.say(bench.host.hello());
  for (int counts : {8, 100, 511, 777, 1015}) {
    for (int j = 0; j < PALPATE_JOINTS; ++j) {
      bench.chip.set_position(j, std::min(counts + j, 1015));
    }
    bench.chip.set_buttons(counts % 4);
    bench.wait(4);

    for (int j = 0; j < PALPATE_JOINTS; ++j) {
      CHECK(bench.host.state.position[j] == std::min(counts + j, 1015));
    }
    CHECK(bench.host.state.buttons == counts % 4);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "bench.h"

using namespace palpate;

namespace {

void check_latched(Bench& bench, palpate_fault fault) {
  CHECK(bench.is_limp());
  bench.wait();
  CHECK(bench.host.state.mode == PALPATE_FAULTED);
  CHECK(bench.host.state.first_fault == fault);
  bench.drive(10, kFull, kFull, kFull);
  CHECK(bench.ask(bench.host.enable()) == PALPATE_WRONG_MODE);
  CHECK(bench.is_limp());
}

}  // namespace

TEST_CASE("a silent host: torque held 5 ms, at zero at 20 ms, then a latched fault") {
  Bench bench;
  bench.power_up();
  bench.drive(20, kFull, kFull, 0);

  bench.wait(4);  // the command is 5 ms old
  CHECK(bench.board.duty[0] == PALPATE_DUTY_MAX);
  bench.wait(8);
  CHECK(bench.board.duty[0] == 255 * 7 / 15);
  bench.wait(7);
  CHECK(bench.board.duty[0] == 0);
  CHECK(bench.board.device.mode == PALPATE_RUN);
  bench.wait(1);

  check_latched(bench, PALPATE_FAULT_HOST_SILENT);
}

TEST_CASE("an open stop line cuts the motors within its millisecond, and CLEAR waits for it") {
  Bench bench;
  bench.power_up();
  bench.drive(20, kFull, 0, 0);
  bench.board.stop_open = true;
  bench.wait();

  check_latched(bench, PALPATE_FAULT_STOP_PRESSED);
  CHECK(bench.ask(bench.host.clear()) == PALPATE_CAUSE_REMAINS);
  bench.board.stop_open = false;
  bench.wait();
  CHECK(bench.ask(bench.host.clear()) == PALPATE_DONE);
  CHECK(bench.host.state.mode == PALPATE_IDLE);
  CHECK(bench.is_limp());  // CLEAR alone never energises
}

TEST_CASE("a driver's fault cuts the motors within its millisecond") {
  Bench bench;
  bench.power_up();
  bench.drive(20, kFull, 0, 0);
  bench.board.driver_fault = true;
  bench.wait();

  check_latched(bench, PALPATE_FAULT_DRIVER);
}

TEST_CASE("a sensor at either rail cuts the motors within its millisecond") {
  for (int joint = 0; joint < PALPATE_JOINTS; ++joint) {
    for (int counts : {0, 7, 1016, 1023}) {
      Bench bench;
      bench.power_up();
      bench.drive(20, kFull, 0, 0);
      bench.board.adc[joint] = static_cast<std::uint16_t>(counts);
      bench.wait();

      check_latched(bench, PALPATE_FAULT_SENSOR);
      CHECK(bench.ask(bench.host.clear()) == PALPATE_CAUSE_REMAINS);
    }
  }
}

TEST_CASE("an arm joint faster than its limit for 4 ms is cut, a limp or shorter one is not") {
  const auto jerk = [](Bench& bench, int ms) {
    for (int i = 0; i < ms; ++i) {
      bench.board.adc[1] = static_cast<std::uint16_t>(bench.board.adc[1] + 41);
      bench.drive(1, 1000, 0, 0);
    }
  };
  Bench limp;
  limp.say(limp.host.hello());
  jerk(limp, 8);
  CHECK(limp.host.state.mode == PALPATE_IDLE);

  Bench bench;
  bench.power_up();
  jerk(bench, 3);
  bench.drive(2, 1000, 0, 0);
  CHECK(bench.host.state.mode == PALPATE_RUN);
  jerk(bench, 4);

  check_latched(bench, PALPATE_FAULT_OVER_SPEED);
}

TEST_CASE("the first of several faults keeps its name, all of them are told") {
  Bench bench;
  bench.power_up();
  bench.board.driver_fault = true;
  bench.wait(2);
  bench.board.stop_open = true;
  bench.wait(2);

  CHECK(bench.host.state.first_fault == PALPATE_FAULT_DRIVER);
  CHECK(bench.host.state.faults == (1 << PALPATE_FAULT_DRIVER | 1 << PALPATE_FAULT_STOP_PRESSED));
}

TEST_CASE("a watchdog reset is told until CLEAR") {
  Bench bench;
  bench.power_up();
  palpate_board_reset(&bench.board, PALPATE_RESET_WATCHDOG);
  CHECK(bench.is_limp());
  bench.say(bench.host.hello());
  bench.wait();

  CHECK(bench.host.state.first_fault == PALPATE_FAULT_WATCHDOG);
  CHECK(bench.host.info.reset_cause == PALPATE_RESET_WATCHDOG);
  CHECK(bench.ask(bench.host.clear()) == PALPATE_DONE);
}

TEST_CASE("three late ticks within a hundred cut the motors, two are only told") {
  Bench bench;
  bench.power_up();
  for (int late = 0; late < 2; ++late) {
    palpate_guard(&bench.board.device, 0);  // a tick whose work the next one finds undone
    bench.drive(110, 0, 0, 0);
  }
  CHECK(bench.host.state.mode == PALPATE_RUN);
  CHECK((bench.host.state.faults & 1 << PALPATE_FAULT_OVERRUN) != 0);
  for (int late = 0; late < 3; ++late) {
    palpate_guard(&bench.board.device, 0);
    bench.drive(10, 0, 0, 0);
  }

  check_latched(bench, PALPATE_FAULT_OVERRUN);
}

TEST_CASE("a blank EEPROM: positions stream, torque is refused") {
  Bench bench(false);
  bench.say(bench.host.hello());
  bench.wait();

  CHECK(bench.host.state.first_fault == PALPATE_FAULT_CALIBRATION);
  CHECK((bench.host.info.features & PALPATE_FEATURE_BLANK) != 0);
  CHECK(bench.host.state.position[0] == 512);
  CHECK(bench.host.info.calibration_crc == 0);
  CHECK(bench.ask(bench.host.clear()) == PALPATE_CAUSE_REMAINS);
  bench.drive(3, 0, 0, 0);
  CHECK(bench.ask(bench.host.enable()) == PALPATE_WRONG_MODE);
}

TEST_CASE("a blank board never says that its motors are hot") {
  Bench bench(false);
  bench.say(bench.host.hello());
  bench.drive(PALPATE_HOT_MS + 100, 0, 0, 0);

  CHECK(bench.host.state.faults == 1 << PALPATE_FAULT_CALIBRATION);
}

TEST_CASE("a converter that stops: the guard cuts within 4 ms, the watchdog resets within 16") {
  Bench bench;
  bench.power_up();
  bench.drive(20, kFull, 0, 0);
  bench.board.adc_stopped = true;
  int ms = 0;
  while (!bench.is_limp() && ms < 100) {
    bench.drive(1, kFull, 0, 0);
    ++ms;
  }
  CHECK(ms <= 4);
  CHECK(bench.board.device.first_fault == PALPATE_FAULT_OVERRUN);

  bench.drive(16, kFull, 0, 0);
  CHECK(bench.board.device.first_fault == PALPATE_FAULT_WATCHDOG);
  CHECK(bench.is_limp());
}

TEST_CASE("a frame that is repeated is no host: its torque ends as that of a silent one") {
  for (int frames : {1, 3}) {
    Bench bench;
    bench.power_up();
    std::vector<Bytes> said;
    for (int i = 0; i < frames; ++i) said.push_back(bench.host.command(kFull, 0, 0));
    for (int ms = 0; ms < 30; ++ms) {
      bench.say(said[static_cast<std::size_t>(ms % frames)]);
      bench.wait();
    }

    CHECK(bench.is_limp());
    CHECK(bench.host.state.first_fault == PALPATE_FAULT_HOST_SILENT);
  }
}

TEST_CASE("one zero command that is repeated is not the three that ENABLE wants") {
  Bench bench;
  bench.say(bench.host.hello());
  bench.wait();
  const Bytes zero = bench.host.command(0, 0, 0);
  for (int i = 0; i < 5; ++i) {
    bench.say(zero);
    bench.wait();
  }

  CHECK(bench.ask(bench.host.enable()) == PALPATE_NOT_AT_ZERO);
}

TEST_CASE("a joint that leaps 200 counts to and fro every second tick is cut within 14 ms") {
  Bench bench;
  bench.power_up();
  int ms = 0;
  for (; bench.host.state.mode == PALPATE_RUN && ms < 100; ++ms) {
    if (ms % 2) bench.board.adc[2] = bench.board.adc[2] == 400 ? 600 : 400;
    bench.drive(1, 1000, 0, 0);
  }
  CHECK(ms <= 15);

  check_latched(bench, PALPATE_FAULT_OVER_SPEED);
}

TEST_CASE("single leaps, as a bad sample now and then is one, are borne") {
  Bench bench;
  bench.power_up();
  for (int ms = 0; ms < 2000; ++ms) {
    bench.board.adc[1] = ms % 6 == 0 ? 700 : 500;  // there and back: two fast ticks, four calm
    bench.drive(1, 1000, 0, 0);
  }
  CHECK(bench.host.state.mode == PALPATE_RUN);
}

// Joint 1 under torque flickers as a live one would not, while others go to and fro by 100 counts.
// Returns how far one of them went [counts] until the device noticed, or 20000.
static int find_travel_beside_a_stuck_joint(Bench& bench, bool both) {
  bench.power_up();
  int travel = 0;
  for (; bench.host.state.mode == PALPATE_RUN && travel < 20000; travel += 5) {
    const int at = travel % 200;
    const auto counts = static_cast<std::uint16_t>(500 + (at < 100 ? at : 200 - at));
    bench.board.adc[0] = counts;
    if (both) bench.board.adc[2] = counts;
    bench.board.adc[1] = static_cast<std::uint16_t>(512 + travel % 2);
    bench.drive(1, 0, 20000, 0);
  }
  return travel;
}

TEST_CASE("a sensor stuck in its middle is found once both others went 512 counts, or one 8192") {
  Bench bench;
  const int both = find_travel_beside_a_stuck_joint(bench, true);
  CHECK(both > 500);
  CHECK(both < 650);
  check_latched(bench, PALPATE_FAULT_SENSOR);

  Bench other;
  const int one = find_travel_beside_a_stuck_joint(other, false);
  CHECK(one > 8150);
  CHECK(one < 9000);
  check_latched(other, PALPATE_FAULT_SENSOR);
}

TEST_CASE("a joint that stands still without torque, or with all others still, is not stuck") {
  Bench plane;  // strokes to and fro in a plane: no torque out of it
  plane.power_up();
  for (int ms = 0; ms < 20000; ++ms) {
    for (int j : {1, 2}) {
      plane.board.adc[j] = static_cast<std::uint16_t>(512 + 100 * std::sin(0.006 * ms + j));
    }
    plane.drive(1, 7000, -12000, 12000);
  }
  CHECK(plane.host.state.mode == PALPATE_RUN);

  Bench still;  // presses and holds, with a converter that flickers by two counts
  still.power_up();
  std::mt19937 random(6);
  for (int ms = 0; ms < 20000; ++ms) {
    for (int j : {0, 1}) still.board.adc[j] = static_cast<std::uint16_t>(511 + random() % 3);
    still.drive(1, 16000, 16000, 16000);
  }
  CHECK(still.host.state.mode == PALPATE_RUN);
}

TEST_CASE(
    "a host that floods the wire is heard three times a millisecond, and loses nothing else") {
  Bench bench;
  bench.power_up();
  for (int ms = 0; ms < 100; ++ms) {
    Bytes flood;
    for (int i = 0; i < 7; ++i) {
      const Bytes wire = bench.host.command(20000, 0, 0);
      flood.insert(flood.end(), wire.begin(), wire.end());
    }
    bench.say(Bytes(flood.begin(), flood.begin() + 80));
    bench.wait();
    bench.say(Bytes(flood.begin() + 80, flood.end()));
  }

  CHECK(bench.host.state.mode == PALPATE_RUN);
  CHECK(bench.board.duty[0] == 156);
  CHECK((bench.host.state.faults & 1 << PALPATE_NOTICE_BYTES_LOST) != 0);
}

TEST_CASE("a million random bytes never energise a motor") {
  Bench bench;
  bench.say(bench.host.hello());
  std::mt19937 random(4);
  bool energised = false;
  for (int i = 0; i < 25000; ++i) {
    Bytes noise(40);
    for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(random() % 4 ? random() : 0);
    bench.say(noise);
    bench.wait();
    energised |= !bench.is_limp();
  }

  CHECK_FALSE(energised);
  CHECK(bench.board.device.damaged > 0);
}

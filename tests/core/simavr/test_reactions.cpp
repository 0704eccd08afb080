// SPDX-License-Identifier: GPL-3.0-or-later
// Row 4 of the verification plan: every fault's reaction inside its bound, at both baud rates.
#include <doctest/doctest.h>

#include <cstdio>
#include <random>

#include "sim_bench.h"

using namespace palpate;

namespace {

constexpr int kBauds[] = {1000000, 500000};
constexpr int kStrong = 20000;

struct Driven : SimBench {
  explicit Driven(int rate) : SimBench(rate) {
    power_up();
    drive(20, kStrong, -kStrong, kStrong);
    REQUIRE(chip.duty(0) == 156);
    REQUIRE(chip.duty(1) == -156);
  }

  void check_latched(palpate_fault fault) {
    CHECK(is_limp());
    wait(3);
    CHECK(host.state.mode == PALPATE_FAULTED);
    CHECK(host.state.first_fault == fault);
    drive(5, kStrong, kStrong, kStrong);
    host.answers.clear();
    CHECK(ask(host.enable()) == PALPATE_WRONG_MODE);
    CHECK(is_limp());
  }
};

void print(const char* what, int baud, double ms) {
  std::printf("%s at %d baud: motors off after %.2f ms\n", what, baud, ms);
}

// What a tick has heard is counted in the main loop and forgotten by the tick's interrupt. A host
// whose clock is slow by 62 ppm ends its commands at every `step` cycles of the millisecond in
// turn.
void check_phases(int baud, bool law, int step) {
  Driven bench(baud);
  bench.chip.start_profile();
  palpate_command command{};
  command.torque[0] = command.torque[2] = kStrong / 2;  // so that no motor grows hot
  command.torque[1] = -kStrong / 2;
  if (law) command = with_law(command);
  int lost = 0;
  for (int phase = 0; phase < 16000; phase += step) {
    bench.say(bench.host.command(command));
    bench.chip.run(SimAvr::kTick + step);
    bench.host.hear(bench.chip.take());
    const int behind = static_cast<std::uint8_t>(bench.host.seq() - bench.host.state.ack);
    lost += phase > 10 * step && behind > 2;
  }

  const SimAvrProfile profile = bench.chip.profile();
  std::printf("every %d cycles at %d baud%s: a byte waits %llu cycles at most\n", step, baud,
              law ? " with the law" : "",
              static_cast<unsigned long long>(profile.receive_delay_max));
  CHECK(lost == 0);
  CHECK(bench.host.state.faults == 0);
  CHECK(bench.host.state.mode == PALPATE_RUN);
  CHECK(profile.bytes_overrun == 0);
  CHECK(profile.receive_delay_max < 2 * bench.byte_cycles());
}

}  // namespace

TEST_CASE("the image of the chip: a silent host loses its torque between 5 and 21 ms") {
  for (int baud : kBauds) {
    Driven bench(baud);
    bench.say(bench.host.command(kStrong, kStrong, kStrong));
    const std::uint64_t last = bench.chip.receive_end();

    while (bench.elapsed(last) < 4.9) bench.wait(0.1);
    CHECK(bench.chip.duty(0) == 156);
    while (bench.elapsed(last) < 13.0) bench.wait(0.1);
    CHECK(bench.chip.duty(0) < 100);
    CHECK(bench.chip.duty(0) > 40);
    bench.time_until_limp(30.0);
    const double off = bench.elapsed(last);

    print("silent host", baud, off);
    CHECK(off > 19.0);
    CHECK(off < 21.1);
    bench.check_latched(PALPATE_FAULT_HOST_SILENT);
  }
}

TEST_CASE("the image of the chip: stop line and driver fault cut within 1.1 ms") {
  for (int baud : kBauds) {
    for (bool stop : {true, false}) {
      Driven bench(baud);
      bench.wait(0.2);
      if (stop) {
        bench.chip.set_stop_open(true);
      } else {
        bench.chip.set_driver_fault(true);
      }

      const double off = bench.time_until_limp(5.0);

      print(stop ? "stop line" : "driver fault", baud, off);
      CHECK(off < 1.1);
      bench.check_latched(stop ? PALPATE_FAULT_STOP_PRESSED : PALPATE_FAULT_DRIVER);
      CHECK(bench.ask(bench.host.clear()) == PALPATE_CAUSE_REMAINS);
    }
  }
}

TEST_CASE("the image of the chip: a sensor at its rail cuts with the samples of the next tick") {
  for (int baud : kBauds) {
    for (int joint : {0, 5}) {
      Driven bench(baud);
      bench.wait(0.5);
      bench.chip.set_position(joint, joint ? 1023 : 0);

      const double off = bench.time_until_limp(5.0);

      print("sensor at its rail", baud, off);
      CHECK(off < 1.6);
      bench.check_latched(PALPATE_FAULT_SENSOR);
    }
  }
}

TEST_CASE("the image of the chip: an arm joint too fast for four ticks is cut in the fifth") {
  for (int baud : kBauds) {
    Driven bench(baud);
    const std::uint64_t begin = bench.chip.cycle();
    int position = 512;
    while (!bench.is_limp() && bench.elapsed(begin) < 10.0) {
      bench.chip.set_position(1, position += 45);
      bench.drive(1, kStrong, -kStrong, kStrong);
    }

    print("over-speed", baud, bench.elapsed(begin));
    CHECK(bench.elapsed(begin) >= 4.0);
    CHECK(bench.elapsed(begin) <= 6.0);
    bench.check_latched(PALPATE_FAULT_OVER_SPEED);
  }
}

TEST_CASE("the image of the chip: a hung main loop ends in the watchdog's reset, and is told") {
  for (int baud : kBauds) {
    Driven bench(baud);
    bench.chip.hang_main_loop();

    const double off = bench.time_until_limp(60.0);
    print("hung main loop", baud, off);
    CHECK(off < 5.0);  // by the guard, which does not wait for the watchdog
    bench.wait(18.0 - off);
    bench.chip.restore_main_loop();
    bench.wait(60);
    bench.host.info = {};
    bench.say(bench.host.hello());
    bench.wait(5);
    CHECK((bench.host.info.reset_cause & PALPATE_RESET_WATCHDOG) != 0);
    bench.check_latched(PALPATE_FAULT_WATCHDOG);
    CHECK(bench.ask(bench.host.clear()) == PALPATE_DONE);
  }
}

TEST_CASE("the image of the chip: a converter that stops is cut by the guard, then by a reset") {
  for (int baud : kBauds) {
    Driven bench(baud);
    bench.chip.stop_converter();
    const std::uint64_t begin = bench.chip.cycle();
    while (!bench.is_limp() && bench.elapsed(begin) < 3000.0) bench.drive(1, kStrong, 0, 0);

    print("converter off", baud, bench.elapsed(begin));
    CHECK(bench.elapsed(begin) < 6.0);
    // the reset switches the converter on again, so the device can tell what it was
    bench.drive(30, kStrong, kStrong, kStrong);
    CHECK(bench.is_limp());
    bench.host.info = {};
    bench.say(bench.host.hello());
    bench.wait(5);
    CHECK((bench.host.info.reset_cause & PALPATE_RESET_WATCHDOG) != 0);
    bench.check_latched(PALPATE_FAULT_WATCHDOG);
  }
}

TEST_CASE("the image of the chip: a frame said again and again loses its torque as silence does") {
  Driven bench(1000000);
  const Bytes wire = bench.host.command(kStrong, -kStrong, kStrong);
  const std::uint64_t begin = bench.chip.cycle();
  while (!bench.is_limp() && bench.elapsed(begin) < 3000.0) {
    bench.say(wire);
    bench.wait();
  }

  CHECK(bench.elapsed(begin) < 22.1);
  bench.check_latched(PALPATE_FAULT_HOST_SILENT);
}

TEST_CASE("the image of the chip: leaps to and fro and a stuck sensor are found" *
          doctest::test_suite("landing")) {
  Driven leaping(1000000);
  int ms = 0;
  for (; !leaping.is_limp() && ms < 100; ++ms) {
    leaping.chip.set_position(2, ms / 2 % 2 ? 612 : 412);
    leaping.drive(1, kStrong, -kStrong, kStrong);
  }
  CHECK(ms <= 16);
  leaping.check_latched(PALPATE_FAULT_OVER_SPEED);

  Driven stuck(1000000);
  for (ms = 0; !stuck.is_limp() && ms < 2000; ++ms) {
    for (int joint : {0, 2}) stuck.chip.set_position(joint, 512 + ms % 200);
    stuck.drive(1, kStrong, -kStrong, kStrong);
  }
  CHECK(ms > 400);
  CHECK(ms < 1100);
  stuck.check_latched(PALPATE_FAULT_SENSOR);
}

TEST_CASE("the image of the chip: a host that floods the wire makes no tick late" *
          doctest::test_suite("landing")) {
  for (int baud : kBauds) {
    Driven bench(baud);
    bench.chip.start_profile();
    const int before = bench.host.states;
    for (int i = 0; i < 1500; ++i) bench.say(bench.host.command(kStrong, kStrong, kStrong));
    bench.wait(190);
    const SimAvrProfile profile = bench.chip.profile();
    std::printf("flood at %d baud: load %.1f %% mean, %.1f %% worst, %d states of 190\n", baud,
                100 * profile.mean_load, 100 * profile.worst_load, bench.host.states - before);
    CHECK(bench.host.states - before >= 189);
    CHECK(bench.host.damaged == 0);
    CHECK((bench.host.state.faults & 1 << PALPATE_FAULT_OVERRUN) == 0);
    CHECK(bench.host.state.mode == PALPATE_RUN);
    CHECK(profile.tick_period_max < SimAvr::kTick + 8 * 16);
    bench.chip.set_stop_open(true);
    CHECK(bench.time_until_limp(5.0) < 1.1);
  }
}

TEST_CASE("the image of the chip: no command is lost, wherever in the millisecond it ends" *
          doctest::test_suite("landing")) {
  for (int baud : kBauds) {
    for (bool law : {false, true}) check_phases(baud, law, 89);
  }
}

TEST_CASE("the image of the chip: no command is lost at any cycle of the millisecond" *
          doctest::test_suite("verify")) {
  check_phases(1000000, false, 1);
  for (int baud : kBauds) {
    for (bool law : {false, true}) check_phases(baud, law, 7);
  }
}

TEST_CASE("the image of the chip: a damaged command is not applied") {
  Driven bench(1000000);
  for (int i = 0; i < 5; ++i) {
    Bytes wire = bench.host.command(-kStrong, kStrong, 0);
    wire[5] ^= 0x10;
    bench.wait(0.3);
    bench.say(bench.host.command(kStrong, -kStrong, kStrong));
    bench.say(wire);
    bench.wait(0.7);
    CHECK(bench.chip.duty(0) == 156);
  }
  CHECK((bench.host.state.faults & 1 << PALPATE_NOTICE_DAMAGED_FRAME) != 0);
  CHECK(bench.host.state.mode == PALPATE_RUN);
}

TEST_CASE("the image of the chip: 4 kB of random bytes never energise a motor") {
  for (int baud : kBauds) {
    SimBench bench(baud);
    bench.wait(5);
    bench.say(bench.host.hello());
    bench.wait(3);
    bench.ask(bench.host.clear());
    bench.drive(3, 0, 0, 0);
    std::mt19937 random(3);
    bool energised = false;
    for (int i = 0; i < 82; ++i) {
      Bytes noise(50);
      for (std::uint8_t& byte : noise)
        byte = static_cast<std::uint8_t>(random() % 8 ? random() : 0);
      bench.say(noise);
      for (int k = 0; k < 6; ++k) {
        bench.wait(0.2);
        energised |= !bench.is_limp();
      }
    }

    CHECK_FALSE(energised);
    CHECK(bench.host.state.mode != PALPATE_RAMP);
    // and it still listens
    bench.say({0});
    bench.wait(2);
    bench.say(bench.host.hello());
    bench.wait(5);
    CHECK(bench.ask(bench.host.clear()) == PALPATE_DONE);
  }
}

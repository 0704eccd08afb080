// SPDX-License-Identifier: GPL-3.0-or-later
// Row 1 of the verification plan: the program fits its millisecond. Virtual time: the same cycles
// on every machine.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>

#include "sim_bench.h"

using namespace palpate;

namespace {

constexpr int kBauds[] = {1000000, 500000};
constexpr int kJitter = 8 * 16;  ///< [cycles] of 8 us

constexpr int kSample = 500, kWhole = 2000;  ///< [ms] of work

/// Sensors that move, torques that change, a command in every millisecond at a phase of its own,
/// `jitter` of it wide.
SimAvrProfile work(SimBench& bench, bool law, double phase, double jitter, int milliseconds) {
  std::mt19937 random(1);
  bench.chip.start_profile();
  for (int i = 0; i < milliseconds; ++i) {
    for (int j = 0; j < PALPATE_JOINTS; ++j) {
      bench.chip.set_position(j, 512 + static_cast<int>(300 * std::sin(0.003 * i + j)));
    }
    palpate_command command{};
    command.torque[0] = static_cast<std::int16_t>(15000 * std::sin(0.01 * i));
    command.torque[1] = -12000;
    command.torque[2] = 5000;
    const double when = phase + jitter * (random() % 1000) / 1000.0;
    bench.wait(when);
    bench.say(bench.host.command(law ? with_law(command) : command));
    bench.wait(1.0 - when);
  }
  return bench.chip.profile();
}

void print(const char* what, int baud, const SimAvrProfile& p) {
  std::printf(
      "%s at %d baud: load %.1f %% mean, %.1f %% in the worst ms; tick %+.1f..%+.1f us; "
      "byte to interrupt %llu cycles; tick to end of STATE %.0f us mean, %.0f us at most\n",
      what, baud, 100 * p.mean_load, 100 * p.worst_load,
      (static_cast<double>(p.tick_period_min) - SimAvr::kTick) / 16,
      (static_cast<double>(p.tick_period_max) - SimAvr::kTick) / 16,
      static_cast<unsigned long long>(p.receive_delay_max), 1e6 * p.state_delay_mean,
      1e6 * p.state_delay_max);
}

void check_in_time(const SimBench& bench, const SimAvrProfile& profile, int states,
                   int milliseconds) {
  CHECK(states >= milliseconds - 1);
  CHECK(bench.host.damaged == 0);
  CHECK(bench.host.state.mode == PALPATE_RUN);
  CHECK(bench.host.state.faults == 0);
  CHECK(profile.bytes_overrun == 0);
  CHECK(profile.tick_period_min > SimAvr::kTick - kJitter);
  CHECK(profile.tick_period_max < SimAvr::kTick + kJitter);
  CHECK(profile.receive_delay_max < 2 * bench.byte_cycles());
}

void check_work(const char* what, bool law, double phase, double jitter, double most_load,
                int milliseconds) {
  for (int baud : kBauds) {
    SimBench bench(baud);
    bench.power_up();
    const int before = bench.host.states;

    const SimAvrProfile profile = work(bench, law, phase, jitter, milliseconds);

    print(what, baud, profile);
    CHECK(profile.worst_load < most_load);
    check_in_time(bench, profile, bench.host.states - before, milliseconds);
  }
}

/// [ms] From the last byte of a command to the PWM at most, of so many commands.
double find_latest(int baud, int commands) {
  SimBench bench(baud);
  bench.power_up();
  std::mt19937 random(2);
  double worst = 0.0;
  int torque = 0;
  for (int i = 0; i < commands; ++i) {
    bench.drive(8, torque, 0, 0);  // settles
    bench.wait((random() % 1000) / 1000.0);
    const int before = bench.chip.duty(0);
    torque = torque == 0 ? 5000 : 0;
    bench.say(bench.host.command(torque, 0, 0));
    const std::uint64_t end = bench.chip.receive_end();
    while (bench.chip.duty(0) == before && bench.chip.cycle() < end + SimAvr::kTick) {
      bench.chip.run(16);
    }
    if (bench.chip.cycle() > end) worst = std::max(worst, bench.elapsed(end));
  }
  std::printf("command to PWM at %d baud: %.0f us at most\n", baud, 1e3 * worst);
  return worst;
}

}  // namespace

TEST_CASE("whenever commands come, a quarter of the worst millisecond is free and ticks are even") {
  check_work("torques", false, 0.0, 1.0, 0.75, kSample);
}

TEST_CASE("whenever commands come in two seconds, a quarter of the worst millisecond is free" *
          doctest::test_suite("verify")) {
  check_work("torques", false, 0.0, 1.0, 0.75, kWhole);
}

TEST_CASE("with the local law the worst millisecond of a steady host stays below 85 percent") {
  check_work("local law", true, 0.3, 0.1, 0.85, kSample);
}

TEST_CASE("with the local law the worst of two thousand milliseconds stays below 85 percent" *
          doctest::test_suite("verify")) {
  check_work("local law", true, 0.3, 0.1, 0.85, kWhole);
}

TEST_CASE("a command reaches the PWM within 0.3 ms of its last byte") {
  for (int baud : kBauds) CHECK(find_latest(baud, 40) < 0.3);
}

TEST_CASE("each of 200 commands reaches the PWM within 0.3 ms of its last byte" *
          doctest::test_suite("verify")) {
  for (int baud : kBauds) CHECK(find_latest(baud, 200) < 0.3);
}

TEST_CASE("the stack never takes a quarter of its room, the program half of the flash") {
  SimBench bench;
  bench.power_up();
  // every message there is, at its deepest
  bench.chip.set_driver_fault(true);
  bench.ask(bench.host.clear());
  bench.chip.set_driver_fault(false);
  for (int p = 0; p < PALPATE_PAGES; ++p) bench.ask(bench.host.read_page(p));
  const palpate_calibration calibration = plain_calibration();
  std::uint8_t pages[PALPATE_CALIBRATION_BYTES];
  palpate_write_calibration(&calibration, pages);
  for (int p = 0; p < PALPATE_PAGES; ++p) bench.ask(bench.host.write_page(p, pages + 16 * p));
  bench.ask(bench.host.store(palpate_compute_crc(pages, sizeof pages)));
  bench.wait(600);
  bench.ask(bench.host.hello(9));
  bench.drive(200, 30000, 0, 0);

  long flash = 0;
  std::ifstream hex(std::string(PALPATE_IMAGES) + "1000000.hex");
  for (std::string line; std::getline(hex, line);) {
    if (line.substr(7, 2) == "00") flash += std::stol(line.substr(1, 2), nullptr, 16);
  }
  std::printf("flash %ld of 32768 bytes; stack %d of %d bytes\n", flash, bench.chip.stack_used(),
              bench.chip.stack_free());
  CHECK(flash > 1000);
  CHECK(flash < 16384);
  CHECK(bench.chip.stack_used() > 50);
  CHECK(4 * bench.chip.stack_used() < bench.chip.stack_free());
}

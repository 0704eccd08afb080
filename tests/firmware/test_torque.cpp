// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "bench.h"

using namespace palpate;

namespace {

palpate_command law(int k00, int shift) {
  palpate_command command{};
  command.has_law = true;
  command.shift = static_cast<std::uint8_t>(shift);
  for (auto& rest : command.rest) rest = 512 << PALPATE_FRACTION_BITS;
  command.stiffness[0] = static_cast<std::int16_t>(k00);
  return command;
}

}  // namespace

TEST_CASE("duty is torque over full scale, rounded, the same in both directions") {
  Bench bench;
  bench.power_up();
  for (int torque = 0; torque <= 29000; torque += 997) {
    bench.drive(12, torque, -torque, 0);

    const int expected = static_cast<int>(std::lround(255.0 * torque / 32768.0));
    CHECK(bench.board.duty[0] == expected);
    CHECK(bench.board.duty[1] == -expected);
  }
}

TEST_CASE("no torque passes the clamp, nor changes faster than the slew limit") {
  Bench bench;
  bench.power_up();
  int before = 0;
  for (int ms = 0; ms < 40; ++ms) {
    bench.drive(1, ms % 20 < 10 ? kFull : -32768, 0, 0);
    const int now = bench.board.duty[0];
    CHECK(std::abs(now - before) <= PALPATE_DUTY_SLEW);
    CHECK(std::abs(now) <= PALPATE_DUTY_MAX);
    before = now;
  }
  CHECK(before == -PALPATE_DUTY_MAX);
}

TEST_CASE("commands in a burst move the motors no faster than one") {
  Bench bench;
  bench.power_up();
  for (int i = 0; i < 3; ++i) bench.say(bench.host.command(kFull, 0, 0));

  CHECK(bench.board.duty[0] <= PALPATE_DUTY_SLEW);
}

TEST_CASE("the local law answers a moved joint before any new command") {
  Bench bench;
  bench.power_up();
  // 1600/16 of a 32767th per 1/16 count, so 1600 per count
  bench.say(bench.host.command(law(1600, 0)));
  bench.wait(1);
  CHECK(bench.board.duty[0] == 0);

  bench.board.adc[0] = 507;
  bench.wait(1);
  CHECK(bench.board.duty[0] == 48);  // 5 x 1600 x 255 / 32768 = 62, slew-limited
  bench.wait(1);

  CHECK(bench.board.duty[0] == 62);
  CHECK(bench.board.duty[1] == 0);
}

TEST_CASE("the local law is symmetric, shifted and added to the torque") {
  Bench bench;
  bench.power_up();
  palpate_command command = law(0, 2);
  command.torque[2] = 3000;
  command.stiffness[1] = -6400;  // between joints 0 and 1
  bench.board.adc[0] = 502;
  bench.board.adc[1] = 516;
  for (int i = 0; i < 10; ++i) {
    bench.say(bench.host.command(command));
    bench.wait();
  }

  // -6400 x (512 - 516) / 4 = 6400 on joint 0, -6400 x 10 / 4 = -16000 on joint 1
  CHECK(bench.board.duty[0] == std::lround(255 * 6400 / 32768.0));
  CHECK(bench.board.duty[1] == -std::lround(255 * 16000 / 32768.0));
  CHECK(bench.board.duty[2] == std::lround(255 * 3000 / 32768.0));
}

TEST_CASE("the steepest law saturates and never turns over") {
  Bench bench;
  bench.power_up();
  palpate_command command = law(32767, 0);
  for (auto& k : command.stiffness) k = 32767;
  for (auto& rest : command.rest) rest = 1000 << PALPATE_FRACTION_BITS;
  for (int j = 0; j < 3; ++j) bench.board.adc[j] = 10;
  for (int i = 0; i < 20; ++i) {
    bench.say(bench.host.command(command));
    bench.wait();
  }

  for (int m = 0; m < 3; ++m) CHECK(bench.board.duty[m] == PALPATE_DUTY_MAX);
}

TEST_CASE("a law whose numbers no sensor can reach is refused and changes nothing") {
  Bench bench;
  bench.power_up();
  bench.drive(12, 3000, 0, 0);
  const int before = bench.board.duty[0];
  const int most = 1023 << PALPATE_FRACTION_BITS;
  for (int rest : {most + 1, 32768, 50000, 65535}) {
    palpate_command command = law(32767, 0);
    command.rest[2] = static_cast<std::uint16_t>(rest);
    CHECK(bench.ask(bench.host.command(command)) == PALPATE_BAD_VALUE);
    CHECK(bench.board.duty[0] == before);
    bench.drive(1, 3000, 0, 0);
  }
  palpate_command command = law(0, 0);
  command.rest[2] = static_cast<std::uint16_t>(most);
  command.torque[0] = 3000;
  CHECK(bench.ask(bench.host.command(command)) == -1);  // obeyed without a word
}

TEST_CASE("flag bits 1 to 3 are refused, and so is a shift above 8, with the law or without") {
  Bench bench;
  bench.power_up();
  for (bool has_law : {false, true}) {
    for (int flags : {2, 4, 8, 9 << 4, 15 << 4}) {
      Bytes body(has_law ? 27 : 9);
      body[0] = PALPATE_COMMAND;
      body[1] = 200;
      body[2] = static_cast<std::uint8_t>(flags | has_law);
      bench.drive(1, 0, 0, 0);
      bench.say(encode(body));
      bench.wait();
      REQUIRE(!bench.host.answers.empty());
      CHECK(bench.host.answers.back().result == PALPATE_BAD_VALUE);
      bench.host.answers.clear();
    }
  }
  CHECK(bench.host.state.mode == PALPATE_RUN);
}

TEST_CASE("no law that is taken turns its sign over: what 64 bits give is what the motors get") {
  std::mt19937 random(5);
  const auto pick = [&](int low, int high) {
    // the ends as often as all between them
    const auto r = random();
    return r % 4 == 0 ? low : r % 4 == 1 ? high : low + static_cast<int>(r / 4) % (high - low + 1);
  };
  Bench bench;
  bench.power_up();
  for (int round = 0; round < 400; ++round) {
    palpate_command command{};
    command.has_law = true;
    command.shift = static_cast<std::uint8_t>(pick(0, 8));
    for (auto& torque : command.torque) torque = static_cast<std::int16_t>(pick(-32768, 32767));
    for (auto& rest : command.rest) rest = static_cast<std::uint16_t>(pick(0, 16368));
    for (auto& k : command.stiffness) k = static_cast<std::int16_t>(pick(-32768, 32767));
    for (int j = 0; j < 3; ++j) bench.board.adc[j] = static_cast<std::uint16_t>(pick(8, 1015));
    for (int i = 0; i < 12; ++i) {
      bench.board.device.fast = 0;  // these joints leap, and one may keep its place
      for (auto& ways : bench.board.device.travel) std::fill(ways, ways + PALPATE_MOTORS, 0);
      bench.say(bench.host.command(command));
      bench.wait();
    }
    REQUIRE(bench.host.state.mode == PALPATE_RUN);
    const int index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    for (int m = 0; m < 3; ++m) {
      std::int64_t sum = 0;
      for (int j = 0; j < 3; ++j) {
        sum += std::int64_t(command.stiffness[index[m][j]]) *
               (command.rest[j] - 16 * bench.board.adc[j]);
      }
      const std::int64_t wanted =
          std::clamp<std::int64_t>(command.torque[m] + (sum >> (4 + command.shift)), -32767, 32767);
      const auto duty = static_cast<int>(std::lround(255.0 * double(wanted) / 32768.0));
      const int limit = bench.board.device.duty_limit[m];
      CHECK(std::abs(bench.board.duty[m] - std::clamp(duty, -limit, limit)) <= 1);
    }
  }
}

TEST_CASE("the local law too falls to zero when the host is silent") {
  Bench bench;
  bench.power_up();
  bench.board.adc[0] = 500;
  for (int i = 0; i < 10; ++i) {
    bench.say(bench.host.command(law(1600, 0)));
    bench.wait();
  }
  REQUIRE(bench.board.duty[0] > 100);
  bench.wait(20);

  CHECK(bench.is_limp());
}

TEST_CASE("a deadband is what the smallest torque begins with") {
  Bench bench;
  bench.power_up();
  bench.board.device.limits.deadband[0] = 20;
  bench.drive(10, 200, 0, 0);
  CHECK(bench.board.duty[0] == 22);  // 2 - 0 + 20
  bench.drive(10, 50, 0, 0);

  CHECK(bench.board.duty[0] == 0);
}

TEST_CASE("a motor above its continuous duty heats as its winding does, and is then held to it") {
  Bench bench;
  bench.power_up();
  // full clamp: 230^2 (1 - exp(-t / 10 s)) reaches 128^2 at 3.71 s
  const double expected = -10.0 * std::log(1.0 - 128.0 * 128.0 / (230.0 * 230.0));
  int ms = 0;
  while (bench.board.duty[0] == 0 || bench.board.duty[0] > 128 || ms < 100) {
    bench.drive(1, kFull, 0, 0);
    REQUIRE(++ms < 6000);
  }

  CHECK(ms / 1000.0 == doctest::Approx(expected).epsilon(0.03));
  CHECK((bench.host.state.faults & 1 << PALPATE_FAULT_OVERHEATED) != 0);
  CHECK(bench.host.state.mode == PALPATE_RUN);
}

TEST_CASE("a host that goes on asking too much of a hot motor loses it, and CLEAR waits") {
  Bench bench;
  bench.power_up();
  bench.drive(10000, kFull, 0, 0);

  CHECK(bench.is_limp());
  CHECK(bench.host.state.first_fault == PALPATE_FAULT_OVERHEATED);
  CHECK(bench.ask(bench.host.clear()) == PALPATE_DONE);  // it has cooled below its limit by now
}

TEST_CASE("a motor within its continuous duty never gets hot") {
  Bench bench;
  bench.power_up();
  bench.drive(60000, 16000, 0, 0);  // duty 125 of 128

  CHECK(bench.board.duty[0] == 125);
  CHECK(bench.host.state.faults == 0);
}

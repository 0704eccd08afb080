// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "bench.h"

using namespace palpate;

TEST_CASE("HELLO is answered with INFO and begins the stream of a thousand states a second") {
  Bench bench;
  bench.wait(50);
  CHECK(bench.host.states == 0);

  bench.say(bench.host.hello());
  bench.wait(100);

  CHECK(bench.host.states == 100);
  CHECK(bench.host.damaged == 0);
  CHECK(bench.host.state.mode == PALPATE_IDLE);
  CHECK(bench.host.info.version == PALPATE_PROTOCOL_VERSION);
  CHECK(bench.host.info.session != 0);
  CHECK(bench.host.info.serial_number == 20261121);
  CHECK(bench.host.info.calibration_crc != 0);
}

TEST_CASE("a host of another version is told so, and gets no stream") {
  Bench bench;

  CHECK(bench.ask(bench.host.hello(99)) == PALPATE_WRONG_VERSION);
  bench.wait(10);

  CHECK(bench.host.info.version == PALPATE_PROTOCOL_VERSION);
  CHECK(bench.host.states == 0);
  CHECK(bench.board.device.mode == PALPATE_BOOT);
}

TEST_CASE("after CLEAR, three zero commands and ENABLE the torque limit grows for half a second") {
  Bench bench;
  bench.say(bench.host.hello());
  bench.wait();
  CHECK(bench.ask(bench.host.clear()) == PALPATE_DONE);
  bench.drive(3, 0, 0, 0);
  CHECK(bench.ask(bench.host.enable()) == PALPATE_DONE);
  CHECK(bench.host.state.mode == PALPATE_RAMP);

  bench.drive(249, kFull, -kFull, 0);
  CHECK(bench.board.duty[0] == 115);  // half of 230
  CHECK(bench.board.duty[1] == -115);
  bench.drive(252, kFull, -kFull, 0);

  CHECK(bench.host.state.mode == PALPATE_RUN);
  CHECK(bench.board.duty[0] == PALPATE_DUTY_MAX);
  CHECK(bench.board.duty[1] == -PALPATE_DUTY_MAX);
  CHECK(bench.board.duty[2] == 0);
}

TEST_CASE("ENABLE is refused without HELLO, with another session, or without zero commands") {
  Bench bench;
  CHECK(bench.ask(bench.host.order(PALPATE_ENABLE, 0)) == PALPATE_WRONG_SESSION);
  bench.say(bench.host.hello());
  bench.wait();
  CHECK(bench.ask(bench.host.enable()) == PALPATE_NOT_AT_ZERO);
  bench.drive(2, 0, 0, 0);
  CHECK(bench.ask(bench.host.enable()) == PALPATE_NOT_AT_ZERO);
  bench.drive(3, 0, 0, 0);
  bench.drive(1, 0, 1, 0);
  CHECK(bench.ask(bench.host.enable()) == PALPATE_NOT_AT_ZERO);
  bench.drive(3, 0, 0, 0);
  const auto other = static_cast<std::uint16_t>(bench.host.info.session + 1);
  CHECK(bench.ask(bench.host.order(PALPATE_ENABLE, other)) == PALPATE_WRONG_SESSION);
  bench.wait(PALPATE_HOLD_MS);
  CHECK(bench.ask(bench.host.enable()) == PALPATE_NOT_AT_ZERO);  // those zeros are too old

  CHECK(bench.is_limp());
  CHECK(bench.host.state.mode == PALPATE_IDLE);
}

TEST_CASE("DISABLE and a new HELLO take the torque away, and ENABLE ramps from zero again") {
  Bench bench;
  bench.power_up();
  bench.drive(10, kFull, 0, 0);
  REQUIRE(bench.board.duty[0] == PALPATE_DUTY_MAX);

  CHECK(bench.ask(bench.host.disable()) == PALPATE_DONE);
  CHECK(bench.is_limp());
  bench.drive(3, 0, 0, 0);
  CHECK(bench.ask(bench.host.enable()) == PALPATE_DONE);
  bench.drive(20, kFull, 0, 0);
  CHECK(bench.board.duty[0] < 20);

  const std::uint16_t before = bench.host.info.session;
  bench.say(bench.host.hello());
  bench.wait();
  CHECK(bench.is_limp());
  CHECK(bench.host.info.session != before);
}

TEST_CASE("torques in IDLE move nothing") {
  Bench bench;
  bench.say(bench.host.hello());

  bench.drive(100, kFull, kFull, kFull);

  CHECK(bench.is_limp());
  CHECK(bench.host.state.ack == bench.host.seq());
}

TEST_CASE("a message of unknown type, wrong length or bad value is refused by name") {
  Bench bench;
  bench.say(bench.host.hello());
  bench.wait();

  bench.say(encode({0x44, 1}));
  bench.wait();
  CHECK(bench.host.answers.back().result == PALPATE_UNKNOWN_TYPE);
  CHECK(bench.host.answers.back().type == 0x44);
  bench.say(encode({PALPATE_COMMAND, 2, 0}));
  bench.wait();
  CHECK(bench.host.answers.back().result == PALPATE_WRONG_LENGTH);
  palpate_command steep{};
  steep.has_law = true;
  steep.shift = 9;
  CHECK(bench.ask(bench.host.command(steep)) == PALPATE_BAD_VALUE);
  CHECK((bench.host.state.faults & 1 << PALPATE_NOTICE_REFUSED) != 0);
  CHECK(bench.host.state.first_fault == PALPATE_FAULT_NONE);
}

TEST_CASE("a damaged command is not applied and is noticed") {
  Bench bench;
  bench.power_up();
  bench.drive(10, 10000, 0, 0);
  const int before = bench.board.duty[0];
  Bytes wire = bench.host.command(-10000, 0, 0);
  wire[5] ^= 0x10;

  bench.say(wire);
  bench.wait();

  CHECK(bench.board.duty[0] == before);
  CHECK((bench.host.state.faults & 1 << PALPATE_NOTICE_DAMAGED_FRAME) != 0);
  CHECK(bench.host.state.mode == PALPATE_RUN);
}

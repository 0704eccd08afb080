// SPDX-License-Identifier: BSD-3-Clause
// What one, two and three wrong bits can do to every message, at either end of the wire. The CRC is
// of the body, not of the codes that stuff it, so a few patterns of three pass: as many as
// PROTOCOL.md says.
#include <doctest/doctest.h>

#include <cstdio>
#include <cstring>

#include "bench.h"

using namespace palpate;

namespace {

struct Count {
  long tried = 0;
  long passed = 0;  ///< a whole frame came, with another body or of another length
  long taken = 0;   ///< and the receiver did not refuse the message
};

/// A device with a session and its motors on takes this body without a refusal.
bool device_takes(const Bytes& body) {
  static const palpate_board ready = [] {
    Bench bench;
    bench.power_up();
    return bench.board;
  }();
  palpate_board board = ready;
  board.device.board = &board;
  const std::uint16_t refused = board.device.refused, damaged = board.device.damaged;
  const Bytes wire = encode(body);
  palpate_board_receive(&board, wire.data(), static_cast<std::uint16_t>(wire.size()));
  return board.device.refused == refused && board.device.damaged == damaged;
}

/// A host takes this body for a message.
bool host_takes(const Bytes& body) {
  const auto count = static_cast<std::uint8_t>(body.size());
  palpate_state state;
  palpate_answer answer;
  palpate_page page;
  palpate_info info;
  return palpate_read_state(body.data(), count, &state) ||
         palpate_read_answer(body.data(), count, &answer) ||
         palpate_read_page(body.data(), count, PALPATE_PAGE, &page) ||
         palpate_read_info(body.data(), count, &info);
}

void turn(Bytes& wire, int bit) {
  std::uint8_t& byte = wire[static_cast<std::size_t>(bit / 8)];
  byte = static_cast<std::uint8_t>(byte ^ 1 << bit % 8);
}

void judge(const Bytes& wire, const Bytes& body, Count& count) {
  ++count.tried;
  palpate_decoder decoder;
  palpate_start_decoder(&decoder);
  for (const std::uint8_t byte : wire) {
    if (palpate_decode_byte(&decoder, byte) != PALPATE_FRAME) continue;
    const Bytes heard(decoder.body, decoder.body + decoder.count);
    if (heard == body) continue;
    ++count.passed;
    count.taken += body[0] & 0x80 ? host_takes(heard) : device_takes(heard);
  }
}

/// All patterns of `flips` wrong bits in the frame of a body, its delimiter's among them.
Count count_flips(const Bytes& body, int flips) {
  Bytes wire = encode(body);
  const int bits = 8 * static_cast<int>(wire.size());
  Count count;
  for (int a = 0; a < bits; ++a) {
    turn(wire, a);
    if (flips == 1) judge(wire, body, count);
    for (int b = a + 1; flips > 1 && b < bits; ++b) {
      turn(wire, b);
      if (flips == 2) judge(wire, body, count);
      for (int c = b + 1; flips > 2 && c < bits; ++c) {
        turn(wire, c);
        judge(wire, body, count);
        turn(wire, c);
      }
      turn(wire, b);
    }
    turn(wire, a);
  }
  return count;
}

template <class Write>
Bytes write_body(Write write) {
  Bytes body(PALPATE_BODY_MAX);
  body.resize(write(body.data()));
  return body;
}

palpate_command plain_command() {
  palpate_command command{};
  command.seq = 7;
  return command;
}

palpate_command law_command() {
  palpate_command command = plain_command();
  command.has_law = true;
  command.shift = 3;
  for (int m = 0; m < 3; ++m) command.rest[m] = static_cast<std::uint16_t>(8000 + 300 * m);
  for (int k = 0; k < 6; ++k) command.stiffness[k] = static_cast<std::int16_t>(100 * k - 200);
  return command;
}

palpate_state some_state() {
  palpate_state state{};
  state.seq = 0x34;
  state.ack = 9;
  state.mode = PALPATE_RUN;
  state.tick = 0x1234;
  state.first_fault = PALPATE_FAULT_NONE;
  for (int j = 0; j < 6; ++j) state.position[j] = static_cast<std::uint16_t>(500 + 31 * j);
  return state;
}

struct Message {
  const char* name;
  Bytes body;
  long passed, taken;  ///< of three wrong bits
};

std::vector<Message> list_messages() {
  const palpate_command plain = plain_command(), law = law_command();
  const palpate_state state = some_state();
  const palpate_info info{.seq = 3,
                          .version = 1,
                          .release = {0, 1, 0},
                          .hardware = 1,
                          .joints = 6,
                          .motors = 3,
                          .adc_bits = 10,
                          .samples = 1,
                          .duty_max = 230,
                          .reset_cause = 1,
                          .features = 1,
                          .tick_hz = 1000,
                          .calibration_crc = 0x1d2c,
                          .session = 0x51a7,
                          .serial_number = 20261121};
  const palpate_hello hello{1, 1, 7};
  const palpate_order order{5, 0x51a7};
  const palpate_answer answer{5, PALPATE_ENABLE, 0};
  palpate_page page{6, 2, {}};
  for (int b = 0; b < PALPATE_PAGE_BYTES; ++b) page.bytes[b] = static_cast<std::uint8_t>(b % 5);
  const auto body = [](auto write) { return write_body(write); };
  return {
      {"HELLO", body([&](auto* to) { return palpate_write_hello(&hello, to); }), 0, 0},
      {"COMMAND", body([&](auto* to) { return palpate_write_command(&plain, to); }), 1, 1},
      {"COMMAND with the law", body([&](auto* to) { return palpate_write_command(&law, to); }), 7,
       5},
      {"ENABLE", body([&](auto* to) { return palpate_write_order(PALPATE_ENABLE, &order, to); }), 0,
       0},
      {"INFO", body([&](auto* to) { return palpate_write_info(&info, to); }), 29, 1},
      {"STATE", body([&](auto* to) { return palpate_write_state(&state, to); }), 2, 2},
      {"ANSWER", body([&](auto* to) { return palpate_write_answer(&answer, to); }), 0, 0},
      {"PAGE", body([&](auto* to) { return palpate_write_page(PALPATE_PAGE, &page, to); }), 0, 0},
  };
}

}  // namespace

TEST_CASE("of three wrong bits as many pass as the page says, of one and two none") {
  Count all;
  for (const Message& message : list_messages()) {
    for (int flips : {1, 2}) {
      const Count few = count_flips(message.body, flips);
      CHECK(few.taken == 0);  // what has lost or gained a zero at its end has a wrong length
    }
    const Count three = count_flips(message.body, 3);
    std::printf("%s: of %ld patterns of three wrong bits %ld pass, %ld are taken\n", message.name,
                three.tried, three.passed, three.taken);
    CHECK(three.passed == message.passed);
    CHECK(three.taken == message.taken);
    all.tried += three.tried;
    all.passed += three.passed;
    all.taken += three.taken;
  }
  std::printf("all: %ld of %ld pass, %ld are taken\n", all.passed, all.tried, all.taken);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cstring>

#include "host_of_device.h"

using namespace palpate;

namespace {

palpate_command law_command() {
  palpate_command command{};
  command.seq = 0x21;
  command.has_law = true;
  command.shift = 3;
  for (int m = 0; m < 3; ++m) {
    command.torque[m] = static_cast<std::int16_t>(-1000 * (m + 1));
    command.rest[m] = static_cast<std::uint16_t>(8000 + m);
  }
  for (int k = 0; k < 6; ++k) command.stiffness[k] = static_cast<std::int16_t>(-300 + 100 * k);
  return command;
}

}  // namespace

TEST_CASE("a command has 13 bytes on the wire, a state 32, and a command with the law 31") {
  const palpate_command plain{};
  const palpate_state state{};
  const palpate_command law = law_command();
  std::uint8_t body[PALPATE_BODY_MAX];
  std::uint8_t wire[PALPATE_WIRE_MAX];

  CHECK(palpate_encode_frame(body, palpate_write_command(&plain, body), wire) == 13);
  CHECK(palpate_encode_frame(body, palpate_write_command(&law, body), wire) == 31);
  CHECK(palpate_encode_frame(body, palpate_write_state(&state, body), wire) == 32);
}

TEST_CASE("a command is laid out as PROTOCOL.md states it") {
  const palpate_command command{0x11, false, 0, 0, {1, -2, 0x1234}, {}, {}};
  Bytes body(PALPATE_BODY_MAX);

  body.resize(palpate_write_command(&command, body.data()));

  CHECK(body == Bytes{0x02, 0x11, 0x00, 0x01, 0x00, 0xfe, 0xff, 0x34, 0x12});
}

TEST_CASE("a command with the local law comes back as it was sent") {
  const palpate_command sent = law_command();
  std::uint8_t body[PALPATE_BODY_MAX];
  const std::uint8_t count = palpate_write_command(&sent, body);
  palpate_command got{};

  REQUIRE(palpate_read_command(body, count, &got));

  CHECK(got.seq == sent.seq);
  CHECK(got.has_law);
  CHECK(got.shift == 3);
  CHECK(std::memcmp(got.torque, sent.torque, sizeof sent.torque) == 0);
  CHECK(std::memcmp(got.rest, sent.rest, sizeof sent.rest) == 0);
  CHECK(std::memcmp(got.stiffness, sent.stiffness, sizeof sent.stiffness) == 0);
}

TEST_CASE("a state comes back as it was sent, and a healthy one names no fault") {
  palpate_state sent{0x34, 9, PALPATE_RUN, 2, 0x1234, 0, PALPATE_FAULT_NONE, {}, {}, 77};
  for (int j = 0; j < 6; ++j) sent.position[j] = static_cast<std::uint16_t>(100 * j);
  for (int m = 0; m < 3; ++m) sent.duty[m] = static_cast<std::int16_t>(-200 + 150 * m);
  std::uint8_t body[PALPATE_BODY_MAX];

  palpate_state got{};
  REQUIRE(palpate_read_state(body, palpate_write_state(&sent, body), &got));

  CHECK(got.tick == 0x1234);
  CHECK(got.mode == PALPATE_RUN);
  CHECK(got.buttons == 2);
  CHECK(got.first_fault == PALPATE_FAULT_NONE);
  CHECK(body[6] == 0);
  CHECK(body[7] == 0);
  CHECK(std::memcmp(got.position, sent.position, sizeof sent.position) == 0);
  CHECK(std::memcmp(got.duty, sent.duty, sizeof sent.duty) == 0);
  CHECK(got.aux == 77);
}

TEST_CASE("every fault can be the first, beside every other") {
  for (int first = 0; first < 12; ++first) {
    palpate_state sent{};
    sent.first_fault = static_cast<std::uint8_t>(first);
    sent.faults = 0x0fff;
    std::uint8_t body[PALPATE_BODY_MAX];

    palpate_state got{};
    REQUIRE(palpate_read_state(body, palpate_write_state(&sent, body), &got));

    CHECK(got.first_fault == first);
    CHECK(got.faults == 0x0fff);
    CHECK(std::strcmp(palpate_fault_name(got.first_fault), "none") != 0);
  }
  CHECK(std::strcmp(palpate_fault_name(PALPATE_FAULT_NONE), "none") == 0);
}

TEST_CASE("no message is read from a body of another type or length") {
  for (int type = 0; type < 256; ++type) {
    for (int count = 0; count <= PALPATE_BODY_MAX; ++count) {
      Bytes body(PALPATE_BODY_MAX, 0);
      body[0] = static_cast<std::uint8_t>(type);
      const auto n = static_cast<std::uint8_t>(count);
      palpate_command command{};
      palpate_state state{};
      palpate_info info{};
      palpate_hello hello{};

      CHECK(palpate_read_command(body.data(), n, &command) == (type == 0x02 && count == 9));
      CHECK(palpate_read_state(body.data(), n, &state) == (type == 0x82 && count == 28));
      CHECK(palpate_read_info(body.data(), n, &info) == (type == 0x81 && count == 24));
      CHECK(palpate_read_hello(body.data(), n, &hello) == (type == 0x01 && count == 4));
    }
  }
}

TEST_CASE("a calibration comes back from its bytes") {
  const palpate_calibration sent = plain_calibration();
  std::uint8_t bytes[PALPATE_CALIBRATION_BYTES];
  palpate_write_calibration(&sent, bytes);

  palpate_calibration got{};
  REQUIRE(palpate_read_calibration(bytes, &got));

  CHECK(got.joint[5].scale_nrad == sent.joint[5].scale_nrad);
  CHECK(got.joint[5].max == sent.joint[5].max);
  CHECK(got.torque_uNm[2] == sent.torque_uNm[2]);
  CHECK(got.gravity_uNm[1] == sent.gravity_uNm[1]);
  CHECK(got.heat_rate == sent.heat_rate);
  CHECK(got.serial_number == sent.serial_number);
}

TEST_CASE("a calibration that no device can have is refused") {
  const auto refused = [](auto spoil) {
    palpate_calibration c = plain_calibration();
    spoil(c);
    std::uint8_t bytes[PALPATE_CALIBRATION_BYTES];
    palpate_write_calibration(&c, bytes);
    palpate_calibration got{};
    return !palpate_read_calibration(bytes, &got);
  };

  CHECK_FALSE(refused([](palpate_calibration&) {}));
  CHECK(refused([](palpate_calibration& c) { c.joint[4].scale_nrad = 0; }));
  CHECK(refused([](palpate_calibration& c) { c.joint[0].min = c.joint[0].max; }));
  CHECK(refused([](palpate_calibration& c) { c.torque_uNm[1] = 0; }));
  CHECK(refused([](palpate_calibration& c) { c.continuous_duty[2] = 0; }));
  CHECK(refused([](palpate_calibration& c) { c.heat_rate = 0; }));
  CHECK(refused([](palpate_calibration& c) { c.link_um[0] = 0; }));
  CHECK(refused([](palpate_calibration& c) { c.deadband[0] = 64; }));
  CHECK(refused([](palpate_calibration& c) { c.speed_max = 0; }));
}

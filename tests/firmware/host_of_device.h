// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "firmware/board/host.h"
#include "firmware/protocol/calibration.h"
#include "firmware/protocol/frame.h"
#include "firmware/protocol/messages.h"

namespace palpate {

using Bytes = std::vector<std::uint8_t>;

/// A calibration of plausible numbers: 10-bit potentiometers of 270 degrees, small motors.
inline palpate_calibration plain_calibration() {
  palpate_calibration c{};
  c.speed_max = 40;
  for (auto& joint : c.joint) joint = {512, 4606000, 100, 923};
  c.link_um[0] = c.link_um[1] = 150000;
  for (int m = 0; m < PALPATE_MOTORS; ++m) {
    c.torque_uNm[m] = 470000;
    c.continuous_duty[m] = 128;
  }
  c.gravity_uNm[0] = 60000;
  c.gravity_uNm[1] = 40000;
  c.heat_rate = 105;  // 10 s
  c.serial_number = 20261121;
  return c;
}

/// An EEPROM with that in it.
inline Bytes calibrated_eeprom() {
  Bytes eeprom(PALPATE_EEPROM_BYTES);
  const palpate_calibration calibration = plain_calibration();
  palpate_write_eeprom(&calibration, eeprom.data());
  return eeprom;
}

inline Bytes encode(const Bytes& body) {
  Bytes wire(PALPATE_WIRE_MAX);
  wire.resize(
      palpate_encode_frame(body.data(), static_cast<std::uint8_t>(body.size()), wire.data()));
  return wire;
}

/// The host's end of the wire, as a test needs it: what it says as bytes, what it heard as
/// messages.
class HostOfDevice {
 public:
  HostOfDevice() { palpate_start_decoder(&decoder_); }

  Bytes hello(std::uint8_t version = PALPATE_PROTOCOL_VERSION) {
    const palpate_hello hello{++seq_, version, 7};
    return frame([&](std::uint8_t* body) { return palpate_write_hello(&hello, body); });
  }
  Bytes command(int a, int b, int c) {
    palpate_command command{};
    command.torque[0] = static_cast<std::int16_t>(a);
    command.torque[1] = static_cast<std::int16_t>(b);
    command.torque[2] = static_cast<std::int16_t>(c);
    return this->command(command);
  }
  Bytes command(palpate_command command) {
    command.seq = ++seq_;
    return frame([&](std::uint8_t* body) { return palpate_write_command(&command, body); });
  }
  Bytes enable() { return order(PALPATE_ENABLE, info.session); }
  Bytes clear() { return order(PALPATE_CLEAR, info.session); }
  Bytes order(palpate_type type, std::uint16_t session) {
    const palpate_order order{++seq_, session};
    return frame([&](std::uint8_t* body) { return palpate_write_order(type, &order, body); });
  }
  Bytes disable() {
    return frame([&](std::uint8_t* body) { return palpate_write_disable(++seq_, body); });
  }
  Bytes read_page(int page) {
    return frame([&](std::uint8_t* body) {
      return palpate_write_read_page(++seq_, static_cast<std::uint8_t>(page), body);
    });
  }
  Bytes write_page(int number, const std::uint8_t* bytes) {
    palpate_page page{++seq_, static_cast<std::uint8_t>(number), {}};
    std::copy(bytes, bytes + PALPATE_PAGE_BYTES, page.bytes);
    return frame(
        [&](std::uint8_t* body) { return palpate_write_page(PALPATE_WRITE_PAGE, &page, body); });
  }
  Bytes store(std::uint16_t crc) {
    const palpate_store store{++seq_, crc};
    return frame([&](std::uint8_t* body) { return palpate_write_store(&store, body); });
  }

  void hear(const Bytes& wire) {
    for (std::uint8_t byte : wire) {
      const palpate_decoded decoded = palpate_decode_byte(&decoder_, byte);
      if (decoded == PALPATE_DAMAGED) ++damaged;
      if (decoded == PALPATE_FRAME) take();
    }
  }

  std::uint8_t seq() const { return seq_; }

  palpate_info info{};
  palpate_state state{};
  int states = 0, damaged = 0;
  std::deque<palpate_answer> answers;
  std::deque<palpate_page> pages;

 private:
  template <typename Write>
  Bytes frame(Write write) {
    Bytes body(PALPATE_BODY_MAX);
    body.resize(write(body.data()));
    return encode(body);
  }

  void take() {
    const std::uint8_t* body = decoder_.body;
    palpate_answer answer;
    palpate_page page;
    if (palpate_read_state(body, decoder_.count, &state)) {
      ++states;
    } else if (palpate_read_answer(body, decoder_.count, &answer)) {
      answers.push_back(answer);
    } else if (palpate_read_page(body, decoder_.count, PALPATE_PAGE, &page)) {
      pages.push_back(page);
    } else if (!palpate_read_info(body, decoder_.count, &info)) {
      ++damaged;
    }
  }

  palpate_decoder decoder_;
  std::uint8_t seq_ = 0;
};

}  // namespace palpate

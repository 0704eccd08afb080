// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "host_of_device.h"

namespace palpate {

/// The app on the board in memory, with a host at its other end; a command each millisecond.
class Bench {
 public:
  explicit Bench(bool calibrated = true) {
    palpate_board_init(&board, calibrated ? calibrated_eeprom().data() : nullptr);
  }

  void say(const Bytes& wire) {
    palpate_board_receive(&board, wire.data(), static_cast<std::uint16_t>(wire.size()));
  }
  /// A silent millisecond, and what the device said in it.
  void wait(int ms = 1) {
    for (int i = 0; i < ms; ++i) {
      palpate_board_tick(&board);
      Bytes wire(PALPATE_SEND_BYTES);
      wire.resize(palpate_board_take(&board, wire.data(), PALPATE_SEND_BYTES));
      host.hear(wire);
    }
  }
  void drive(int ms, int a, int b, int c) {
    for (int i = 0; i < ms; ++i) {
      say(host.command(a, b, c));
      wait();
    }
  }
  /// What was answered to the message said last.
  int result() {
    wait();
    if (host.answers.empty()) return -1;
    const palpate_answer answer = host.answers.back();
    host.answers.clear();
    return answer.seq == host.seq() ? answer.result : -1;
  }
  int ask(const Bytes& wire) {
    say(wire);
    return result();
  }
  /// HELLO, CLEAR, three zero commands, ENABLE, the ramp: ready for torque.
  void power_up() {
    wait(2);
    say(host.hello());
    wait();
    ask(host.clear());
    drive(3, 0, 0, 0);
    ask(host.enable());
    drive(PALPATE_RAMP_MS + 2, 0, 0, 0);
  }
  bool is_limp() const {
    return !board.enabled && std::all_of(board.duty, board.duty + 3, [](int d) { return d == 0; });
  }

  palpate_board board;
  HostOfDevice host;
};

inline constexpr int kFull = PALPATE_TORQUE_FULL;

}  // namespace palpate

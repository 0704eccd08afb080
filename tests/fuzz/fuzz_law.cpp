// SPDX-License-Identifier: BSD-3-Clause
// Any local law a host may send: its arithmetic overflows nowhere, and no motor is driven against
// what the law, computed in wider numbers, asks for.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "../firmware/bench.h"
#include "insist.h"

using palpate::fuzz::Input;
using palpate::fuzz::insist;

namespace {

/// tau = tau0 + Kq (q0 - q) without limits, [2^-(shift + 4) of a 32767th of full scale].
std::int64_t compute_exactly(const palpate_device& device, int motor) {
  static constexpr int kPlace[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  const palpate_command& command = device.command;
  const int shift = command.shift + PALPATE_FRACTION_BITS;
  std::int64_t torque = std::int64_t{command.torque[motor]} << shift;
  if (!command.has_law) return torque;
  for (int j = 0; j < PALPATE_MOTORS; ++j) {
    const int away = int{command.rest[j]} - (int{device.position[j]} << PALPATE_FRACTION_BITS);
    torque += std::int64_t{command.stiffness[kPlace[motor][j]]} * away;
  }
  return torque;
}

/// A duty goes from `before` towards what is asked for, or to zero; never the other way.
void check_motors(const palpate_board& board, const std::int16_t before[PALPATE_MOTORS]) {
  for (int m = 0; m < PALPATE_MOTORS; ++m) {
    const int duty = board.duty[m], was = before[m];
    insist(std::abs(duty) <= PALPATE_DUTY_MAX, "a duty keeps its limit");
    insist(board.enabled || duty == 0, "a motor that is off has no torque");
    if (!board.enabled) continue;
    insist(std::abs(duty - was) <= PALPATE_DUTY_SLEW, "a torque keeps its slew limit");
    const std::int64_t exact = compute_exactly(board.device, m);
    insist(exact < 0 || duty >= std::min(was, 0), "no torque against a positive law");
    insist(exact > 0 || duty <= std::max(was, 0), "no torque against a negative law");
  }
}

palpate_command take_command(Input& input) {
  palpate_command command{};
  const std::uint8_t kind = input.byte();
  command.has_law = kind & 1;
  command.shift = static_cast<std::uint8_t>((kind >> 1) % 10);  // 9 is to be refused
  for (auto& torque : command.torque) torque = input.word();
  for (auto& rest : command.rest) rest = static_cast<std::uint16_t>(input.word());
  for (auto& stiffness : command.stiffness) stiffness = input.word();
  return command;
}

/// By a few counts, as a hand moves a joint; a large step is for the guard, not for the law.
void move_joints(Input& input, palpate_board& board) {
  for (int j = 0; j < PALPATE_MOTORS; ++j) {
    const int step = static_cast<std::int8_t>(input.byte()) / 4;
    board.adc[j] = static_cast<std::uint16_t>(
        std::clamp(board.adc[j] + step, int{PALPATE_RAIL_LOW}, int{PALPATE_RAIL_HIGH}));
  }
}

const palpate::Bench& running_bench() {
  static palpate::Bench bench;
  static const bool runs = [] {
    bench.power_up();
    return bench.board.enabled;
  }();
  insist(runs, "a good session switches the motors on");
  return bench;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  palpate::Bench bench = running_bench();
  palpate_board& board = bench.board;
  board.device.board = &board;
  Input input(data, size);
  while (!input.empty() && board.enabled) {
    std::int16_t before[PALPATE_MOTORS];
    std::copy_n(board.device.tick_duty, PALPATE_MOTORS, before);
    bench.say(bench.host.command(take_command(input)));
    check_motors(board, before);
    move_joints(input, board);
    bench.wait();
    check_motors(board, before);
    insist(bench.host.damaged == 0, "the device sends whole frames");
  }
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Any bytes on both ends of the device's wire: nothing is read or written outside its place, no
// torque passes its limits, and motors that are not enabled have none.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "../firmware/bench.h"

namespace {

void insist(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

/// Every reader, on a body whose end is the end of its memory.
void read_as_everything(const std::uint8_t* body, std::uint8_t count) {
  palpate_hello hello;
  palpate_command command;
  palpate_order order;
  palpate_info info;
  palpate_state state;
  palpate_answer answer;
  palpate_page page;
  palpate_store store;
  std::uint8_t seq, number;
  auto* own = static_cast<std::uint8_t*>(std::malloc(count));
  std::memcpy(own, body, count);
  palpate_read_hello(own, count, &hello);
  palpate_read_command(own, count, &command);
  palpate_read_order(own, count, PALPATE_ENABLE, &order);
  palpate_read_info(own, count, &info);
  if (palpate_read_state(own, count, &state)) palpate_fault_name(state.first_fault);
  if (palpate_read_answer(own, count, &answer)) palpate_result_name(answer.result);
  palpate_read_page(own, count, PALPATE_PAGE, &page);
  palpate_read_read_page(own, count, &seq, &number);
  palpate_read_store(own, count, &store);
  std::free(own);
}

void check_motors(const palpate_board& board) {
  const std::uint8_t mode = board.device.mode;
  const bool energised = mode == PALPATE_RAMP || mode == PALPATE_RUN;
  insist(board.enabled == energised, "the drivers are not as the mode says");
  for (int duty : board.duty) {
    insist(std::abs(duty) <= PALPATE_DUTY_MAX, "a duty passed its limit");
    insist(energised || duty == 0, "a motor that is not enabled has torque");
  }
}

}  // namespace

// Forty bytes a millisecond; the first of them also says what the pins do. A device that was
// calibrated before, and so can be armed in a few frames, if the very first is above 127.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static palpate_board board;
  static const palpate::Bytes calibrated = palpate::calibrated_eeprom();
  palpate_board_init(&board, size > 0 && data[0] > 127 ? calibrated.data() : nullptr);
  palpate_decoder decoder;
  palpate_start_decoder(&decoder);
  for (std::size_t at = 0; at < size; ++at) {
    if (palpate_decode_byte(&decoder, data[at]) == PALPATE_FRAME) {
      read_as_everything(decoder.body, decoder.count);
    }
  }
  palpate_start_decoder(&decoder);  // what is left in it came from nobody
  for (std::size_t at = 0; at < size; at += 40) {
    const std::size_t count = size - at < 40 ? size - at : 40;
    const std::uint8_t pins = data[at];
    board.stop_open = pins == 1;
    board.driver_fault = pins == 2;
    board.adc[pins % 6] = static_cast<std::uint16_t>(pins * 4);
    palpate_board_receive(&board, data + at, static_cast<std::uint16_t>(count));
    check_motors(board);
    palpate_board_tick(&board);
    check_motors(board);
    std::uint8_t out[PALPATE_SEND_BYTES];
    const std::uint16_t heard = palpate_board_take(&board, out, sizeof out);
    for (std::uint16_t b = 0; b < heard; ++b) {
      insist(palpate_decode_byte(&decoder, out[b]) != PALPATE_DAMAGED,
             "the device sent a damaged frame");
    }
  }
  return 0;
}

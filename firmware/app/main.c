// SPDX-License-Identifier: BSD-3-Clause
// The main loop of a microcontroller.
#include "app/device.h"

struct palpate_device palpate_main_device;

int main(void) {
  struct palpate_device *device = &palpate_main_device;
  palpate_start(device, 0, board_begin());
  board_go();
  for (;;) {
    board_wait();
    uint8_t count;
    const uint8_t *wire;
    while ((wire = board_next_frame(&count))) {
      palpate_receive(device, wire, count);
      board_free_frame();
    }
    if (board_take_gap()) palpate_miss_bytes(device);
    palpate_drive(device);
    uint16_t position[PALPATE_JOINTS];
    uint8_t buttons;
    if (board_take_samples(position, &buttons)) palpate_tick(device, position, buttons);
  }
}

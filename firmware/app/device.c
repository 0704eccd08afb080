// SPDX-License-Identifier: BSD-3-Clause
#include "app/device.h"

#include <string.h>

#include "app/parts.h"

void palpate_start(struct palpate_device *device, struct palpate_board *board,
                   uint8_t reset_cause) {
  memset(device, 0, sizeof *device);
  device->board = board;
  device->first_fault = PALPATE_FAULT_NONE;
  device->reset_cause = reset_cause;
  device->command_age = 255;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) device->duty_limit[m] = PALPATE_DUTY_MAX;
  board_enable(board, false);
  if (reset_cause & PALPATE_RESET_WATCHDOG) palpate_cut(device, PALPATE_FAULT_WATCHDOG);
  palpate_load_calibration(device);
}

void palpate_receive(struct palpate_device *device, const uint8_t *wire, uint8_t count) {
  device->body_count = palpate_decode_frame(wire, count, device->body);
  if (device->body_count) {
    palpate_obey(device);
  } else {
    device->damaged++;
    palpate_notice(device, PALPATE_NOTICE_DAMAGED_FRAME);
  }
}

void palpate_miss_bytes(struct palpate_device *device) {
  device->gaps++;
  palpate_notice(device, PALPATE_NOTICE_BYTES_LOST);
}

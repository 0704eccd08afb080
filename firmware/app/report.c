// SPDX-License-Identifier: BSD-3-Clause
// What the device says.
#include "app/parts.h"

void palpate_send(struct palpate_device *device, const uint8_t *body, uint8_t count) {
  uint8_t *wire = board_frame(device->board);
  if (wire) board_send(device->board, palpate_encode_frame(body, count, wire));
}

void palpate_answer(struct palpate_device *device, uint8_t seq, uint8_t type, uint8_t result) {
  if (result != PALPATE_DONE) {
    device->refused++;
    palpate_notice(device, PALPATE_NOTICE_REFUSED);
  }
  const struct palpate_answer answer = {.seq = seq, .type = type, .result = result};
  uint8_t body[PALPATE_BODY_MAX];
  palpate_send(device, body, palpate_write_answer(&answer, body));
}

static uint16_t find_aux(const struct palpate_device *device, uint8_t which) {
  switch (which) {
    case PALPATE_AUX_DAMAGED:
      return device->damaged;
    case PALPATE_AUX_REFUSED:
      return device->refused;
    case PALPATE_AUX_OVERRUNS:
      return device->overruns;
    case PALPATE_AUX_GAPS:
      return device->gaps;
    case PALPATE_AUX_WORST_AGE:
      return device->worst_age;
    default:
      return (uint16_t)(device->heat[which] >> 16);
  }
}

void palpate_send_state(struct palpate_device *device) {
  struct palpate_state state;
  uint8_t was = board_lock(device->board);
  state.tick = device->tick;
  state.mode = device->mode;
  state.faults = device->faults;
  state.first_fault = device->first_fault;
  board_unlock(device->board, was);
  state.seq = (uint8_t)state.tick;
  state.ack = device->ack;
  state.buttons = device->buttons;
  for (uint8_t j = 0; j < PALPATE_JOINTS; j++) state.position[j] = device->position[j];
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) state.duty[m] = device->duty[m];
  state.aux = find_aux(device, state.seq & 7);
  uint8_t body[PALPATE_BODY_MAX];
  palpate_send(device, body, palpate_write_state(&state, body));
}

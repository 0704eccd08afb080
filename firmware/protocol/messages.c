// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/messages.h"

#include <string.h>

#include "protocol/bytes.h"

enum {
  HELLO_BYTES = 4,
  COMMAND_BYTES = 9,
  LAW_BYTES = 18,
  ORDER_BYTES = 4,
  INFO_BYTES = 24,
  STATE_BYTES = 28,
  ANSWER_BYTES = 4,
  READ_PAGE_BYTES = 3,
  PAGE_BYTES = 3 + PALPATE_PAGE_BYTES,
  STORE_BYTES = 4,
  HAS_LAW = 1,
  SPARE_FLAGS = 0x0e,
};

uint8_t palpate_write_hello(const struct palpate_hello *hello, uint8_t *body) {
  body[0] = PALPATE_HELLO;
  body[1] = hello->seq;
  body[2] = hello->version;
  body[3] = hello->nonce;
  return HELLO_BYTES;
}

bool palpate_read_hello(const uint8_t *body, uint8_t count, struct palpate_hello *hello) {
  if (count != HELLO_BYTES || body[0] != PALPATE_HELLO) return false;
  hello->seq = body[1];
  hello->version = body[2];
  hello->nonce = body[3];
  return true;
}

uint8_t palpate_write_command(const struct palpate_command *command, uint8_t *body) {
  body[0] = PALPATE_COMMAND;
  body[1] = command->seq;
  body[2] = command->has_law ? (uint8_t)(HAS_LAW | command->shift << 4) : 0;
  uint8_t *at = body + 3;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) at = put_16(at, (uint16_t)command->torque[m]);
  if (!command->has_law) return COMMAND_BYTES;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) at = put_16(at, command->rest[m]);
  for (uint8_t k = 0; k < 6; k++) at = put_16(at, (uint16_t)command->stiffness[k]);
  return COMMAND_BYTES + LAW_BYTES;
}

bool palpate_read_command(const uint8_t *body, uint8_t count, struct palpate_command *command) {
  if (count < COMMAND_BYTES || body[0] != PALPATE_COMMAND) return false;
  uint8_t flags = body[2];
  bool has_law = flags & HAS_LAW;
  if (count != (has_law ? COMMAND_BYTES + LAW_BYTES : COMMAND_BYTES)) return false;
  command->seq = body[1];
  command->has_law = has_law;
  command->shift = flags >> 4;
  command->spare = flags & SPARE_FLAGS;
  const uint8_t *at = body + 3;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) command->torque[m] = (int16_t)take_16(&at);
  if (!has_law) return true;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) command->rest[m] = take_16(&at);
  for (uint8_t k = 0; k < 6; k++) command->stiffness[k] = (int16_t)take_16(&at);
  return true;
}

uint8_t palpate_write_order(uint8_t type, const struct palpate_order *order, uint8_t *body) {
  body[0] = type;
  body[1] = order->seq;
  put_16(body + 2, order->session);
  return ORDER_BYTES;
}

bool palpate_read_order(const uint8_t *body, uint8_t count, uint8_t type,
                        struct palpate_order *order) {
  if (count != ORDER_BYTES || body[0] != type) return false;
  const uint8_t *at = body + 2;
  order->seq = body[1];
  order->session = take_16(&at);
  return true;
}

uint8_t palpate_write_disable(uint8_t seq, uint8_t *body) {
  body[0] = PALPATE_DISABLE;
  body[1] = seq;
  return 2;
}

uint8_t palpate_write_read_page(uint8_t seq, uint8_t page, uint8_t *body) {
  body[0] = PALPATE_READ_PAGE;
  body[1] = seq;
  body[2] = page;
  return READ_PAGE_BYTES;
}

bool palpate_read_read_page(const uint8_t *body, uint8_t count, uint8_t *seq, uint8_t *page) {
  if (count != READ_PAGE_BYTES || body[0] != PALPATE_READ_PAGE) return false;
  *seq = body[1];
  *page = body[2];
  return true;
}

uint8_t palpate_write_page(uint8_t type, const struct palpate_page *page, uint8_t *body) {
  body[0] = type;
  body[1] = page->seq;
  body[2] = page->page;
  memcpy(body + 3, page->bytes, PALPATE_PAGE_BYTES);
  return PAGE_BYTES;
}

bool palpate_read_page(const uint8_t *body, uint8_t count, uint8_t type,
                       struct palpate_page *page) {
  if (count != PAGE_BYTES || body[0] != type) return false;
  page->seq = body[1];
  page->page = body[2];
  memcpy(page->bytes, body + 3, PALPATE_PAGE_BYTES);
  return true;
}

uint8_t palpate_write_store(const struct palpate_store *store, uint8_t *body) {
  body[0] = PALPATE_STORE;
  body[1] = store->seq;
  put_16(body + 2, store->crc);
  return STORE_BYTES;
}

bool palpate_read_store(const uint8_t *body, uint8_t count, struct palpate_store *store) {
  if (count != STORE_BYTES || body[0] != PALPATE_STORE) return false;
  const uint8_t *at = body + 2;
  store->seq = body[1];
  store->crc = take_16(&at);
  return true;
}

uint8_t palpate_write_info(const struct palpate_info *info, uint8_t *body) {
  const uint8_t head[] = {PALPATE_INFO,      info->seq,        info->version,  info->release[0],
                          info->release[1],  info->release[2], info->hardware, info->joints,
                          info->motors,      info->adc_bits,   info->samples,  info->duty_max,
                          info->reset_cause, info->features};
  memcpy(body, head, sizeof head);
  uint8_t *at = put_16(body + sizeof head, info->tick_hz);
  at = put_16(at, info->calibration_crc);
  at = put_16(at, info->session);
  put_32(at, info->serial_number);
  return INFO_BYTES;
}

bool palpate_read_info(const uint8_t *body, uint8_t count, struct palpate_info *info) {
  if (count != INFO_BYTES || body[0] != PALPATE_INFO) return false;
  info->seq = body[1];
  info->version = body[2];
  memcpy(info->release, body + 3, 3);
  info->hardware = body[6];
  info->joints = body[7];
  info->motors = body[8];
  info->adc_bits = body[9];
  info->samples = body[10];
  info->duty_max = body[11];
  info->reset_cause = body[12];
  info->features = body[13];
  const uint8_t *at = body + 14;
  info->tick_hz = take_16(&at);
  info->calibration_crc = take_16(&at);
  info->session = take_16(&at);
  info->serial_number = take_32(&at);
  return true;
}

// The highest four bits of the fault word hold the first fault, 15 for none, stored plus one so
// that a healthy device sends zero.
uint8_t palpate_write_state(const struct palpate_state *state, uint8_t *body) {
  body[0] = PALPATE_STATE;
  body[1] = state->seq;
  body[2] = state->ack;
  body[3] = (uint8_t)(state->mode | state->buttons << 4);
  uint8_t *at = put_16(body + 4, state->tick);
  uint8_t first = (uint8_t)(state->first_fault + 1) & 15;
  at = put_16(at, (uint16_t)((state->faults & 0x0fff) | (uint16_t)(uint8_t)(first << 4) << 8));
  for (uint8_t j = 0; j < PALPATE_JOINTS; j++) at = put_16(at, state->position[j]);
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) at = put_16(at, (uint16_t)state->duty[m]);
  put_16(at, state->aux);
  return STATE_BYTES;
}

bool palpate_read_state(const uint8_t *body, uint8_t count, struct palpate_state *state) {
  if (count != STATE_BYTES || body[0] != PALPATE_STATE) return false;
  state->seq = body[1];
  state->ack = body[2];
  state->mode = body[3] & 15;
  state->buttons = body[3] >> 4;
  const uint8_t *at = body + 4;
  state->tick = take_16(&at);
  uint16_t faults = take_16(&at);
  state->faults = faults & 0x0fff;
  state->first_fault = (uint8_t)((faults >> 12) - 1) & 15;
  for (uint8_t j = 0; j < PALPATE_JOINTS; j++) state->position[j] = take_16(&at);
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) state->duty[m] = (int16_t)take_16(&at);
  state->aux = take_16(&at);
  return true;
}

uint8_t palpate_write_answer(const struct palpate_answer *answer, uint8_t *body) {
  body[0] = PALPATE_ANSWER;
  body[1] = answer->seq;
  body[2] = answer->type;
  body[3] = answer->result;
  return ANSWER_BYTES;
}

bool palpate_read_answer(const uint8_t *body, uint8_t count, struct palpate_answer *answer) {
  if (count != ANSWER_BYTES || body[0] != PALPATE_ANSWER) return false;
  answer->seq = body[1];
  answer->type = body[2];
  answer->result = body[3];
  return true;
}

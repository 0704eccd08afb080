// SPDX-License-Identifier: BSD-3-Clause
// What the host may ask, and when it is refused.
#include "app/parts.h"

static bool is_zero(const struct palpate_command *command) {
  return !command->has_law && !command->torque[0] && !command->torque[1] && !command->torque[2];
}

// Numbers the torque can be computed from; the bits that mean nothing yet must be zero.
static bool is_sound(const struct palpate_command *command) {
  if (command->shift > PALPATE_SHIFT_MAX || command->spare) return false;
  if (!command->has_law) return true;
  const uint16_t most = (PALPATE_COUNTS - 1) * PALPATE_SAMPLES << PALPATE_FRACTION_BITS;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) {
    if (command->rest[m] > most) return false;
  }
  return true;
}

static void take_command(struct palpate_device *device, const uint8_t *body, uint8_t count) {
  struct palpate_command command;
  if (!palpate_read_command(body, count, &command)) {
    palpate_answer(device, body[1], PALPATE_COMMAND, PALPATE_WRONG_LENGTH);
    return;
  }
  if (!is_sound(&command)) {
    palpate_answer(device, body[1], PALPATE_COMMAND, PALPATE_BAD_VALUE);
    return;
  }
  // a wire that says the same again is no host: only one that counts on keeps its torque
  int8_t ahead = (int8_t)(command.seq - device->ack);
  if (ahead == 0 || (ahead < 0 && palpate_is_energised(device))) return;
  device->command = command;
  device->ack = command.seq;
  device->command_age = 0;
  device->fresh = true;
  if (!is_zero(&command)) {
    device->zero_commands = 0;
  } else if (device->zero_commands < 3) {
    device->zero_commands++;
  }
}

static void send_info(struct palpate_device *device, uint8_t seq) {
  const struct palpate_info info = {
      .seq = seq,
      .version = PALPATE_PROTOCOL_VERSION,
      .release = {0, 1, 0},
      .hardware = board_hardware(device->board),
      .joints = PALPATE_JOINTS,
      .motors = PALPATE_MOTORS,
      .adc_bits = PALPATE_ADC_BITS,
      .samples = PALPATE_SAMPLES,
      .duty_max = PALPATE_DUTY_MAX,
      .reset_cause = device->reset_cause,
      .features = PALPATE_FEATURE_LAW | device->memory,
      .tick_hz = PALPATE_TICK_HZ,
      .calibration_crc = device->calibration_crc,
      .session = device->session,
      .serial_number = device->serial_number,
  };
  uint8_t body[PALPATE_BODY_MAX];
  palpate_send(device, body, palpate_write_info(&info, body));
}

// A new host begins with the motors off and a session no earlier host knows.
static void greet(struct palpate_device *device, const struct palpate_hello *hello) {
  palpate_rest(device);
  device->zero_commands = 0;
  if (hello->version == PALPATE_PROTOCOL_VERSION) {
    uint16_t random = board_random(device->board);
    const uint8_t seed[] = {(uint8_t)random, (uint8_t)(random >> 8), hello->nonce,
                            (uint8_t)device->session, (uint8_t)(device->session >> 8)};
    device->session = palpate_compute_crc(seed, sizeof seed);
    if (device->session == 0) device->session = 1;
    device->streaming = true;
    uint8_t was = board_lock(device->board);
    if (device->mode == PALPATE_BOOT) device->mode = PALPATE_IDLE;
    board_unlock(device->board, was);
  } else {
    palpate_answer(device, hello->seq, PALPATE_HELLO, PALPATE_WRONG_VERSION);
  }
  send_info(device, hello->seq);
}

static uint8_t enable(struct palpate_device *device, uint16_t session) {
  if (device->storing.active) return PALPATE_BUSY;
  if (session != device->session) return PALPATE_WRONG_SESSION;
  if (device->mode != PALPATE_IDLE) return PALPATE_WRONG_MODE;
  if (device->zero_commands < 3 || device->command_age >= PALPATE_HOLD_MS) {
    return PALPATE_NOT_AT_ZERO;
  }
  device->ramp = 0;
  device->ramp_limit = 0;
  device->settled = false;
  device->worst_age = 0;
  device->hot_ms = 0;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) device->tick_duty[m] = 0;
  uint8_t was = board_lock(device->board);
  bool idle = device->mode == PALPATE_IDLE;
  if (idle) {
    device->mode = PALPATE_RAMP;
    board_enable(device->board, true);
  }
  board_unlock(device->board, was);
  return idle ? PALPATE_DONE : PALPATE_WRONG_MODE;
}

static uint8_t clear(struct palpate_device *device, uint16_t session) {
  if (session != device->session) return PALPATE_WRONG_SESSION;
  if (palpate_is_energised(device)) return PALPATE_WRONG_MODE;
  if (device->sensor_bad || !device->calibrated || palpate_is_hot(device)) {
    return PALPATE_CAUSE_REMAINS;
  }
  uint8_t was = board_lock(device->board);
  bool gone = device->pins == 0;
  if (gone) {
    device->faults = 0;
    device->first_fault = PALPATE_FAULT_NONE;
    device->mode = PALPATE_IDLE;
  }
  board_unlock(device->board, was);
  device->zero_commands = 0;
  return gone ? PALPATE_DONE : PALPATE_CAUSE_REMAINS;
}

static void take_order(struct palpate_device *device, uint8_t type) {
  struct palpate_order order = {.seq = device->body[1]};
  uint8_t result = PALPATE_WRONG_LENGTH;
  if (palpate_read_order(device->body, device->body_count, type, &order)) {
    // no host has said hello: there is no session yet
    if (device->session == 0) {
      result = PALPATE_WRONG_SESSION;
    } else {
      result =
          type == PALPATE_ENABLE ? enable(device, order.session) : clear(device, order.session);
    }
  }
  palpate_answer(device, order.seq, type, result);
}

static void read_page(struct palpate_device *device) {
  struct palpate_page page = {.seq = device->body[1]};
  uint8_t result = PALPATE_WRONG_LENGTH;
  if (palpate_read_read_page(device->body, device->body_count, &page.seq, &page.page)) {
    result = page.page < PALPATE_PAGES ? PALPATE_DONE : PALPATE_NO_SUCH_PAGE;
  }
  if (result != PALPATE_DONE) {
    palpate_answer(device, page.seq, PALPATE_READ_PAGE, result);
    return;
  }
  const uint8_t *from = device->pages + page.page * PALPATE_PAGE_BYTES;
  for (uint8_t b = 0; b < PALPATE_PAGE_BYTES; b++) page.bytes[b] = from[b];
  uint8_t body[PALPATE_BODY_MAX];
  palpate_send(device, body, palpate_write_page(PALPATE_PAGE, &page, body));
}

static uint8_t write_page(struct palpate_device *device) {
  struct palpate_page page;
  if (!palpate_read_page(device->body, device->body_count, PALPATE_WRITE_PAGE, &page)) {
    return PALPATE_WRONG_LENGTH;
  }
  if (palpate_is_energised(device)) return PALPATE_WRONG_MODE;
  if (device->storing.active) return PALPATE_BUSY;
  if (page.page >= PALPATE_PAGES) return PALPATE_NO_SUCH_PAGE;
  uint8_t *to = device->pages + page.page * PALPATE_PAGE_BYTES;
  for (uint8_t b = 0; b < PALPATE_PAGE_BYTES; b++) to[b] = page.bytes[b];
  return PALPATE_DONE;
}

static void store(struct palpate_device *device) {
  struct palpate_store order;
  uint8_t result = PALPATE_WRONG_LENGTH;
  if (palpate_read_store(device->body, device->body_count, &order)) {
    result =
        palpate_is_energised(device) ? PALPATE_WRONG_MODE : palpate_begin_store(device, &order);
  }
  if (result != PALPATE_DONE) palpate_answer(device, device->body[1], PALPATE_STORE, result);
}

void palpate_obey(struct palpate_device *device) {
  const uint8_t *body = device->body;
  uint8_t count = device->body_count;
  if (count < 2) {
    palpate_answer(device, 0, body[0], PALPATE_WRONG_LENGTH);
    return;
  }
  struct palpate_hello hello;
  switch (body[0]) {
    case PALPATE_COMMAND:
      take_command(device, body, count);
      break;
    case PALPATE_HELLO:
      if (palpate_read_hello(body, count, &hello)) {
        greet(device, &hello);
      } else {
        palpate_answer(device, body[1], PALPATE_HELLO, PALPATE_WRONG_LENGTH);
      }
      break;
    case PALPATE_ENABLE:
    case PALPATE_CLEAR:
      take_order(device, body[0]);
      break;
    case PALPATE_DISABLE:
      palpate_rest(device);
      palpate_answer(device, body[1], PALPATE_DISABLE, PALPATE_DONE);
      break;
    case PALPATE_READ_PAGE:
      read_page(device);
      break;
    case PALPATE_WRITE_PAGE:
      palpate_answer(device, body[1], PALPATE_WRITE_PAGE, write_page(device));
      break;
    case PALPATE_STORE:
      store(device);
      break;
    default:
      palpate_answer(device, body[1], body[0], PALPATE_UNKNOWN_TYPE);
  }
}

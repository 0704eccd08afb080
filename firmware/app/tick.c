// SPDX-License-Identifier: BSD-3-Clause
// One millisecond of the device, when its samples are there.
#include "app/parts.h"

static void check_samples(struct palpate_device *device, const uint16_t *position) {
  bool bad = false;
  bool fast = false;
  for (uint8_t j = 0; j < PALPATE_JOINTS; j++) {
    uint16_t now = position[j];
    uint16_t before = device->position[j];
    device->position[j] = now;
    if (now < PALPATE_RAIL_LOW * PALPATE_SAMPLES || now > PALPATE_RAIL_HIGH * PALPATE_SAMPLES) {
      bad = true;
    }
    uint16_t moved = now > before ? now - before : before - now;
    if (j < PALPATE_MOTORS && moved > (uint16_t)device->limits.speed_max * PALPATE_SAMPLES) {
      fast = true;
    }
  }
  device->sensor_bad = bad;
  if (bad) palpate_cut(device, PALPATE_FAULT_SENSOR);
  device->fast_ticks = fast && device->sampled ? (uint8_t)(device->fast_ticks + 1) : 0;
  device->sampled = true;
  // a hand may move a limp arm as it likes
  if (device->fast_ticks >= PALPATE_FAST_TICKS) {
    device->fast_ticks = 0;
    if (palpate_is_energised(device)) palpate_cut(device, PALPATE_FAULT_OVER_SPEED);
  }
}

static void count_late_ticks(struct palpate_device *device) {
  if (++device->overrun_window == 100) {
    device->overrun_window = 0;
    device->overruns_now = 0;
  }
  if (device->late == 0) return;
  uint8_t was = board_lock(device->board);
  uint8_t late = device->late;
  device->late = 0;
  board_unlock(device->board, was);

  device->overruns += late;
  device->overruns_now += late;
  palpate_notice(device, PALPATE_FAULT_OVERRUN);
  if (device->overruns_now >= 3) {
    device->overruns_now = 0;
    palpate_cut(device, PALPATE_FAULT_OVERRUN);
  }
}

static void continue_ramp(struct palpate_device *device) {
  if (device->mode != PALPATE_RAMP) return;
  if (device->ramp < PALPATE_RAMP_MS) {
    device->ramp++;
    // 118/256 of 500 ms is PALPATE_DUTY_MAX
    device->ramp_limit = (uint8_t)((uint32_t)device->ramp * 118 >> 8);
    return;
  }
  uint8_t was = board_lock(device->board);
  if (device->mode == PALPATE_RAMP) device->mode = PALPATE_RUN;
  board_unlock(device->board, was);
}

void palpate_tick(struct palpate_device *device, const uint16_t *position, uint8_t buttons) {
  device->buttons = buttons & 3;
  check_samples(device, position);
  count_late_ticks(device);
  continue_ramp(device);
  uint8_t age = device->command_age;
  if (palpate_is_energised(device) && age > device->worst_age) device->worst_age = age;

  if (device->fresh || !palpate_is_settled(device)) palpate_move_motors(device);
  device->fresh = false;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) device->tick_duty[m] = device->duty[m];
  palpate_heat_motors(device);
  if (device->streaming) palpate_send_state(device);
  if (device->storing.active) palpate_continue_store(device);
  device->working = false;
}

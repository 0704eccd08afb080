// SPDX-License-Identifier: BSD-3-Clause
// One millisecond of the device, when its samples are there.
#include "app/parts.h"

static uint16_t find_distance(uint16_t a, uint16_t b) { return a > b ? a - b : b - a; }

// A joint that leaps to and fro is as bad as one that runs. A hand may move a limp arm as it likes.
static void check_speed(struct palpate_device *device, bool fast) {
  if (fast) {
    device->fast += PALPATE_FAST_STEP;
  } else if (device->fast) {
    device->fast--;
  }
  if (device->fast < PALPATE_FAST_MOST) return;
  device->fast = 0;
  if (palpate_is_energised(device)) palpate_cut(device, PALPATE_FAULT_OVER_SPEED);
}

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
    if (j < PALPATE_MOTORS &&
        find_distance(now, before) > (uint16_t)device->limits.speed_max * PALPATE_SAMPLES) {
      fast = true;
    }
  }
  device->sensor_bad = bad;
  if (bad) palpate_cut(device, PALPATE_FAULT_SENSOR);
  check_speed(device, fast && device->sampled);
  device->sampled = true;
}

// How far the others have gone since a joint stands still: both of them some way, or one very far.
// A hand that strokes about the axis of one joint moves that one alone.
static bool have_others_gone(const uint16_t travel[PALPATE_MOTORS]) {
  uint8_t gone = 0;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) {
    if (travel[m] > PALPATE_STUCK_FAR * PALPATE_SAMPLES) return true;
    if (travel[m] > PALPATE_STUCK_TRAVEL * PALPATE_SAMPLES) gone++;
  }
  return gone == PALPATE_MOTORS - 1;
}

// A sensor that stays where it is while its motor pushes and the other joints go their travel. A hand
// that holds still lets none of them go; one that moves in a plane has no torque out of it. A joint
// turn about, so a tick pays for one.
static void check_stuck(struct palpate_device *device) {
  uint8_t turn = device->heat_turn;
  uint16_t now = device->position[turn];
  uint16_t travel = find_distance(now, device->place[turn]);
  if (travel >= PALPATE_STUCK_STEP * PALPATE_SAMPLES) {
    device->place[turn] = now;
    // no joint goes that far in three ticks: a leap is no travel
    if (travel > 3 * (uint16_t)device->limits.speed_max * PALPATE_SAMPLES) travel = 0;
    for (uint8_t m = 0; m < PALPATE_MOTORS; m++) {
      int16_t duty = device->duty[m];
      if (m != turn && (duty >= PALPATE_STUCK_DUTY || duty <= -PALPATE_STUCK_DUTY)) {
        device->travel[m][turn] += travel;
      }
    }
  }
  if (find_distance(now, device->rest[turn]) > PALPATE_SAMPLES || !palpate_is_energised(device)) {
    device->rest[turn] = now;
    for (uint8_t m = 0; m < PALPATE_MOTORS; m++) device->travel[turn][m] = 0;
  } else if (have_others_gone(device->travel[turn])) {
    palpate_cut(device, PALPATE_FAULT_SENSOR);
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
  if (device->overruns_now >= PALPATE_LATE_TICKS) {
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
  check_stuck(device);
  count_late_ticks(device);
  continue_ramp(device);
  uint8_t age = device->command_age;
  if (palpate_is_energised(device) && age > device->worst_age) device->worst_age = age;

  if (device->fresh || !palpate_is_settled(device)) palpate_move_motors(device);
  device->fresh = false;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) device->tick_duty[m] = device->duty[m];
  if (device->calibrated) palpate_heat_motors(device);
  if (device->streaming) palpate_send_state(device);
  if (device->storing.active) palpate_continue_store(device);
  device->working = false;
}

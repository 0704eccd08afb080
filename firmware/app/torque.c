// SPDX-License-Identifier: BSD-3-Clause
// From what the host wants to what a motor may do.
#include "app/parts.h"

static int16_t clamp(int32_t value, int16_t most) {
  if (value > most) return most;
  return value < -most ? (int16_t)-most : (int16_t)value;
}

// No joint is further from its rest than its whole range, so the sum of three products of 16 bits
// stays within 32.
enum { FARTHEST = (PALPATE_COUNTS - 1) * PALPATE_SAMPLES << PALPATE_FRACTION_BITS };
_Static_assert(3 * (int64_t)FARTHEST * 32768 <= INT32_MAX, "the local law would overflow");

static int16_t find_way(uint16_t rest, uint16_t position) {
  uint16_t last = FARTHEST >> PALPATE_FRACTION_BITS;
  if (rest > FARTHEST) rest = FARTHEST;
  if (position > last) position = last;
  return (int16_t)((int16_t)rest - (int16_t)(position << PALPATE_FRACTION_BITS));
}

// tau = tau0 + Kq (q0 - q): with the newest samples, not the ones the host knew.
static void compute_torque(const struct palpate_device *device, int16_t torque[PALPATE_MOTORS]) {
  const struct palpate_command *command = &device->command;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) torque[m] = command->torque[m];
  if (!command->has_law) return;

  const int16_t *k = command->stiffness;
  int16_t away[PALPATE_MOTORS];
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) {
    away[m] = find_way(command->rest[m], device->position[m]);
  }
  int32_t sum[PALPATE_MOTORS] = {
      (int32_t)k[0] * away[0] + (int32_t)k[1] * away[1] + (int32_t)k[2] * away[2],
      (int32_t)k[1] * away[0] + (int32_t)k[3] * away[1] + (int32_t)k[4] * away[2],
      (int32_t)k[2] * away[0] + (int32_t)k[4] * away[1] + (int32_t)k[5] * away[2],
  };
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) {
    int32_t pull = sum[m];
    uint8_t shift = (uint8_t)(command->shift + PALPATE_FRACTION_BITS);
    // a whole byte costs nothing, a bit does
    if (shift >= 8) {
      pull >>= 8;
      shift -= 8;
    }
    for (; shift; shift--) pull >>= 1;
    torque[m] = clamp(torque[m] + pull, PALPATE_TORQUE_FULL);
  }
}

// A torque of full scale is a duty of 255, rounded; the deadband is what a motor needs to begin.
static uint8_t compute_duty(uint16_t torque, uint8_t deadband) {
  uint16_t twice = (uint16_t)(torque << 1);
  uint8_t duty = (uint8_t)((uint16_t)(twice - (twice >> 8) + 128) >> 8);
  if (duty == 0 || deadband == 0) return duty;
  return (uint8_t)(duty - (uint8_t)((uint16_t)duty * deadband / 255) + deadband);
}

// A torque outlives its command unchanged for 5 ms, then fades to zero at 20 ms.
static uint8_t fade(uint8_t duty, uint8_t age) {
  if (age <= PALPATE_HOLD_MS) return duty;
  if (age >= PALPATE_SILENT_MS) return 0;
  return (uint8_t)((uint16_t)duty * (uint8_t)(PALPATE_SILENT_MS - age) /
                   (PALPATE_SILENT_MS - PALPATE_HOLD_MS));
}

static int16_t compute_motor(const struct palpate_device *device, uint8_t motor, int16_t torque) {
  if (torque < -PALPATE_TORQUE_FULL) torque = -PALPATE_TORQUE_FULL;
  bool back = torque < 0;
  uint8_t size = compute_duty((uint16_t)(back ? -torque : torque), device->limits.deadband[motor]);
  size = fade(size, device->command_age);
  uint8_t limit = device->duty_limit[motor];
  if (limit > device->ramp_limit) limit = device->ramp_limit;
  if (size > limit) size = limit;
  return back ? -(int16_t)size : size;
}

// Sets all motors at once, unless the guard has cut them since their duty was computed.
static void set_motors(struct palpate_device *device, const int16_t duty[PALPATE_MOTORS]) {
  uint8_t was = board_lock(device->board);
  if (palpate_is_energised(device)) {
    for (uint8_t m = 0; m < PALPATE_MOTORS; m++) board_drive(device->board, m, duty[m]);
  }
  board_unlock(device->board, was);
}

void palpate_move_motors(struct palpate_device *device) {
  device->settled = true;
  if (!palpate_is_energised(device)) {
    for (uint8_t m = 0; m < PALPATE_MOTORS; m++) device->duty[m] = 0;
    return;
  }
  int16_t torque[PALPATE_MOTORS];
  compute_torque(device, torque);
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) {
    int16_t wanted = compute_motor(device, m, torque[m]);
    int16_t from = device->tick_duty[m];
    int16_t duty = (int16_t)(from + clamp(wanted - from, PALPATE_DUTY_SLEW));
    if (duty != wanted) device->settled = false;
    device->duty[m] = duty;
  }
  set_motors(device, device->duty);
}

// Nothing a motor follows has changed since it was moved last.
bool palpate_is_settled(const struct palpate_device *device) {
  return device->settled && device->mode == PALPATE_RUN && !device->command.has_law &&
         device->command_age <= PALPATE_HOLD_MS;
}

void palpate_drive(struct palpate_device *device) {
  if (!device->fresh) return;
  device->fresh = false;
  palpate_move_motors(device);
}

static uint16_t square(uint8_t x) { return (uint16_t)x * x; }

static uint16_t degree(const struct palpate_device *device, uint8_t motor) {
  return (uint16_t)(device->heat[motor] >> 16);
}

bool palpate_is_hot(const struct palpate_device *device) {
  if (!device->calibrated) return false;  // nobody knows what its motors bear
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) {
    if (degree(device, m) >= square(device->limits.continuous_duty[m])) return true;
  }
  return false;
}

// heat' = (duty^2 - heat) / time constant: what a winding does, with the square of its current.
// Hotter than its continuous duty would make it, a motor gets no more than that duty.
static void heat_motor(struct palpate_device *device, uint8_t motor) {
  int16_t duty = device->duty[motor];
  uint16_t power = square((uint8_t)(duty < 0 ? -duty : duty));
  int16_t rise = (int16_t)((power >> 1) - (degree(device, motor) >> 1));
  // (power - heat) 2^16 x rate 2^-20 = rise x rate / 8, and three ticks pass between two calls
  int32_t change = (int32_t)rise * (int16_t)device->limits.heat_rate;
  device->heat[motor] += (uint32_t)((change >> 3) * 3);

  uint8_t continuous = device->limits.continuous_duty[motor];
  bool hot = degree(device, motor) >= square(continuous);
  device->duty_limit[motor] = hot && continuous < PALPATE_DUTY_MAX ? continuous : PALPATE_DUTY_MAX;
  if (hot) palpate_notice(device, PALPATE_FAULT_OVERHEATED);
}

// A motor turn about, so a tick pays for one.
void palpate_heat_motors(struct palpate_device *device) {
  static const uint8_t next[4] = {1, 2, 0, 0};
  uint8_t motor = device->heat_turn;
  device->heat_turn = next[motor];
  heat_motor(device, motor);

  bool limited = false;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) {
    int16_t size = device->duty[m] < 0 ? (int16_t)-device->duty[m] : device->duty[m];
    if (device->duty_limit[m] < PALPATE_DUTY_MAX && size >= device->duty_limit[m]) limited = true;
  }
  device->hot_ms = limited ? (uint16_t)(device->hot_ms + 1) : 0;
  if (device->hot_ms >= PALPATE_HOT_MS) palpate_cut(device, PALPATE_FAULT_OVERHEATED);
}

// SPDX-License-Identifier: BSD-3-Clause
// What must happen in time whatever else the processor does, and how a fault takes hold.
#include "app/parts.h"

bool palpate_is_energised(const struct palpate_device *device) {
  uint8_t mode = device->mode;
  return mode == PALPATE_RAMP || mode == PALPATE_RUN;
}

// Called with the guard kept out, or by the guard.
static void latch(struct palpate_device *device, uint8_t fault) {
  board_enable(device->board, false);
  device->faults |= (uint16_t)1 << fault;
  if (device->first_fault == PALPATE_FAULT_NONE) device->first_fault = fault;
  device->mode = PALPATE_FAULTED;
}

void palpate_cut(struct palpate_device *device, uint8_t fault) {
  uint8_t was = board_lock(device->board);
  latch(device, fault);
  board_unlock(device->board, was);
}

void palpate_notice(struct palpate_device *device, uint8_t notice) {
  uint8_t was = board_lock(device->board);
  device->faults |= (uint16_t)1 << notice;
  board_unlock(device->board, was);
}

void palpate_rest(struct palpate_device *device) {
  uint8_t was = board_lock(device->board);
  if (palpate_is_energised(device)) {
    board_enable(device->board, false);
    device->mode = PALPATE_IDLE;
  }
  board_unlock(device->board, was);
}

bool palpate_guard(struct palpate_device *device, uint8_t pins) {
  device->tick++;
  device->pins = pins;
  bool done = !device->working;
  device->working = true;
  // the work counts its own delays; where it does not come back, nobody but the guard is left
  if (!done && device->late < 255 && ++device->late >= PALPATE_LATE_TICKS) {
    latch(device, PALPATE_FAULT_OVERRUN);
  }

  uint8_t age = device->command_age;
  if (age < 255) device->command_age = ++age;
  if (pins & PALPATE_PIN_STOP) latch(device, PALPATE_FAULT_STOP_PRESSED);
  if (pins & PALPATE_PIN_DRIVER_FAULT) latch(device, PALPATE_FAULT_DRIVER);
  if (age > PALPATE_SILENT_MS && palpate_is_energised(device)) {
    latch(device, PALPATE_FAULT_HOST_SILENT);
  }
  return done;
}

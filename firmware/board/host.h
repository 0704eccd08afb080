// SPDX-License-Identifier: BSD-3-Clause
// A board that exists in memory only: its pins are fields, its millisecond is a call. For tests,
// and for the simulated device that runs the real app.
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "app/device.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  PALPATE_EEPROM_BYTES = 1024,
  PALPATE_SEND_BYTES = 4 * PALPATE_WIRE_MAX,
  PALPATE_RECEIVE_BYTES = 36,
  PALPATE_WATCHDOG_MS = 16
};

struct palpate_board {
  // pins in
  uint16_t adc[PALPATE_JOINTS];  ///< [counts] 0..1023
  bool stop_open;                ///< the emergency stop's line is open: pressed, or unplugged
  bool driver_fault;
  bool adc_stopped;  ///< its converter is off: no samples come
  uint8_t buttons;
  // pins out
  int16_t duty[PALPATE_MOTORS];
  bool enabled;  ///< the drivers; without it a duty moves nothing

  uint8_t undone;  ///< [ms] since the watchdog was restarted

  uint8_t eeprom[PALPATE_EEPROM_BYTES];
  uint8_t eeprom_busy;   ///< [ms] until it takes another byte
  long eeprom_strength;  ///< bytes it will still keep, negative: any number; then the power failed

  uint8_t to_host[PALPATE_SEND_BYTES];
  uint16_t to_host_count;
  uint8_t from_host[PALPATE_WIRE_MAX];
  uint8_t from_host_count;  ///< PALPATE_WIRE_MAX: too long, or skipping to the next delimiter
  uint8_t received_now;     ///< bytes of whole frames in this millisecond
  bool deaf;                ///< until the next millisecond

  struct palpate_device device;
};

/// A new board with a blank EEPROM (or what `eeprom` holds, if not null), sensors at half scale.
void palpate_board_init(struct palpate_board *board, const uint8_t *eeprom);
/// A reset, for the cause that INFO will give; EEPROM and pins stay as they are.
void palpate_board_reset(struct palpate_board *board, uint8_t cause);

/// Bytes from the host. After a frame with which those of this millisecond exceed
/// PALPATE_RECEIVE_BYTES the board is deaf until the next, as the real one is to stay in time.
void palpate_board_receive(struct palpate_board *board, const uint8_t *bytes, uint16_t count);
/// One millisecond: guard, samples, tick. Allocates nothing.
void palpate_board_tick(struct palpate_board *board);
/// Moves up to `capacity` bytes meant for the host into `bytes`; returns how many.
uint16_t palpate_board_take(struct palpate_board *board, uint8_t *bytes, uint16_t capacity);

/// Writes a calibration into an EEPROM image as the device itself would keep it.
void palpate_write_eeprom(const struct palpate_calibration *calibration, uint8_t *eeprom);

#ifdef __cplusplus
}
#endif

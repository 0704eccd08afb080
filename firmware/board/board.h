// SPDX-License-Identifier: BSD-3-Clause
// What the app asks of the board it runs on. Nothing here blocks.
//
// In return the board calls, a thousand times a second, palpate_guard from its tick interrupt and
// palpate_tick when the samples of that tick are there; palpate_receive for each frame that came,
// and palpate_drive when nothing more has come; palpate_start once, before all of these.
#pragma once

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Whatever the board needs to find itself; a microcontroller needs nothing.
struct palpate_board;

/// PWM and direction of one motor: -255..255.
void board_drive(struct palpate_board *board, uint8_t motor, int16_t duty);
/// The enable line of all drivers. Off also takes the PWM of every motor to zero.
void board_enable(struct palpate_board *board, bool on);

/// Keeps palpate_guard out until board_unlock, which gets what board_lock returned.
uint8_t board_lock(struct palpate_board *board);
void board_unlock(struct palpate_board *board, uint8_t was);

/// Room for the PALPATE_WIRE_MAX bytes of the next frame to the host; null when there is none.
uint8_t *board_frame(struct palpate_board *board);
/// Sends the first `count` bytes of what board_frame gave.
void board_send(struct palpate_board *board, uint8_t count);

/// One byte of EEPROM; not to be called while a write runs.
uint8_t board_read_eeprom(struct palpate_board *board, uint16_t address);
/// Begins to write one byte.
void board_write_eeprom(struct palpate_board *board, uint16_t address, uint8_t byte);
/// False while a write runs.
bool board_eeprom_ready(struct palpate_board *board);

/// Something that differs from one call to the next.
uint16_t board_random(struct palpate_board *board);

// What main asks of a microcontroller; a board without main.c has none of these.

/// Pins, timers and converters, everything off and no interrupt yet. Returns the reset's cause, as
/// INFO gives it.
uint8_t board_begin(void);
/// Interrupts and the watchdog on.
void board_go(void);
/// The oldest frame from the host that has come to its end, without its delimiter, until
/// board_free_frame; null when there is none.
const uint8_t *board_next_frame(uint8_t *count);
void board_free_frame(void);
/// True once after bytes were lost.
bool board_take_gap(void);
/// The samples of a tick once they are there, [counts] by joint.
bool board_take_samples(uint16_t *position, uint8_t *buttons);
/// Sleeps until a frame has come to its end, bytes were lost, or samples are there. A main loop
/// that does not come back here, or samples that do not come, let the watchdog reset the board
/// within 16 ms.
void board_wait(void);

/// What INFO says of the hardware.
enum { PALPATE_HARDWARE_ATMEGA328P = 1, PALPATE_HARDWARE_HOST = 2 };
uint8_t board_hardware(struct palpate_board *board);

#ifdef __cplusplus
}
#endif

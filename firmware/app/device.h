// SPDX-License-Identifier: BSD-3-Clause
// The device between its sensors, its motors and the host. Touches no register, so the same code
// runs on the microcontroller, in the host's tests and behind the simulated device.
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "board/board.h"
#include "protocol/calibration.h"
#include "protocol/frame.h"
#include "protocol/messages.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  PALPATE_ADC_BITS = 10,
  PALPATE_COUNTS = 1 << PALPATE_ADC_BITS,
  PALPATE_SAMPLES = 1,         ///< summed into a position
  PALPATE_RAIL_LOW = 8,        ///< [counts] below or
  PALPATE_RAIL_HIGH = 1015,    ///< above: a wire is off, or short
  PALPATE_DUTY_MAX = 230,      ///< bootstrap drivers need some low time
  PALPATE_DUTY_SLEW = 48,      ///< [duty/ms] fastest change of a torque, faults excepted
  PALPATE_HOLD_MS = 5,         ///< a torque is held so long after its command,
  PALPATE_SILENT_MS = 20,      ///< then falls to zero at this age, and past it the host is silent
  PALPATE_RAMP_MS = 500,       ///< from ENABLE to the full torque limit
  PALPATE_LATE_TICKS = 3,      ///< whose work was late, within 100, are a fault
  PALPATE_FAST_STEP = 2,       ///< that a tick of over-speed counts; a calm one takes back 1
  PALPATE_FAST_MOST = 8,       ///< that they may come to: 4 in a row, or every second one for 13
  PALPATE_STUCK_STEP = 4,      ///< [counts] that a joint has to go to have moved
  PALPATE_STUCK_DUTY = 64,     ///< torque from which a joint that stands still is watched
  PALPATE_STUCK_TRAVEL = 512,  ///< [counts] that both others may go meanwhile,
  PALPATE_STUCK_FAR = 8192,    ///< [counts] and one of them alone, as in strokes about its axis
  PALPATE_HOT_MS = 5000,       ///< of torque reduced for heat in a row are a fault
};

/// Pins as palpate_guard gets them.
enum { PALPATE_PIN_STOP = 1, PALPATE_PIN_DRIVER_FAULT = 2 };

/// Bits of reset_cause.
enum { PALPATE_RESET_WATCHDOG = 8 };

/// What of the calibration the device itself lives by.
struct palpate_limits {
  uint8_t speed_max;
  uint8_t deadband[PALPATE_MOTORS];
  uint8_t continuous_duty[PALPATE_MOTORS];
  uint16_t heat_rate;
};

/// A calibration on its way into the EEPROM, a byte at a time.
struct palpate_storing {
  bool active;
  uint8_t step;
  uint8_t seq;   ///< of the message to answer
  uint16_t crc;  ///< of the copy
};

struct palpate_device {
  struct palpate_board *board;

  // shared with palpate_guard, which interrupts everything else
  volatile uint8_t mode;
  volatile uint8_t first_fault;
  volatile uint16_t faults;
  volatile uint16_t tick;
  volatile uint8_t command_age;  ///< [ms]
  volatile uint8_t pins;
  volatile bool working;  ///< the tick's work is not done yet
  volatile uint8_t late;  ///< ticks that found it so, not yet counted

  bool streaming;
  uint8_t buttons, reset_cause, ack;
  uint16_t session;
  uint16_t position[PALPATE_JOINTS];

  struct palpate_command command;
  uint8_t zero_commands;  ///< in a row, up to three
  bool fresh;             ///< a command came that palpate_drive has not seen
  uint8_t worst_age;

  int16_t duty[PALPATE_MOTORS];       ///< applied
  int16_t tick_duty[PALPATE_MOTORS];  ///< applied when this tick's work was done
  bool settled;                       ///< each motor has what its command asked for
  uint8_t ramp_limit;                 ///< [duty] of all motors
  uint16_t ramp;                      ///< [ms] since ENABLE
  uint32_t heat[PALPATE_MOTORS];      ///< [2^-16 duty^2]
  uint8_t heat_turn;                  ///< the motor whose heat comes next
  uint16_t hot_ms;
  uint8_t duty_limit[PALPATE_MOTORS];

  bool sampled, sensor_bad;
  uint8_t fast;                    ///< over-speed so far
  uint16_t place[PALPATE_MOTORS];  ///< [counts] where a joint was last seen to have moved to
  uint16_t rest[PALPATE_MOTORS];   ///< [counts] where it has stood still since
  uint16_t travel[PALPATE_MOTORS][PALPATE_MOTORS];  ///< [counts] that each other has gone meanwhile
  uint8_t overruns_now, overrun_window;
  uint16_t overruns, damaged, refused, gaps;

  uint8_t body[PALPATE_BODY_MAX + 2];  ///< of the message being obeyed
  uint8_t body_count;
  struct palpate_limits limits;
  uint8_t pages[PALPATE_CALIBRATION_BYTES];  ///< what STORE would store
  uint16_t calibration_crc;                  ///< of what is stored; 0: nothing valid
  uint16_t calibration_sequence;
  bool calibrated;
  uint8_t memory;    ///< why it is not: PALPATE_FEATURE_BLANK or _DAMAGED
  bool second_copy;  ///< the newest lies in the second place
  uint32_t serial_number;
  struct palpate_storing storing;
};

/// After a reset: motors off, calibration from the EEPROM, silent until HELLO.
void palpate_start(struct palpate_device *device, struct palpate_board *board, uint8_t reset_cause);

/// The part of a tick that no other work can delay: counts the time, and cuts the motors for an
/// open stop line, a driver's fault, a silent host, or work that has not come back for
/// PALPATE_LATE_TICKS. True if the work of the tick before is done: only then may a board restart
/// its watchdog.
bool palpate_guard(struct palpate_device *device, uint8_t pins);

/// The rest of a tick: checks the samples [counts], moves the motors, reports to the host.
void palpate_tick(struct palpate_device *device, const uint16_t *position, uint8_t buttons);

/// A frame from the host, the bytes before its delimiter; longer than any for one that was broken.
void palpate_receive(struct palpate_device *device, const uint8_t *wire, uint8_t count);
/// Bytes from the host were lost.
void palpate_miss_bytes(struct palpate_device *device);
/// Moves the motors for a command that came since the last call; cheap when there is none.
void palpate_drive(struct palpate_device *device);

/// The one device of a microcontroller, in main.c, for the interrupt that guards it.
extern struct palpate_device palpate_main_device;

#ifdef __cplusplus
}
#endif

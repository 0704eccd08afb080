// SPDX-License-Identifier: BSD-3-Clause
// What the bodies of frames say, as PROTOCOL.md states it: little endian, scaled integers.
// Every palpate_write_* returns the bytes written into a body of PALPATE_BODY_MAX; every
// palpate_read_* returns false, and changes nothing, when type or length is not that message's.
#pragma once

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  PALPATE_PROTOCOL_VERSION = 1,
  PALPATE_JOINTS = 6,  ///< 0..2 arm, 3..5 gimbal
  PALPATE_MOTORS = 3,  ///< on the arm joints
  PALPATE_TICK_HZ = 1000,
  PALPATE_DUTY_FULL = 255,      ///< duty of a torque of full scale
  PALPATE_TORQUE_FULL = 32767,  ///< full scale of a torque on the wire
  PALPATE_FRACTION_BITS = 4,    ///< a count of the local law has this many binary places
  PALPATE_SHIFT_MAX = 8,        ///< largest shift of the local law
};

enum palpate_type {
  // to the device
  PALPATE_HELLO = 0x01,
  PALPATE_COMMAND = 0x02,
  PALPATE_ENABLE = 0x03,
  PALPATE_CLEAR = 0x04,
  PALPATE_READ_PAGE = 0x05,
  PALPATE_WRITE_PAGE = 0x06,
  PALPATE_DISABLE = 0x07,
  PALPATE_STORE = 0x08,
  // from the device
  PALPATE_INFO = 0x81,
  PALPATE_STATE = 0x82,
  PALPATE_ANSWER = 0x83,
  PALPATE_PAGE = 0x85,
};

enum palpate_mode {
  PALPATE_BOOT = 0,  ///< silent until HELLO
  PALPATE_IDLE = 1,  ///< streams; motors off
  PALPATE_RAMP = 2,  ///< torque limit growing to full
  PALPATE_RUN = 3,
  PALPATE_FAULTED = 4,  ///< motors off until CLEAR, which needs the cause gone
};

/// Bit `1 << fault` of palpate_state.faults; the first that cut the motors is first_fault.
enum palpate_fault {
  PALPATE_FAULT_HOST_SILENT = 0,
  PALPATE_FAULT_STOP_PRESSED = 1,
  PALPATE_FAULT_DRIVER = 2,
  PALPATE_FAULT_SENSOR = 3,
  PALPATE_FAULT_OVER_SPEED = 4,
  PALPATE_FAULT_OVERHEATED = 5,  ///< noticed while torque is reduced, then latched
  PALPATE_FAULT_OVERRUN = 6,     ///< noticed each time, latched at 3 within 100 ticks
  PALPATE_FAULT_WATCHDOG = 7,
  PALPATE_NOTICE_BYTES_LOST = 8,  ///< notices never cut the motors
  PALPATE_NOTICE_DAMAGED_FRAME = 9,
  PALPATE_FAULT_CALIBRATION = 10,
  PALPATE_NOTICE_REFUSED = 11,  ///< a message was not understood or not obeyed
  PALPATE_FAULT_NONE = 15,
};

/// The name of a fault or notice in words, for instance "host silent"; "none" for any other number.
const char *palpate_fault_name(uint8_t fault);
/// "boot", "idle", "ramp", "run", "faulted"; "unknown" for any other number.
const char *palpate_mode_name(uint8_t mode);

enum palpate_result {
  PALPATE_DONE = 0,
  PALPATE_UNKNOWN_TYPE = 1,
  PALPATE_WRONG_LENGTH = 2,
  PALPATE_WRONG_VERSION = 3,
  PALPATE_WRONG_MODE = 4,
  PALPATE_WRONG_SESSION = 5,
  PALPATE_NOT_AT_ZERO = 6,    ///< ENABLE needs three commands of zero torque just before it
  PALPATE_CAUSE_REMAINS = 7,  ///< CLEAR while what faulted is still so
  PALPATE_NO_SUCH_PAGE = 8,
  PALPATE_BAD_CALIBRATION = 9,  ///< STORE of pages whose CRC or contents are not right
  PALPATE_BUSY = 10,            ///< the EEPROM is being written
  PALPATE_BAD_VALUE = 11,
  PALPATE_EEPROM_FAILED = 12,  ///< a byte did not read back as it was written
};
/// What a result says in words, for instance "wrong session".
const char *palpate_result_name(uint8_t result);

struct palpate_hello {
  uint8_t seq, version, nonce;
};

/// tau = torque + stiffness (rest - position), each joint torque a 32767th of its full scale.
struct palpate_command {
  uint8_t seq;
  bool has_law;
  uint8_t shift;  ///< 0..8, the law's sum is divided by 2^(shift + 4)
  uint8_t spare;  ///< flag bits that mean nothing yet, and must be zero
  int16_t torque[PALPATE_MOTORS];
  uint16_t rest[PALPATE_MOTORS];  ///< [1/16 count] 0 to the largest position
  int16_t stiffness[6];           ///< symmetric: 00 01 02 11 12 22
};

/// ENABLE and CLEAR name the session that INFO gave, so that no stray frame arms a motor.
struct palpate_order {
  uint8_t seq;
  uint16_t session;
};

struct palpate_info {
  uint8_t seq, version;
  uint8_t release[3];                         ///< of the firmware
  uint8_t hardware;                           ///< 1: ATmega328P, 2: on the host
  uint8_t joints, motors, adc_bits, samples;  ///< a position is a sum of so many samples
  uint8_t duty_max;                           ///< largest duty ever applied
  uint8_t reset_cause;                        ///< bit 0 power, 1 pin, 2 brown-out, 3 watchdog
  uint8_t features;                           ///< bits of PALPATE_FEATURE_*
  uint16_t tick_hz;
  uint16_t calibration_crc;  ///< 0: none
  uint16_t session;
  uint32_t serial_number;
};

enum {
  PALPATE_FEATURE_LAW = 1,
  PALPATE_FEATURE_BLANK = 2,    ///< no calibration was ever stored
  PALPATE_FEATURE_DAMAGED = 4,  ///< the newest calibration does not read back as it was stored
};

/// What palpate_state.aux carries, by seq & 7.
enum palpate_aux {
  PALPATE_AUX_HEAT_0 = 0,  ///< [duty^2] of motor 0, then 1 and 2
  PALPATE_AUX_HEAT_1 = 1,
  PALPATE_AUX_HEAT_2 = 2,
  PALPATE_AUX_DAMAGED = 3,    ///< damaged frames
  PALPATE_AUX_REFUSED = 4,    ///< refused messages
  PALPATE_AUX_OVERRUNS = 5,   ///< ticks whose work was late
  PALPATE_AUX_GAPS = 6,       ///< times that bytes were lost
  PALPATE_AUX_WORST_AGE = 7,  ///< [ms] oldest command obeyed since ENABLE
};

struct palpate_state {
  uint8_t seq;                        ///< low byte of tick
  uint8_t ack;                        ///< seq of the newest command taken
  uint8_t mode;                       ///< enum palpate_mode
  uint8_t buttons;                    ///< bit 0 and 1
  uint16_t tick;                      ///< [ms] since reset, wraps
  uint16_t faults;                    ///< bits by enum palpate_fault, 0..11
  uint8_t first_fault;                ///< enum palpate_fault; PALPATE_FAULT_NONE when none latched
  uint16_t position[PALPATE_JOINTS];  ///< [counts]
  int16_t duty[PALPATE_MOTORS];       ///< really applied, -255..255
  uint16_t aux;                       ///< by enum palpate_aux
};

struct palpate_answer {
  uint8_t seq, type, result;  ///< of the message answered
};

enum { PALPATE_PAGE_BYTES = 16, PALPATE_PAGES = 7 };

/// Sixteen bytes of what calibration.h describes. READ_PAGE carries no bytes.
struct palpate_page {
  uint8_t seq, page;
  uint8_t bytes[PALPATE_PAGE_BYTES];
};

/// STORE takes the pages written before it if their CRC is this one.
struct palpate_store {
  uint8_t seq;
  uint16_t crc;
};

uint8_t palpate_write_hello(const struct palpate_hello *hello, uint8_t *body);
uint8_t palpate_write_command(const struct palpate_command *command, uint8_t *body);
uint8_t palpate_write_order(uint8_t type, const struct palpate_order *order, uint8_t *body);
uint8_t palpate_write_disable(uint8_t seq, uint8_t *body);
uint8_t palpate_write_read_page(uint8_t seq, uint8_t page, uint8_t *body);
uint8_t palpate_write_page(uint8_t type, const struct palpate_page *page, uint8_t *body);
uint8_t palpate_write_store(const struct palpate_store *store, uint8_t *body);
uint8_t palpate_write_info(const struct palpate_info *info, uint8_t *body);
uint8_t palpate_write_state(const struct palpate_state *state, uint8_t *body);
uint8_t palpate_write_answer(const struct palpate_answer *answer, uint8_t *body);

bool palpate_read_hello(const uint8_t *body, uint8_t count, struct palpate_hello *hello);
bool palpate_read_command(const uint8_t *body, uint8_t count, struct palpate_command *command);
bool palpate_read_order(const uint8_t *body, uint8_t count, uint8_t type,
                        struct palpate_order *order);
bool palpate_read_read_page(const uint8_t *body, uint8_t count, uint8_t *seq, uint8_t *page);
bool palpate_read_page(const uint8_t *body, uint8_t count, uint8_t type, struct palpate_page *page);
bool palpate_read_store(const uint8_t *body, uint8_t count, struct palpate_store *store);
bool palpate_read_info(const uint8_t *body, uint8_t count, struct palpate_info *info);
bool palpate_read_state(const uint8_t *body, uint8_t count, struct palpate_state *state);
bool palpate_read_answer(const uint8_t *body, uint8_t count, struct palpate_answer *answer);

#ifdef __cplusplus
}
#endif

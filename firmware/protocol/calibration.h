// SPDX-License-Identifier: BSD-3-Clause
// What a device knows of itself, kept in its EEPROM and sent as seven pages: what its sensors and
// motors mean in radians and newton metres, and what its motors can bear.
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "protocol/messages.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  PALPATE_CALIBRATION_VERSION = 1,
  PALPATE_CALIBRATION_BYTES = PALPATE_PAGES * PALPATE_PAGE_BYTES,
};

struct palpate_joint_calibration {
  uint16_t zero;       ///< [counts] at angle zero
  int32_t scale_nrad;  ///< [nrad/count], its sign is the direction; not 0
  uint16_t min, max;   ///< [counts] ends of the range, min < max
};

struct palpate_calibration {
  uint8_t speed_max;  ///< [counts/ms] of an arm joint, at least 1
  struct palpate_joint_calibration joint[PALPATE_JOINTS];
  uint32_t link_um[2];                      ///< [um] of the two arm links, not 0
  int32_t torque_uNm[PALPATE_MOTORS];       ///< [uN m] of the joint at full duty, signed; not 0
  int32_t gravity_uNm[2];                   ///< [uN m] G1 = g0 cos q1 and G2 = g1 sin q2
  uint8_t deadband[PALPATE_MOTORS];         ///< [duty] at which the motor begins to push, < 64
  uint8_t continuous_duty[PALPATE_MOTORS];  ///< duty that may be held forever, at least 1
  uint16_t heat_rate;                       ///< [2^-20 per ms] 1 / time constant, 1..32767
  uint32_t serial_number;
};

/// Writes the PALPATE_CALIBRATION_BYTES of a calibration.
void palpate_write_calibration(const struct palpate_calibration *calibration, uint8_t *bytes);
/// False when a number is outside what its field states; `calibration` is then half written.
bool palpate_read_calibration(const uint8_t *bytes, struct palpate_calibration *calibration);

#ifdef __cplusplus
}
#endif

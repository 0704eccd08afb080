// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/calibration.h"

#include <string.h>

#include "protocol/bytes.h"

void palpate_write_calibration(const struct palpate_calibration *calibration, uint8_t *bytes) {
  memset(bytes, 0, PALPATE_CALIBRATION_BYTES);
  uint8_t *at = bytes;
  *at++ = PALPATE_CALIBRATION_VERSION;
  *at++ = calibration->speed_max;
  for (uint8_t j = 0; j < PALPATE_JOINTS; j++) {
    const struct palpate_joint_calibration *joint = &calibration->joint[j];
    at = put_16(at, joint->zero);
    at = put_32(at, (uint32_t)joint->scale_nrad);
    at = put_16(at, joint->min);
    at = put_16(at, joint->max);
  }
  for (uint8_t l = 0; l < 2; l++) at = put_32(at, calibration->link_um[l]);
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++)
    at = put_32(at, (uint32_t)calibration->torque_uNm[m]);
  for (uint8_t l = 0; l < 2; l++) at = put_32(at, (uint32_t)calibration->gravity_uNm[l]);
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) *at++ = calibration->deadband[m];
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) *at++ = calibration->continuous_duty[m];
  at = put_16(at, calibration->heat_rate);
  put_32(at, calibration->serial_number);
}

static bool is_valid(const struct palpate_calibration *c) {
  for (uint8_t j = 0; j < PALPATE_JOINTS; j++) {
    if (c->joint[j].scale_nrad == 0 || c->joint[j].min >= c->joint[j].max) return false;
  }
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) {
    if (c->torque_uNm[m] == 0 || c->deadband[m] >= 64 || c->continuous_duty[m] == 0) return false;
  }
  return c->speed_max > 0 && c->link_um[0] > 0 && c->link_um[1] > 0 && c->heat_rate > 0 &&
         c->heat_rate <= 32767;
}

bool palpate_read_calibration(const uint8_t *bytes, struct palpate_calibration *calibration) {
  const uint8_t *at = bytes + 2;
  calibration->speed_max = bytes[1];
  for (uint8_t j = 0; j < PALPATE_JOINTS; j++) {
    struct palpate_joint_calibration *joint = &calibration->joint[j];
    joint->zero = take_16(&at);
    joint->scale_nrad = (int32_t)take_32(&at);
    joint->min = take_16(&at);
    joint->max = take_16(&at);
  }
  for (uint8_t l = 0; l < 2; l++) calibration->link_um[l] = take_32(&at);
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) calibration->torque_uNm[m] = (int32_t)take_32(&at);
  for (uint8_t l = 0; l < 2; l++) calibration->gravity_uNm[l] = (int32_t)take_32(&at);
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) calibration->deadband[m] = *at++;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) calibration->continuous_duty[m] = *at++;
  calibration->heat_rate = take_16(&at);
  calibration->serial_number = take_32(&at);
  return bytes[0] == PALPATE_CALIBRATION_VERSION && is_valid(calibration);
}

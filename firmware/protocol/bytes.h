// SPDX-License-Identifier: BSD-3-Clause
// Little-endian numbers in a body, whatever the machine's own order is.
#pragma once

#include <stdint.h>

static inline uint8_t *put_16(uint8_t *at, uint16_t value) {
  at[0] = (uint8_t)value;
  at[1] = (uint8_t)(value >> 8);
  return at + 2;
}

static inline uint8_t *put_32(uint8_t *at, uint32_t value) {
  return put_16(put_16(at, (uint16_t)value), (uint16_t)(value >> 16));
}

static inline uint16_t take_16(const uint8_t **at) {
  uint16_t value = (uint16_t)((*at)[0] | (uint16_t)(*at)[1] << 8);
  *at += 2;
  return value;
}

static inline uint32_t take_32(const uint8_t **at) {
  uint32_t low = take_16(at);
  return low | (uint32_t)take_16(at) << 16;
}

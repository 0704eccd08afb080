// SPDX-License-Identifier: BSD-3-Clause
// Frames on the wire: COBS(body crc16) 0x00, as PROTOCOL.md states them. Plain C11, no allocation:
// the microcontroller, the host and the tests compile this one source.
#pragma once

#include <stdbool.h>
#include <stdint.h>

#ifdef __AVR__
#include <util/crc16.h>
#endif

#ifdef __cplusplus
extern "C" {
#endif

enum {
  PALPATE_BODY_MAX = 32,                    ///< longest body of a frame [bytes], without its CRC
  PALPATE_WIRE_MAX = PALPATE_BODY_MAX + 4,  ///< longest frame on the wire, with its delimiter
};

/// CRC-16/MCRF4XX (polynomial 0x1021 reflected, start 0xffff) with one more byte.
static inline uint16_t palpate_update_crc(uint16_t crc, uint8_t byte) {
#ifdef __AVR__
  return _crc_ccitt_update(crc, byte);  // the same in half the cycles
#endif
  byte ^= (uint8_t)crc;
  byte ^= (uint8_t)(byte << 4);
  return (uint16_t)(((uint16_t)byte << 8 | crc >> 8) ^ (uint8_t)(byte >> 4) ^ (uint16_t)byte << 3);
}

/// The CRC of `count` bytes.
uint16_t palpate_compute_crc(const uint8_t *bytes, uint16_t count);

/// Writes a body of 1..PALPATE_BODY_MAX bytes as one frame with CRC and delimiter; `wire` has room
/// for PALPATE_WIRE_MAX bytes. Returns how many were written.
uint8_t palpate_encode_frame(const uint8_t *body, uint8_t count, uint8_t *wire);

/// The body in the `count` bytes of a frame before its delimiter, unstuffed and checked; `body` has
/// room for PALPATE_BODY_MAX + 2 bytes. Returns its length, 0 for a frame that is too long, too
/// short, badly stuffed or fails its CRC.
uint8_t palpate_decode_frame(const uint8_t *wire, uint8_t count, uint8_t *body);

enum palpate_decoded {
  PALPATE_NOTHING_YET,
  PALPATE_FRAME,    ///< a whole frame with a good CRC is in body[0..count)
  PALPATE_DAMAGED,  ///< a frame ended that is none
};

/// A stream of bytes on its way to frames. It finds the next whole frame after any loss.
struct palpate_decoder {
  uint8_t wire[PALPATE_WIRE_MAX];
  uint8_t wire_count;  ///< PALPATE_WIRE_MAX: too long, or skipping to the next delimiter
  uint8_t body[PALPATE_BODY_MAX + 2];
  uint8_t count;  ///< bytes of the body
};

/// Ready for a stream that begins with a frame. After lost bytes begin with
/// palpate_skip_to_delimiter instead, so half a frame is never taken for a whole one.
void palpate_start_decoder(struct palpate_decoder *decoder);
void palpate_skip_to_delimiter(struct palpate_decoder *decoder);

/// One byte of the stream. After PALPATE_FRAME the body stays valid until the next frame ends.
enum palpate_decoded palpate_decode_byte(struct palpate_decoder *decoder, uint8_t byte);

#ifdef __cplusplus
}
#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/frame.h"

uint16_t palpate_compute_crc(const uint8_t *bytes, uint16_t count) {
  uint16_t crc = 0xffff;
  while (count--) crc = palpate_update_crc(crc, *bytes++);
  return crc;
}

// Consistent overhead byte stuffing: each zero of the body becomes the distance to the next, so
// zero can end the frame. A body this short never needs a code of 255.
uint8_t palpate_encode_frame(const uint8_t *body, uint8_t count, uint8_t *wire) {
  uint16_t crc = 0xffff;
  uint8_t *code = wire;
  uint8_t *out = wire + 1;
  for (uint8_t i = 0; i < count + 2; i++) {
    uint8_t byte;
    if (i < count) {
      byte = body[i];
      crc = palpate_update_crc(crc, byte);
    } else {
      byte = (uint8_t)crc;
      crc >>= 8;
    }
    if (byte) {
      *out++ = byte;
    } else {
      *code = (uint8_t)(out - code);
      code = out++;
    }
  }
  *code = (uint8_t)(out - code);
  *out++ = 0;
  return (uint8_t)(out - wire);
}

// The CRC of a body followed by its own CRC, low byte first, is zero.
uint8_t palpate_decode_frame(const uint8_t *wire, uint8_t count, uint8_t *body) {
  if (count < 4 || count >= PALPATE_WIRE_MAX) return 0;
  uint16_t crc = 0xffff;
  uint8_t *out = body;
  uint8_t left = *wire;  // bytes until the next zero of the body, this code included
  for (uint8_t i = 1; i < count; i++) {
    uint8_t byte = wire[i];
    if (--left == 0) {
      left = byte;
      byte = 0;
    }
    *out++ = byte;
    crc = palpate_update_crc(crc, byte);
  }
  if (left != 1 || crc != 0) return 0;
  return (uint8_t)(count - 3);
}

void palpate_start_decoder(struct palpate_decoder *decoder) { decoder->wire_count = 0; }

void palpate_skip_to_delimiter(struct palpate_decoder *decoder) {
  decoder->wire_count = PALPATE_WIRE_MAX;
}

enum palpate_decoded palpate_decode_byte(struct palpate_decoder *decoder, uint8_t byte) {
  if (byte != 0) {
    if (decoder->wire_count < PALPATE_WIRE_MAX) decoder->wire[decoder->wire_count++] = byte;
    return PALPATE_NOTHING_YET;
  }
  uint8_t count = decoder->wire_count;
  decoder->wire_count = 0;
  if (count == 0) return PALPATE_NOTHING_YET;  // delimiters in a row are silence
  decoder->count = palpate_decode_frame(decoder->wire, count, decoder->body);
  return decoder->count ? PALPATE_FRAME : PALPATE_DAMAGED;
}

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

static void begin_frame(struct palpate_decoder *decoder) {
  decoder->count = 0;
  decoder->left = 0;
  decoder->code = 0xff;
  decoder->crc = 0xffff;
  decoder->broken = false;
}

void palpate_start_decoder(struct palpate_decoder *decoder) {
  begin_frame(decoder);
  decoder->ended = true;
}

void palpate_skip_to_delimiter(struct palpate_decoder *decoder) {
  begin_frame(decoder);
  decoder->broken = true;
  decoder->ended = false;
}

static inline void append(struct palpate_decoder *decoder, uint8_t byte) {
  if (decoder->count == sizeof decoder->body) {
    decoder->broken = true;
    return;
  }
  decoder->body[decoder->count++] = byte;
  decoder->crc = palpate_update_crc(decoder->crc, byte);
}

// The CRC of a body followed by its own CRC, low byte first, is zero.
static enum palpate_decoded end_frame(struct palpate_decoder *decoder) {
  if (decoder->ended) return PALPATE_NOTHING_YET;  // delimiters in a row are silence
  bool good = !decoder->broken && decoder->left == 0 && decoder->count > 2 && decoder->crc == 0;
  uint8_t count = (uint8_t)(decoder->count - 2);
  begin_frame(decoder);
  decoder->ended = true;
  if (!good) return PALPATE_DAMAGED;
  decoder->count = count;
  return PALPATE_FRAME;
}

enum palpate_decoded palpate_decode_byte(struct palpate_decoder *decoder, uint8_t byte) {
  if (byte == 0) return end_frame(decoder);
  if (decoder->ended) {
    decoder->ended = false;
    decoder->count = 0;
  }
  if (decoder->broken) return PALPATE_NOTHING_YET;
  if (decoder->left) {
    decoder->left--;
    append(decoder, byte);
  } else {
    // a code ends the run before it with a zero, except the first one, which has no run before it
    if (decoder->code != 0xff) append(decoder, 0);
    decoder->code = byte;
    decoder->left = (uint8_t)(byte - 1);
  }
  return PALPATE_NOTHING_YET;
}

// SPDX-License-Identifier: BSD-3-Clause
// Frames in and out of the ATmega328P's UART, by interrupt.
#include <avr/interrupt.h>
#include <avr/io.h>

#include "app/device.h"
#include "board/atmega328p.h"

// bytes of frames in a tick, and deaf after: more would make it late
enum { RECEIVE_BUDGET = 36 };

// Four frames on their way in and four on their way out, each at a multiple of 64, so that one
// byte says frame and offset and wraps by itself. What an interrupt touches for every byte stands
// in general purpose registers, which cost it one cycle instead of two.
enum { PLACE = 0xc0, OFFSET = 0x3f, STEP = 0x40 };
#define received_at GPIOR1  // where the next byte goes
#define sent_at GPIOR2      // where the next byte is

static uint8_t received[256];  // a frame's last place keeps its length
static volatile uint8_t oldest_frame;
static volatile bool gap;              // bytes were lost
static volatile bool deaf;             // until the next tick
static volatile uint8_t received_now;  // bytes of frames in this tick
static uint8_t sent[256];
static volatile uint8_t queued_frame;  // the place being written

// A frame that is too long or broken stays at the longest length until its delimiter.
ISR(USART_RX_vect) {
  uint8_t status = UCSR0A;
  uint8_t byte = UDR0;
  uint8_t at = received_at;
  uint8_t count = at & OFFSET;
  if (status & (_BV(FE0) | _BV(DOR0))) {
    gap = true;
    received_at = (at & PLACE) | PALPATE_WIRE_MAX;
  } else if (byte) {
    if (count == PALPATE_WIRE_MAX) return;
    received[at] = byte;
    received_at = at + 1;
  } else if (count) {  // delimiters in a row are silence
    received[at | OFFSET] = count;
    at = (at & PLACE) + STEP;
    if (at == oldest_frame) {  // no place is free: the frame is dropped
      gap = true;
      at -= STEP;
    }
    received_at = at;
    work = 1;
  }
}

const uint8_t *board_next_frame(uint8_t *count) {
  uint8_t frame = oldest_frame;
  if (frame == (received_at & PLACE)) return 0;
  *count = received[frame | OFFSET];
  return received + frame;
}

void board_free_frame(void) {
  uint8_t frame = oldest_frame;
  uint8_t count = received[frame | OFFSET];
  uint8_t cost = count < PALPATE_WIRE_MAX ? count + 1 : 0;  // a broken one costs nothing
  oldest_frame = frame + STEP;
  // the tick's interrupt forgets what was heard: what it forgot must not come back
  uint8_t was = board_lock(0);
  uint8_t now = received_now + cost;
  received_now = now;
  if (now > RECEIVE_BUDGET && !deaf) {
    deaf = true;
    UCSR0B &= (uint8_t)~_BV(RXCIE0);
  }
  board_unlock(0, was);
}

// If bytes came while nobody heard them, the frame they belong to is broken.
void hear_again(void) {
  received_now = 0;
  if (!deaf) return;
  deaf = false;
  if (UCSR0A & _BV(RXC0)) {
    for (uint8_t held = 3; held && (UCSR0A & _BV(RXC0)); held--) (void)UDR0;
    gap = true;
    work = 1;
    received_at = (received_at & PLACE) | PALPATE_WIRE_MAX;
  }
  UCSR0B |= _BV(RXCIE0);
}

bool board_take_gap(void) {
  if (!gap) return false;
  gap = false;
  return true;
}

// Every interrupt sends a byte, the last one ends them: some emulators forget an empty one.
ISR(USART_UDRE_vect) {
  uint8_t at = sent_at;
  uint8_t byte = sent[at];
  UDR0 = byte;
  at++;
  if (byte == 0) {
    at = (at & PLACE) + STEP;
    if (at == queued_frame) UCSR0B &= (uint8_t)~_BV(UDRIE0);
  }
  sent_at = at;
}

uint8_t *board_frame(struct palpate_board *board) {
  (void)board;
  uint8_t frame = queued_frame;
  return (uint8_t)(frame + STEP) == (sent_at & PLACE) ? 0 : sent + frame;
}

void board_send(struct palpate_board *board, uint8_t count) {
  (void)count;
  uint8_t was = board_lock(board);
  queued_frame += STEP;
  UCSR0B |= _BV(UDRIE0);
  board_unlock(board, was);
}

// SPDX-License-Identifier: BSD-3-Clause
// ATmega328P at 16 MHz: an Uno or a Nano. The pins stand in firmware/README.md.
//
// Timer 0 makes the tick, timers 1 and 2 the PWM. The tick's interrupt starts a chain of six
// conversions and guards the motors; bytes come and go by interrupt; the rest is the main loop's.
#include "board/atmega328p.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

#include "app/device.h"

#ifndef PALPATE_BAUD
#define PALPATE_BAUD 1000000
#endif

enum {
  PIN_STOP = _BV(2),          // PD2, open is high
  PIN_ENABLE = _BV(5),        // PD5
  PIN_FAULT = _BV(6),         // PD6, fault is low
  DIR_1 = _BV(4),             // PD4
  DIR_2 = _BV(7),             // PD7
  DIR_3 = _BV(0),             // PB0
  PWM_3 = _BV(3),             // PD3, OC2B
  PWM_1_2 = _BV(1) | _BV(2),  // PB1 OC1A, PB2 OC1B
  BUTTONS = _BV(3) | _BV(4),  // PB3 and PB4, pressed is low
  TX = _BV(1),                // PD1
};

// --- samples ---

static uint16_t samples[2][PALPATE_JOINTS];
static uint16_t *volatile filling = samples[0];
static uint16_t *volatile filled = samples[1];
static uint8_t channel;
static volatile bool sampled;

// Two buffers change places, so this interrupt is short: a byte arrives every 160 cycles.
ISR(ADC_vect) {
  uint16_t value = ADC;  // before the multiplexer moves on
  uint8_t c = channel;
  filling[c] = value;
  if (++c == PALPATE_JOINTS) {
    uint16_t *full = filling;
    filling = filled;
    filled = full;
    c = 0;
    sampled = true;
    work = 1;
    ADMUX = _BV(REFS0);
  } else {
    ADMUX = _BV(REFS0) | c;
    ADCSRA |= _BV(ADSC);
  }
  channel = c;
}

bool board_take_samples(uint16_t *position, uint8_t *buttons) {
  if (!sampled) return false;
  sampled = false;
  const uint16_t *from = filled;
  for (uint8_t j = 0; j < PALPATE_JOINTS; j++) position[j] = from[j];
  *buttons = (uint8_t)(~PINB & BUTTONS) >> 3;
  return true;
}

// --- the tick ---

static volatile bool turned;

ISR(TIMER0_COMPA_vect) {
  if (!(ADCSRA & _BV(ADSC))) ADCSRA |= _BV(ADSC);
  uint8_t in = PIND;
  uint8_t pins = 0;
  if (in & PIN_STOP) pins |= PALPATE_PIN_STOP;
  if (!(in & PIN_FAULT)) pins |= PALPATE_PIN_DRIVER_FAULT;
  bool done = palpate_guard(&palpate_main_device, pins);
  hear_again();
  // the main loop has to turn and the tick's work to be done: samples that stay away end here too
  if (turned && done) {
    turned = false;
    wdt_reset();
  }
}

void board_wait(void) {
  turned = true;
  sleep_enable();
  for (;;) {
    cli();
    if (work) break;
    sei();  // takes effect after the next instruction, so nothing can come between
    sleep_cpu();
    // the emulator serves a pending interrupt one instruction later than the chip does
    __asm__ volatile("nop");
  }
  work = 0;
  sei();
}

uint8_t board_lock(struct palpate_board *board) {
  (void)board;
  uint8_t was = SREG;
  cli();
  return was;
}

void board_unlock(struct palpate_board *board, uint8_t was) {
  (void)board;
  SREG = was;
}

// --- motors ---

static inline void set_pin(volatile uint8_t *port, uint8_t pin, bool high) {
  if (high) {
    *port |= pin;
  } else {
    *port &= (uint8_t)~pin;
  }
}

// The direction changes at once, the PWM at its next crest, 32 us at most: near zero duty, as the
// slew limit has it, nothing is felt.
void board_drive(struct palpate_board *board, uint8_t motor, int16_t duty) {
  (void)board;
  bool back = duty < 0;
  uint8_t size = (uint8_t)(back ? -duty : duty);
  if (motor == 0) {
    set_pin(&PORTD, DIR_1, back);
    OCR1A = size;
  } else if (motor == 1) {
    set_pin(&PORTD, DIR_2, back);
    OCR1B = size;
  } else {
    set_pin(&PORTB, DIR_3, back);
    OCR2B = size;
  }
}

void board_enable(struct palpate_board *board, bool on) {
  (void)board;
  if (on) {
    PORTD |= PIN_ENABLE;
    return;
  }
  PORTD &= (uint8_t)~PIN_ENABLE;
  OCR1A = 0;
  OCR1B = 0;
  OCR2B = 0;
}

// --- EEPROM ---

bool board_eeprom_ready(struct palpate_board *board) {
  (void)board;
  return !(EECR & _BV(EEPE));
}

uint8_t board_read_eeprom(struct palpate_board *board, uint16_t address) {
  (void)board;
  EEAR = address;
  EECR |= _BV(EERE);
  return EEDR;
}

void board_write_eeprom(struct palpate_board *board, uint16_t address, uint8_t byte) {
  EEAR = address;
  EEDR = byte;
  uint8_t was = board_lock(board);
  EECR |= _BV(EEMPE);  // and within four cycles
  EECR |= _BV(EEPE);
  board_unlock(board, was);
}

// --- power ---

static uint8_t reset_cause __attribute__((section(".noinit")));

// Before anything else: after its reset the watchdog goes on, at its shortest time.
void palpate_stop_watchdog(void) __attribute__((naked, used, section(".init3")));
void palpate_stop_watchdog(void) {
  reset_cause = MCUSR;
  MCUSR = 0;
  wdt_disable();
}

uint16_t board_random(struct palpate_board *board) {
  (void)board;
  return (uint16_t)(palpate_main_device.tick << 8) ^ (uint16_t)(TCNT0 << 4) ^ samples[0][0];
}

uint8_t board_hardware(struct palpate_board *board) {
  (void)board;
  return PALPATE_HARDWARE_ATMEGA328P;
}

uint8_t board_begin(void) {
  // a write that was under way goes on through a reset, for 3.4 ms at most
  while (EECR & _BV(EEPE)) {
  }
  PORTD = PIN_STOP | PIN_FAULT;  // pull-ups; everything else low
  PORTB = BUTTONS;
  DDRD = TX | PWM_3 | DIR_1 | PIN_ENABLE | DIR_2;
  DDRB = DIR_3 | PWM_1_2;

  // 8-bit phase-correct PWM without prescaler on all three motors: 31.37 kHz
  TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(WGM10);
  TCCR1B = _BV(CS10);
  TCCR2A = _BV(COM2B1) | _BV(WGM20);
  TCCR2B = _BV(CS20);
  // 16 MHz / 64 / 250 = 1 kHz
  TCCR0A = _BV(WGM01);
  OCR0A = 249;
  TCCR0B = _BV(CS01) | _BV(CS00);

  UBRR0 = F_CPU / 16 / PALPATE_BAUD - 1;
  UCSR0A = 0;
  UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
  UCSR0B = _BV(RXEN0) | _BV(TXEN0) | _BV(RXCIE0);

  DIDR0 = 0x3f;
  ADMUX = _BV(REFS0);
  ADCSRA = _BV(ADEN) | _BV(ADIE) | _BV(ADPS2) | _BV(ADPS1);  // 250 kHz: 52 us a sample
  set_sleep_mode(SLEEP_MODE_IDLE);
  return reset_cause & 15;
}

void board_go(void) {
  TIMSK0 = _BV(OCIE0A);
  wdt_enable(WDTO_15MS);
  sei();
}

// SPDX-License-Identifier: BSD-3-Clause
#include "board/host.h"

#include <string.h>

#include "app/parts.h"

void board_drive(struct palpate_board *board, uint8_t motor, int16_t duty) {
  board->duty[motor] = duty;
}

void board_enable(struct palpate_board *board, bool on) {
  board->enabled = on;
  if (!on) memset(board->duty, 0, sizeof board->duty);
}

// Guard and tick are called one after the other here; neither interrupts.
uint8_t board_lock(struct palpate_board *board) {
  (void)board;
  return 0;
}

void board_unlock(struct palpate_board *board, uint8_t was) {
  (void)board;
  (void)was;
}

uint8_t *board_frame(struct palpate_board *board) {
  if (board->to_host_count + PALPATE_WIRE_MAX > PALPATE_SEND_BYTES) return NULL;
  return board->to_host + board->to_host_count;
}

void board_send(struct palpate_board *board, uint8_t count) {
  board->to_host_count = (uint16_t)(board->to_host_count + count);
}

uint8_t board_read_eeprom(struct palpate_board *board, uint16_t address) {
  return board->eeprom[address % PALPATE_EEPROM_BYTES];
}

void board_write_eeprom(struct palpate_board *board, uint16_t address, uint8_t byte) {
  board->eeprom_busy = 4;  // 3.4 ms on the ATmega328P
  if (board->eeprom_strength == 0) return;
  if (board->eeprom_strength > 0) board->eeprom_strength--;
  board->eeprom[address % PALPATE_EEPROM_BYTES] = byte;
}

bool board_eeprom_ready(struct palpate_board *board) { return board->eeprom_busy == 0; }

uint16_t board_random(struct palpate_board *board) { return board->device.tick; }

uint8_t board_hardware(struct palpate_board *board) {
  (void)board;
  return PALPATE_HARDWARE_HOST;
}

void palpate_board_init(struct palpate_board *board, const uint8_t *eeprom) {
  memset(board, 0, sizeof *board);
  memset(board->eeprom, 0xff, sizeof board->eeprom);
  if (eeprom) memcpy(board->eeprom, eeprom, sizeof board->eeprom);
  board->eeprom_strength = -1;
  for (int j = 0; j < PALPATE_JOINTS; j++) board->adc[j] = 512;
  palpate_board_reset(board, 1);
}

void palpate_board_reset(struct palpate_board *board, uint8_t cause) {
  board->to_host_count = 0;
  board->received_now = 0;
  board->from_host_count = 0;
  board->deaf = false;
  board->eeprom_busy = 0;
  board->undone = 0;
  palpate_start(&board->device, board, cause);
}

static void end_frame(struct palpate_board *board) {
  uint8_t count = board->from_host_count;
  board->from_host_count = 0;
  if (count == 0) return;  // delimiters in a row are silence
  palpate_receive(&board->device, board->from_host, count);
  if (count == PALPATE_WIRE_MAX) return;  // a broken one costs nothing
  board->received_now = (uint8_t)(board->received_now + count + 1);
  board->deaf = board->received_now > PALPATE_RECEIVE_BYTES;
}

void palpate_board_receive(struct palpate_board *board, const uint8_t *bytes, uint16_t count) {
  for (uint16_t i = 0; i < count; i++) {
    if (board->deaf) {
      board->from_host_count = PALPATE_WIRE_MAX;
    } else if (bytes[i] == 0) {
      end_frame(board);
    } else if (board->from_host_count < PALPATE_WIRE_MAX) {
      board->from_host[board->from_host_count++] = bytes[i];
    }
  }
  palpate_drive(&board->device);
}

void palpate_board_tick(struct palpate_board *board) {
  struct palpate_device *device = &board->device;
  if (board->eeprom_busy) board->eeprom_busy--;
  uint8_t pins = (board->stop_open ? PALPATE_PIN_STOP : 0) |
                 (board->driver_fault ? PALPATE_PIN_DRIVER_FAULT : 0);
  board->undone = palpate_guard(device, pins) ? 0 : (uint8_t)(board->undone + 1);
  if (board->undone >= PALPATE_WATCHDOG_MS) {
    palpate_board_reset(board, PALPATE_RESET_WATCHDOG);
    return;
  }
  // deaf, but nothing was said: nothing is lost
  if (board->deaf && board->from_host_count) palpate_miss_bytes(device);
  board->deaf = false;
  board->received_now = 0;
  if (!board->adc_stopped) palpate_tick(device, board->adc, board->buttons);
}

uint16_t palpate_board_take(struct palpate_board *board, uint8_t *bytes, uint16_t capacity) {
  uint16_t count = board->to_host_count < capacity ? board->to_host_count : capacity;
  memcpy(bytes, board->to_host, count);
  board->to_host_count = (uint16_t)(board->to_host_count - count);
  memmove(board->to_host, board->to_host + count, board->to_host_count);
  return count;
}

void palpate_write_eeprom(const struct palpate_calibration *calibration, uint8_t *eeprom) {
  memset(eeprom, 0xff, PALPATE_EEPROM_BYTES);
  uint8_t pages[PALPATE_CALIBRATION_BYTES];
  palpate_write_calibration(calibration, pages);
  // the device itself writes it: there is one description of its EEPROM
  struct palpate_board board;
  palpate_board_init(&board, eeprom);
  memcpy(board.device.pages, pages, sizeof pages);
  struct palpate_store store = {.crc = palpate_compute_crc(pages, sizeof pages)};
  palpate_begin_store(&board.device, &store);
  while (board.device.storing.active) palpate_board_tick(&board);
  memcpy(eeprom, board.eeprom, PALPATE_EEPROM_BYTES);
}

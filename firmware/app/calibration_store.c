// SPDX-License-Identifier: BSD-3-Clause
// The calibration in two places of the EEPROM: the older is overwritten, and counts only once its
// mark, written last, stands. Power may fail at any byte.
#include "app/parts.h"
#include "protocol/bytes.h"

// A copy: mark, sequence, crc of sequence and pages, pages.
enum {
  MARK = 0x4350,
  NO_MARK = 0xffff,
  HEAD_BYTES = 6,
  COPY_BYTES = HEAD_BYTES + PALPATE_CALIBRATION_BYTES,
  SECOND_COPY = 512,
  MARK_BYTES = 2,
  STEPS = MARK_BYTES + (COPY_BYTES - MARK_BYTES) + MARK_BYTES,
};

static uint16_t read_16(struct palpate_device *device, uint16_t address) {
  uint8_t low = board_read_eeprom(device->board, address);
  return (uint16_t)(low | (uint16_t)board_read_eeprom(device->board, address + 1) << 8);
}

static uint16_t start_crc(uint16_t sequence) {
  uint16_t crc = palpate_update_crc(0xffff, (uint8_t)sequence);
  return palpate_update_crc(crc, (uint8_t)(sequence >> 8));
}

static bool is_whole(struct palpate_device *device, uint16_t at) {
  if (read_16(device, at) != MARK) return false;
  uint16_t crc = start_crc(read_16(device, at + 2));
  for (uint8_t b = 0; b < PALPATE_CALIBRATION_BYTES; b++) {
    crc =
        palpate_update_crc(crc, board_read_eeprom(device->board, (uint16_t)(at + HEAD_BYTES + b)));
  }
  return crc == read_16(device, at + 4);
}

// Takes over what the pages say; false when it makes no sense.
static bool adopt(struct palpate_device *device) {
  struct palpate_calibration calibration;
  if (!palpate_read_calibration(device->pages, &calibration)) return false;
  struct palpate_limits *limits = &device->limits;
  limits->speed_max = calibration.speed_max;
  limits->heat_rate = calibration.heat_rate;
  for (uint8_t m = 0; m < PALPATE_MOTORS; m++) {
    limits->deadband[m] = calibration.deadband[m];
    limits->continuous_duty[m] = calibration.continuous_duty[m];
  }
  device->serial_number = calibration.serial_number;
  device->calibration_crc = palpate_compute_crc(device->pages, PALPATE_CALIBRATION_BYTES);
  device->calibrated = true;
  return true;
}

void palpate_load_calibration(struct palpate_device *device) {
  bool first = is_whole(device, 0);
  bool second = is_whole(device, SECOND_COPY);
  if (first && second) {
    second = (int16_t)(read_16(device, SECOND_COPY + 2) - read_16(device, 2)) > 0;
  }
  if (first || second) {
    uint16_t at = second ? SECOND_COPY : 0;
    device->second_copy = second;
    device->calibration_sequence = read_16(device, at + 2);
    for (uint8_t b = 0; b < PALPATE_CALIBRATION_BYTES; b++) {
      device->pages[b] = board_read_eeprom(device->board, (uint16_t)(at + HEAD_BYTES + b));
    }
    if (adopt(device)) return;
  }
  palpate_cut(device, PALPATE_FAULT_CALIBRATION);
}

uint8_t palpate_begin_store(struct palpate_device *device, const struct palpate_store *store) {
  if (device->storing.active) return PALPATE_BUSY;
  struct palpate_calibration calibration;
  if (palpate_compute_crc(device->pages, PALPATE_CALIBRATION_BYTES) != store->crc ||
      !palpate_read_calibration(device->pages, &calibration)) {
    return PALPATE_BAD_CALIBRATION;
  }
  device->storing = (struct palpate_storing){.active = true, .seq = store->seq};
  uint16_t crc = start_crc((uint16_t)(device->calibration_sequence + 1));
  for (uint8_t b = 0; b < PALPATE_CALIBRATION_BYTES; b++) {
    crc = palpate_update_crc(crc, device->pages[b]);
  }
  device->storing.crc = crc;
  return PALPATE_DONE;
}

// The byte at an offset of the copy being written.
static uint8_t find_byte(const struct palpate_device *device, uint8_t offset) {
  if (offset >= HEAD_BYTES) return device->pages[offset - HEAD_BYTES];
  uint8_t head[HEAD_BYTES];
  uint8_t *at = put_16(head, MARK);
  at = put_16(at, (uint16_t)(device->calibration_sequence + 1));
  put_16(at, device->storing.crc);
  return head[offset];
}

// Step -> offset and byte: first the old mark goes, last the new one comes.
static uint8_t find_step(const struct palpate_device *device, uint8_t step, uint8_t *byte) {
  if (step < MARK_BYTES) {
    *byte = (uint8_t)NO_MARK;
    return step;
  }
  uint8_t offset = step < COPY_BYTES ? step : (uint8_t)(step - COPY_BYTES);
  *byte = find_byte(device, offset);
  return offset;
}

static void end_store(struct palpate_device *device, uint8_t result) {
  device->storing.active = false;
  if (result == PALPATE_DONE) {
    device->second_copy = !device->second_copy;
    device->calibration_sequence++;
    adopt(device);
  }
  palpate_answer(device, device->storing.seq, PALPATE_STORE, result);
}

void palpate_continue_store(struct palpate_device *device) {
  if (!board_eeprom_ready(device->board)) return;
  struct palpate_storing *storing = &device->storing;
  uint16_t base = device->second_copy ? 0 : SECOND_COPY;
  uint8_t byte;
  if (storing->step > 0) {
    uint16_t before = base + find_step(device, (uint8_t)(storing->step - 1), &byte);
    if (board_read_eeprom(device->board, before) != byte) {
      end_store(device, PALPATE_EEPROM_FAILED);
      return;
    }
  }
  if (storing->step == STEPS) {
    end_store(device, PALPATE_DONE);
    return;
  }
  uint16_t address = base + find_step(device, storing->step, &byte);
  storing->step++;
  // a cell that is right already need not wear
  if (board_read_eeprom(device->board, address) != byte) {
    board_write_eeprom(device->board, address, byte);
  }
}

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

enum copy { COPY_BLANK, COPY_DAMAGED, COPY_WHOLE };

// A store that lost its power leaves the mark, or a byte of it, erased: that copy never counted.
static enum copy judge_copy(struct palpate_device *device, uint16_t at) {
  uint16_t mark = read_16(device, at);
  if (mark == NO_MARK || mark == (MARK | 0x00ff) || mark == (MARK | 0xff00)) return COPY_BLANK;
  uint16_t crc = start_crc(read_16(device, at + 2));
  for (uint8_t b = 0; b < PALPATE_CALIBRATION_BYTES; b++) {
    crc =
        palpate_update_crc(crc, board_read_eeprom(device->board, (uint16_t)(at + HEAD_BYTES + b)));
  }
  return mark == MARK && crc == read_16(device, at + 4) ? COPY_WHOLE : COPY_DAMAGED;
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
  device->memory = 0;
  return true;
}

static void read_copy(struct palpate_device *device, bool second) {
  uint16_t at = second ? SECOND_COPY : 0;
  device->second_copy = second;
  device->calibration_sequence = read_16(device, at + 2);
  for (uint8_t b = 0; b < PALPATE_CALIBRATION_BYTES; b++) {
    device->pages[b] = board_read_eeprom(device->board, (uint16_t)(at + HEAD_BYTES + b));
  }
}

// A damaged copy was whole once. Unless it says that it is the older one it may have been what
// counted, and nobody knows what the one before it is worth: it can be read, but not obeyed.
void palpate_load_calibration(struct palpate_device *device) {
  enum copy first = judge_copy(device, 0);
  enum copy second = judge_copy(device, SECOND_COPY);
  bool use_second = second == COPY_WHOLE;
  if (use_second && first == COPY_WHOLE) {
    use_second = (int16_t)(read_16(device, SECOND_COPY + 2) - read_16(device, 2)) > 0;
  }
  device->memory =
      first == COPY_BLANK && second == COPY_BLANK ? PALPATE_FEATURE_BLANK : PALPATE_FEATURE_DAMAGED;
  if (first == COPY_WHOLE || second == COPY_WHOLE) {
    read_copy(device, use_second);
    bool lost = false;
    if ((use_second ? first : second) == COPY_DAMAGED) {
      uint16_t other = read_16(device, (use_second ? 0 : SECOND_COPY) + 2);
      lost = other != (uint16_t)(device->calibration_sequence - 1);
    }
    if (!lost && adopt(device)) return;
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

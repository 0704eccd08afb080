// SPDX-License-Identifier: BSD-3-Clause
// Words for people; the microcontroller never links them.
#include "protocol/messages.h"

#define PICK(names, i, other) ((i) < sizeof(names) / sizeof *(names) ? (names)[i] : (other))

const char *palpate_fault_name(uint8_t fault) {
  static const char *const names[] = {
      "host silent", "stop pressed",  "driver fault", "sensor fault",
      "over speed",  "motor too hot", "overrun",      "watchdog reset",
      "bytes lost",  "damaged frame", "calibration",  "message refused",
  };
  return PICK(names, fault, "none");
}

const char *palpate_mode_name(uint8_t mode) {
  static const char *const names[] = {"boot", "idle", "ramp", "run", "faulted"};
  return PICK(names, mode, "unknown");
}

const char *palpate_result_name(uint8_t result) {
  static const char *const names[] = {
      "done",
      "unknown type",
      "wrong length",
      "wrong version",
      "wrong mode",
      "wrong session",
      "commands before it were not zero",
      "cause of the fault remains",
      "no such page",
      "bad calibration",
      "busy",
      "bad value",
      "EEPROM does not keep what is written",
  };
  return PICK(names, result, "unknown");
}

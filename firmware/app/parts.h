// SPDX-License-Identifier: BSD-3-Clause
// What the parts of the app ask of each other.
#pragma once

#include "app/device.h"

/// Motors off at once; the first fault to do so keeps its name until CLEAR.
void palpate_cut(struct palpate_device *device, uint8_t fault);
/// A bit the host shall see; the motors go on.
void palpate_notice(struct palpate_device *device, uint8_t notice);
/// To IDLE from RAMP or RUN.
void palpate_rest(struct palpate_device *device);
bool palpate_is_energised(const struct palpate_device *device);

/// Computes and applies the duty of every motor.
void palpate_move_motors(struct palpate_device *device);
/// They would only be given what they have.
bool palpate_is_settled(const struct palpate_device *device);
/// The thermal model of the motors, one of them per tick.
void palpate_heat_motors(struct palpate_device *device);
/// Some motor is hotter than it may be forever.
bool palpate_is_hot(const struct palpate_device *device);

/// Obeys or refuses the message in device->body.
void palpate_obey(struct palpate_device *device);
void palpate_answer(struct palpate_device *device, uint8_t seq, uint8_t type, uint8_t result);
void palpate_send_state(struct palpate_device *device);
/// Sends a body as a frame, or drops it when there is no room.
void palpate_send(struct palpate_device *device, const uint8_t *body, uint8_t count);

void palpate_load_calibration(struct palpate_device *device);
/// The result at once, or PALPATE_DONE and an answer when all is written.
uint8_t palpate_begin_store(struct palpate_device *device, const struct palpate_store *store);
/// At most one byte.
void palpate_continue_store(struct palpate_device *device);

// SPDX-License-Identifier: BSD-3-Clause
// What the two halves of the ATmega328P's port share.
#pragma once

#include <avr/io.h>

/// Not zero: the main loop has something to do.
#define work GPIOR0

/// A tick has begun: what was heard in the last one no longer counts. From the tick's interrupt.
void hear_again(void);

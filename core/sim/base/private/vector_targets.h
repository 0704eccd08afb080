// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Not installed: which targets Highway leaves out. Included before it by every file that is
// compiled once per target.

// arrays and structs of vectors need a vector whose size is known when it is compiled
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3)

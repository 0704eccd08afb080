// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/tissue_model.h"

// Not installed: what lies around each particle, which no file has.

namespace palpate::scenario {

/// Fills it in, whose corners are particles, for the constants that the tissue has.
void find_around(TissueModel& tissue);

}  // namespace palpate::scenario

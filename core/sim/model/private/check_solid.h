// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

// What validate() checks of solids beside what the table of laws says.

/// Throws std::invalid_argument where volumes or skin are not as their structs say.
void check_solid(const TissueModel& model);

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

// What validate() and describe() have to say of the tables that only solids have.

/// Throws std::invalid_argument where volumes or skin are not as their structs say.
void check_solid(const TissueModel& model);

/// "3657 tetrahedra, a skin of 600 vertices, "; nothing for a tissue that is all surface.
std::string describe_solid(const TissueModel& model);

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// The part of validate() that checks the table of prisms.
/// Throws std::invalid_argument, naming column, row, what was found and what was expected.
void check_prisms(const TissueModel& model);

}  // namespace palpate

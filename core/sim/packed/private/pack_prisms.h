// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/packed/private/packed_model.h"

namespace palpate {

/// Lays out the prisms of a wall; the particles must have their rows.
void pack_prisms(const TissueModel& model, PackedModel& packed);

}  // namespace palpate

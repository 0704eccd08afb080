// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/model/load.h"
#include "palpate/sim/response/response.h"

namespace palpate {

// How a linear solid moves within a tick, from its response.

/// The part `share` [-] of the path to where the pushes of a load hold the tissue:
/// 1 - exp(-dt/tau) for dt [s] under the same pushes. Pushes on what is held or out of reach do
/// nothing. Does not allocate.
void relax(const Response& response, const TissueModel& model, const Load& load, double share,
           ResponseState& state) noexcept;

/// [m] Sets the places of these particles; those the response does not move stay as they are.
void place_near(const Response& response, const TissueModel& model, const ResponseState& state,
                std::span<const int> particles, std::span<Vec3> x) noexcept;

/// Ends a tick: sets the places [m] of all particles that move.
void settle(const Response& response, const TissueModel& model, ResponseState& state,
            std::span<Vec3> x) noexcept;

}  // namespace palpate

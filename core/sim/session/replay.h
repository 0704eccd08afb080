// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/session/record.h"
#include "palpate/sim/tick/tick.h"

namespace palpate {

/// How a replay compares with what was recorded.
struct ReplayReport {
  long ticks = 0;
  bool equal = false;          ///< every force, every tool position and every hash, bit by bit
  long first_difference = -1;  ///< tick, -1 for none
  double largest_force_difference = 0.0;     ///< [N]
  double largest_position_difference = 0.0;  ///< [m] of the tool
  std::vector<Felt> felt;                    ///< as replayed
};

/// Runs the recorded hand through the same tick from a fresh world.
ReplayReport replay(const Scene& scene, const Record& record);

}  // namespace palpate

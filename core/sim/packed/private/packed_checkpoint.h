// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "palpate/sim/packed/private/packed_model.h"

namespace palpate {

/// What steps change of a packed tissue, as it was between two of them.
struct PackedCheckpoint {
  PackedCheckpoint() = default;
  explicit PackedCheckpoint(const PackedState& packed);  ///< with all the memory it needs

  double time = 0.0, last_dt = 0.0;            ///< [s]
  CacheAligned<float> displacement, velocity;  ///< [m], [m/s] of what moves
  std::vector<CacheAligned<float>> internal;
};

/// Right after a check that has found nothing. Does not allocate.
void keep_checkpoint(const PackedModel& model, const PackedState& packed,
                     PackedCheckpoint& checkpoint) noexcept;

/// Back to there, with the same slices in motion: to the bit as if no step had been taken since.
void rewind(const PackedModel& model, const PackedCheckpoint& checkpoint,
            PackedState& packed) noexcept;

/// Takes over positions and velocities of a tissue that moves as a whole and has been checked
/// elsewhere. Variables of laws stay as they are.
void take_over(const PackedModel& model, const TissueModel& tissue, const State& state,
               PackedState& packed) noexcept;

/// The same for one particle, between two steps.
void take_over_particle(const PackedModel& model, const TissueModel& tissue, const State& state,
                        std::size_t particle, PackedState& packed) noexcept;

}  // namespace palpate

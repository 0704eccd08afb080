// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "palpate/sim/dynamics/load.h"
#include "palpate/sim/dynamics/packed_model.h"
#include "palpate/sim/dynamics/simd_targets.h"

namespace palpate {

/// Renumbers and pads a tissue for one of simd_targets(); empty for the best.
/// Throws std::invalid_argument for any other target, and where there is no vector code.
PackedModel pack(const TissueModel& model, std::string_view target = {});

/// The target a model was packed for.
std::string_view simd_target(const PackedModel& model) noexcept;

/// Advances by `dt` [s] with symplectic Euler under loads whose triangles are those of the tissue
/// that was packed, as step() does with the reference kernels. Does not allocate.
void step(const PackedModel& model, const Load& load, double dt, PackedState& state) noexcept;

/// Writes time, positions [m] and velocities [m/s] of all particles into `state`, in the
/// tissue's own numbering.
void unpack(const PackedModel& model, const TissueModel& tissue, const PackedState& packed,
            State& state) noexcept;

/// [m] where one particle is, as unpack() would say.
inline Vec3 compute_position(const PackedModel& model, const TissueModel& tissue,
                             const PackedState& state, int particle) noexcept {
  const int row = model.row[static_cast<std::size_t>(particle)];
  const auto width = static_cast<std::size_t>(model.width);
  const auto lane = static_cast<std::size_t>(row) % width;
  const float* u = state.displacement.data() + 3 * (static_cast<std::size_t>(row) - lane) + lane;
  return tissue.rest_position[static_cast<std::size_t>(particle)] +
         Vec3(u[0], u[width], u[2 * width]);
}

}  // namespace palpate

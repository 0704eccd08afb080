// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/model/load.h"
#include "palpate/sim/packed/private/packed_model.h"
#include "palpate/sim/packed/simd_targets.h"

namespace palpate {

enum class PackedOrder {
  bands,    ///< reverse Cuthill-McKee: least memory traffic where all of it moves
  patches,  ///< compact neighbourhoods, for a tissue of which parts sleep
};

/// Renumbers and pads a tissue for one of simd_targets(); empty for the best.
/// `order` is which particles become neighbours in memory.
/// Throws std::invalid_argument for any other target, where there is no vector code, and for a
/// tissue without a packed form.
PackedModel pack(const TissueModel& model, std::string_view target = {},
                 PackedOrder order = PackedOrder::bands);

/// Whether a tissue can be packed, where there is vector code: all can but linear solids.
bool has_packed_form(const TissueModel& model) noexcept;

/// The target a model was packed for.
std::string_view simd_target(const PackedModel& model) noexcept;

/// Advances by `dt` [s] with symplectic Euler under loads whose triangles are those of the tissue
/// that was packed, as step() does with the reference kernels. Does not allocate. `measure`, unless
/// null, is set to what check() needs to know of the step.
void step(const PackedModel& model, const Load& load, double dt, PackedState& state,
          PackedMeasure* measure = nullptr) noexcept;

/// Whether check() will examine single particles and links: `state` must then be the unpacked form
/// of `packed`, otherwise only its time is read.
bool needs_check(const PackedMeasure& measure, const Guard& guard, int steps) noexcept;

/// Checks a packed tissue after steps of which the last was measured, as check() in guard.h does
/// at a plain one.
Alarm check(const PackedModel& model, const TissueModel& tissue, const State& state,
            const PackedMeasure& measure, double work, PackedState& packed, Guard& guard,
            int steps) noexcept;

/// Writes the positions [m] of all particles at the last check, or, while `packed` says that it has
/// been checked since its last step, now. What sleeps has not moved since.
void recall_last_check(const PackedModel& model, const TissueModel& tissue,
                       const PackedState& packed, Vec3Array& position) noexcept;

/// Writes time, and positions [m] and velocities [m/s] of all particles that move, into `state`, in
/// the tissue's own numbering.
void unpack(const PackedModel& model, const TissueModel& tissue, const PackedState& packed,
            State& state) noexcept;

/// Writes the positions [m] of the particles of these slices, from displacements laid out as
/// PackedState::displacement.
void unpack_positions(const PackedModel& model, const TissueModel& tissue,
                      std::span<const float> displacement, std::span<const int> slices,
                      std::span<Vec3> position) noexcept;

/// Writes position and velocity of one particle, as unpack() would.
void unpack_particle(const PackedModel& model, const TissueModel& tissue, const PackedState& packed,
                     std::size_t particle, State& state) noexcept;

/// Likewise of some particles; how far one of them has gone from where `state` had it at most [m].
double unpack_particles(const PackedModel& model, const TissueModel& tissue,
                        const PackedState& packed, std::span<const int> particles,
                        State& state) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/packed/private/active_set.h"

namespace palpate {

/// The rule under which the force of a tool of `radius` [m] is wrong by less than `force_error`
/// [N]. Throws std::invalid_argument, naming the field of the scene, for a tissue without home
/// springs or without a surface: nothing there fades with distance.
ActiveRule derive_active_rule(const TissueModel& model, double radius, double force_error);

/// A slice stands still from here on.
void put_to_sleep(const PackedModel& model, int slice, ActiveSet& active,
                  PackedState& packed) noexcept;

/// Brings the lists of what moves up to date with who is awake.
void list_moving(const ActiveSet& active, PackedState& packed) noexcept;

/// Before a tick: whatever lies within reach of `near`, the particles that the tool may touch,
/// wakes and stays awake.
void wake_near(const PackedModel& model, const TissueModel& tissue, std::span<const int> near,
               ActiveSet& active, PackedState& packed) noexcept;

/// After a tick: wakes the neighbours of what has moved, and puts to sleep what has not. `state`
/// is the unpacked form of `packed`; what falls asleep has no velocity.
void follow_motion(const PackedModel& model, ActiveSet& active, PackedState& packed,
                   State& state) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/haptics/device.h"
#include "palpate/sim/haptics/world.h"

namespace palpate {

/// One haptic tick of dt [s]: from where the hand is to the force it must feel, the mean over the
/// substeps. The live loop, the replay of a record and the tests all call this function, so a
/// recorded session gives back the very same forces. Does not allocate, lock, log or throw.
HapticCommand tick(const Scene& scene, const HapticSample& sample, double dt,
                   World& world) noexcept;

/// 128 bits over positions, velocities and the tool: equal worlds, equal hashes.
std::array<std::uint64_t, 2> compute_hash(const World& world) noexcept;

}  // namespace palpate

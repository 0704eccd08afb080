// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/guard.h"

namespace palpate {

// What check() (guard.h) looks at, one by one: SCIENCE 3, blow-up protocol (b).

inline constexpr double kFarthestMove = 0.3;  ///< of the shortest rest length, in one step
inline constexpr double kLargestStrain = 2.0;
inline constexpr double kShortestLink = 0.05;    ///< of its rest length
inline constexpr double kSmallestVolume = 0.05;  ///< of its rest volume

/// The first particle that is nowhere, or has gone too far since guard.last_position.
Alarm check_particles(const State& state, const Guard& guard, int steps) noexcept;

/// The first link or tetrahedron that is out of its bounds, once some have been for ten looks in a
/// row.
Alarm check_strains(const TissueModel& model, const Vec3Array& x, Guard& guard) noexcept;

/// Too much of `energy` [J], elastic and kinetic, for what `work` [J] has given it.
Alarm check_energy(const TissueModel& model, double energy, double work, double elapsed,
                   Guard& guard) noexcept;

}  // namespace palpate

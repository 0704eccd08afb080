// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/guard.h"

namespace palpate {

// What check() (guard.h) checks, one by one [motion: alarm].

inline constexpr double kFarthestMove = 0.3;   ///< of the shortest rest length, in one step
inline constexpr double kLargestStrain = 2.0;  ///< where energy has come from nowhere
inline constexpr double kTornStrain = 9.0;     ///< whatever the energy
/// In a row. An impact at 3 m/s flings single vertices of a fine mesh that far for some
/// milliseconds (tests/laws/test_contact.cpp); a tissue that blows up does not come back.
inline constexpr int kStrainedChecks = 10;
inline constexpr double kShortestLink = 0.05;    ///< of its rest length
inline constexpr double kSmallestVolume = 0.05;  ///< of its rest volume

/// The first particle that is nowhere, or has gone too far since guard.last_position.
Alarm check_particles(const State& state, const Guard& guard, int steps) noexcept;

/// Whether a particle has moved `far`, or a link is `strained`, because the tissue blows up: asked
/// after check_energy(). A tissue that snaps through or is let go moves as far, and a hand may
/// stretch a link to ten times its length, but neither has more energy than was given. Returns what
/// stands of the two, or none. Eq 10 has no energy to ask for: under it both stand.
Alarm confirm(const TissueModel& model, const Alarm& far, const Alarm& strained,
              Guard& guard) noexcept;

/// [-] The strain of a link beyond which confirm() ends a run in which nothing but a hand pulls.
double find_strain_limit(const TissueModel& model) noexcept;

/// The first link or tetrahedron that has collapsed, else the link that is stretched most, once
/// some have been out of their bounds for ten checks in a row.
Alarm check_strains(const TissueModel& model, const Vec3Array& x, Guard& guard) noexcept;

/// Too much of `energy` [J], elastic and kinetic, for what `work` [J] has given it.
Alarm check_energy(const TissueModel& model, double energy, double work, double elapsed,
                   Guard& guard) noexcept;

}  // namespace palpate

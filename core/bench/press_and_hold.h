// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "palpate/sim/tick/tick.h"

namespace palpate::bench {

/// [m] of the tip below the surface at rest.
inline constexpr double kPressDepth = 3e-3;

/// Where a tissue is pressed and which way is out of it.
struct Place {
  Vec3 point, outward;
};

/// Where a tissue gives most freely: farthest from what is held, the highest particle of equals.
Place find_press_place(const TissueModel& tissue);

/// The hand with the tip so high [m] above the surface at rest.
HapticSample hold_at(const Scene& scene, const Place& place, double height);

/// Particle steps, what a check may cost: some ten seconds.
inline constexpr double kAffordable = 3e8;

/// How many times something is repeated that only makes sure: less often where it takes seconds.
int afford(int wanted, int least, double work_each, double affordable = kAffordable);

/// Particle steps of a tick, of which the naive form does some ten million a second.
double count_work(const Scene& scene, const World& world);

/// Comes from above and holds kPressDepth until it has settled; faster where 300 ticks take more
/// than `affordable` particle steps. Returns what the hand felt in each tick [N]. Throws
/// std::logic_error, which names the work, where that cannot be.
Vec3Array press_and_hold(const std::string& work, const Scene& scene, const Place& place,
                         World& world, double affordable = kAffordable);

}  // namespace palpate::bench

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/bench/bench.h"
#include "palpate/sim/dynamics/state.h"

namespace palpate::bench {

TissueModel without_dashpots(TissueModel model);

/// A body in motion: every particle off its rest by a thousandth of the diagonal,
/// but no more than a tenth of the shortest link.
State shake(const TissueModel& model);

/// [s] that a step of a model takes at least on this machine, counted by hand: the roofline.
double bound_step(const TissueModel& model);

/// One step of a scene's tissue, at the substep of its ticks in the air.
BenchRow time_step(const std::string& work, const Scene& scene, const BenchOptions& options);

}  // namespace palpate::bench

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/bench/bench.h"

namespace palpate::bench {

/// All of a linear solid brought up to date under the pushes of a held press.
BenchRow time_linear_step(const std::string& work, const Scene& scene, const BenchOptions& options);

/// Its tick: a row with the hand in the air, whatever substeps are asked for, since nothing of it
/// swings; and one with a press held.
std::vector<BenchRow> time_linear_ticks(const std::string& work, const Scene& scene,
                                        const BenchOptions& options);

}  // namespace palpate::bench

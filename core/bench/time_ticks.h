// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/bench/bench.h"

namespace palpate::bench {

/// Whole ticks: in the air at each of options.air_substeps, then with a press held.
std::vector<BenchRow> time_ticks(const std::string& work, const Scene& scene,
                                 const BenchOptions& options);

}  // namespace palpate::bench

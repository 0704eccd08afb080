// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/bench/bench.h"

namespace palpate::bench {

/// Segment, closest point and ball against a tree over the surface of a tissue.
std::vector<BenchRow> time_queries(const TissueModel& model, const BenchOptions& options);

/// The tree following a tissue in motion.
BenchRow time_refit(const TissueModel& model, const BenchOptions& options);

}  // namespace palpate::bench

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/bench/bench.h"

namespace palpate::bench {

/// "segment", "closest" or "sphere": a question to a tree over the surface of a tissue.
BenchRow time_query(const std::string& work, const TissueModel& model, const BenchOptions& options);

/// The tree following a tissue in motion.
BenchRow time_refit(const TissueModel& model, const BenchOptions& options);

}  // namespace palpate::bench

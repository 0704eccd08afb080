// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/bench/bench.h"

namespace palpate::bench {

/// The mass-spring step of a held press where tissue at rest sleeps, against the naive step of all
/// of it. Throws std::logic_error where the force of the press, come from above and held, is off by
/// more than 0.2 % of the full run's.
BenchRow time_active_step(const std::string& work, const Scene& scene, const BenchOptions& options);

}  // namespace palpate::bench

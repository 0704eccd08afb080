// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace palpate::bench {

/// What one core of this machine can do at most, measured.
struct Limits {
  double operations = 0.0;  ///< [1/s] float multiplications and additions, in vectors
  double bytes = 0.0;       ///< [B/s] read from a working set of the size asked for
};

/// With the instructions of one of simd_targets(); all 0 without vector code.
Limits measure_limits(std::string_view target, std::size_t working_set);

/// [s] that work of so many operations and bytes takes at least: the roofline
/// [WilliamsWatermanPatterson09]. 0 without limits.
double compute_bound(const Limits& limits, double operations, double bytes);

}  // namespace palpate::bench

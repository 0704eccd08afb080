// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>

#include "palpate/bench/bench.h"

namespace palpate::bench {

/// Ours and the naive form in turns until the budget is used up; times are per `batch`-th part.
BenchRow time_against(const BenchOptions& options, int batch, const std::function<void()>& ours,
                      const std::function<void()>& naive);

/// [m] between the two positions of the particle for which that is largest.
double largest_difference(std::span<const Vec3> a, std::span<const Vec3> b);

/// Throws std::logic_error where ours and the naive form differ by more than `tolerance` [m].
void require_agreement(const std::string& work, double difference, double tolerance);

}  // namespace palpate::bench

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "palpate/sim/base/private/duration_histogram.h"

using namespace palpate;

TEST_CASE("no durations have no percentile but zero") {
  const DurationHistogram durations;

  CHECK(durations.count() == 0);
  CHECK(durations.percentile(0.5) == 0.0);
  CHECK(durations.largest() == 0);
}

TEST_CASE("durations below 256 ns are kept exactly") {
  DurationHistogram durations;
  for (int ns = 1; ns <= 100; ++ns) durations.add(ns);

  CHECK(durations.percentile(0.5) == 50.0);
  CHECK(durations.percentile(0.99) == 99.0);
  CHECK(durations.percentile(1.0) == 100.0);
  CHECK(durations.percentile(0.0) == 1.0);
}

TEST_CASE("percentiles over nine decades are within 0.4 % of those of the sorted list") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(0.0, 9.0);
  std::vector<std::int64_t> sorted;
  DurationHistogram durations;
  for (int i = 0; i < 20000; ++i) {
    sorted.push_back(static_cast<std::int64_t>(std::pow(10.0, exponent(random))));
    durations.add(sorted.back());
  }
  std::sort(sorted.begin(), sorted.end());

  for (const double share : {0.001, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const auto rank = static_cast<std::size_t>(std::max(1.0, std::ceil(share * 20000))) - 1;
    const double exact = static_cast<double>(sorted[rank]);
    CHECK(std::abs(durations.percentile(share) - exact) <= 0.004 * exact);
  }
  CHECK(durations.count() == 20000);
  CHECK(durations.largest() == sorted.back());
}

TEST_CASE("what is beyond 18 minutes or before zero is counted at the end of the scale") {
  DurationHistogram durations;
  durations.add(std::int64_t{1} << 50);
  durations.add(-5);

  CHECK(durations.count() == 2);
  CHECK(durations.largest() == std::int64_t{1} << 50);
  CHECK(durations.percentile(0.5) == 0.0);
  CHECK(durations.percentile(1.0) > 1.09e12);
}

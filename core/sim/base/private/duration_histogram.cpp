// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/base/private/duration_histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace palpate {

/// The leading bit chooses the doubling, the seven bits after it the bin [HdrHistogram].
int DurationHistogram::bin_of(std::uint64_t nanoseconds) noexcept {
  const std::uint64_t ns = std::min(nanoseconds, (std::uint64_t{1} << kTopBit) - 1);
  const int shift = std::max(0, static_cast<int>(std::bit_width(ns)) - kSubBits - 1);
  return (shift << kSubBits) + static_cast<int>(ns >> shift);
}

double DurationHistogram::middle_of(int bin) noexcept {
  const int shift = std::max(0, (bin >> kSubBits) - 1);
  const double low = std::ldexp(bin - (shift << kSubBits), shift);
  return low + 0.5 * (std::ldexp(1.0, shift) - 1.0);
}

void DurationHistogram::add(std::int64_t nanoseconds) noexcept {
  const std::int64_t ns = std::max<std::int64_t>(nanoseconds, 0);
  // one thread adds, so load and store do what a locked increment would
  std::atomic<std::int64_t>& bin = bins_[static_cast<std::size_t>(bin_of(std::uint64_t(ns)))];
  bin.store(bin.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  if (ns > largest()) largest_.store(ns, std::memory_order_relaxed);
}

std::int64_t DurationHistogram::count() const noexcept {
  std::int64_t count = 0;
  for (const auto& bin : bins_) count += bin.load(std::memory_order_relaxed);
  return count;
}

double DurationHistogram::percentile(double share) const noexcept {
  const double wanted = std::max(1.0, std::ceil(share * static_cast<double>(count())));
  std::int64_t seen = 0;
  for (int bin = 0; bin < kBins; ++bin) {
    seen += bins_[static_cast<std::size_t>(bin)].load(std::memory_order_relaxed);
    if (static_cast<double>(seen) >= wanted) {
      return std::min(middle_of(bin), static_cast<double>(largest()));
    }
  }
  return 0.0;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace palpate {

/// How often which duration was measured, for a run of any length in fixed memory.
///
/// One thread adds, any thread may ask meanwhile. From 0 to 255 ns every nanosecond has its own
/// bin, above that every doubling has 128 bins, so a percentile is right within 0.4 %; what lasted
/// longer than 18 minutes counts as that long. Nothing is allocated or locked.
class DurationHistogram {
 public:
  void add(std::int64_t nanoseconds) noexcept;

  std::int64_t count() const noexcept;
  /// [ns] exact
  std::int64_t largest() const noexcept { return largest_.load(std::memory_order_relaxed); }
  /// [ns] that `share` (0 to 1) of all durations do not exceed; 0 when there are none.
  double percentile(double share) const noexcept;

 private:
  static constexpr int kSubBits = 7;  ///< 128 bins per doubling
  static constexpr int kTopBit = 40;  ///< 2^40 ns = 18 min
  static constexpr int kBins = (kTopBit - kSubBits + 1) << kSubBits;
  static int bin_of(std::uint64_t nanoseconds) noexcept;
  static double middle_of(int bin) noexcept;

  std::array<std::atomic<std::int64_t>, kBins> bins_{};
  std::atomic<std::int64_t> largest_{0};
};

}  // namespace palpate

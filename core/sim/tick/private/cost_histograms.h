// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "palpate/sim/base/private/duration_histogram.h"
#include "palpate/sim/base/private/realtime.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

/// Adds the time since it was last asked to what is given it; does nothing, and reads no clock,
/// when it is off.
class Stopwatch {
 public:
  explicit Stopwatch(bool on) noexcept : on_(on), last_(on ? read_clock() : 0) {}

  void add_to(double& seconds) noexcept {
    if (on_) seconds += lap();
  }
  /// [s] since it was last asked; 0 when it is off.
  double lap() noexcept {
    if (!on_) return 0.0;
    const std::int64_t now = read_clock();
    return 1e-9 * static_cast<double>(now - std::exchange(last_, now));
  }
  bool on() const noexcept { return on_; }

 private:
  bool on_;
  std::int64_t last_;
};

Percentiles percentiles_of(const DurationHistogram& durations) noexcept;

/// What many ticks of a world cost. One thread adds, any thread may ask meanwhile.
class CostHistograms {
 public:
  explicit CostHistograms(const World& world);
  void add(const TickCosts& costs) noexcept;
  SceneCosts summarise() const;

 private:
  std::size_t bodies_, instruments_, pairs_, body_pairs_, scenery_, rigid_;
  std::unique_ptr<DurationHistogram[]> parts_;  // the tick, and then as the counts above
};

}  // namespace palpate

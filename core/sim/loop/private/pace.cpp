// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/private/pace.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/realtime.h"

namespace palpate {
namespace {

/// Of the ticks' rate; clocks of quartz are a thousand times better.
constexpr double kSameRate = 0.02;

}  // namespace

std::int64_t Pace::after_start(std::int64_t index) const noexcept {
  return std::llround(double(index) * 1e9 / rate_);
}

HapticDevice* Pace::find_pacer() const noexcept {
  HapticDevice* failed = nullptr;
  for (HapticDevice* device : devices_) {
    if (!(std::abs(device->report_rate() - rate_) < kSameRate * rate_)) continue;
    if (!device->failed()) return device;
    if (!failed) failed = device;
  }
  return failed;
}

void Pace::begin(std::int64_t index) noexcept {
  start_ = read_clock() + period() - after_start(index);
}

std::int64_t Pace::wait(std::int64_t index) noexcept {
  HapticDevice* const pacer = find_pacer();
  if (!pacer) {
    wait_until(due(index), spin_);
    return due(index);
  }
  const std::int64_t latest = due(index) + period() / 2;
  if (!pacer->wait_for_report(latest)) {
    wait_until(latest, 0);  // one that has just been unplugged does not wait
    unpaced_.fetch_add(1, std::memory_order_relaxed);
    return latest;
  }
  // longer than a report was waited for, we were stopped ourselves: this tick is late, and those
  // that were due meanwhile are missed
  const std::int64_t now = read_clock();
  if (now - latest > period()) return due(index);
  start_ = now - after_start(index);
  return std::min(now, latest);
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "palpate/sim/device/device.h"

namespace palpate {

/// When the ticks of the live loop are due. All times are [ns] of the monotonic clock.
///
/// Tick k is due k periods after the start. Where a device reports at the ticks' rate, it is due
/// when its report has come, and the start moves with it: the two clocks drift, and a report that
/// waits for our clock is felt later by as much. A report may be late by half a period before the
/// tick goes on without it; then our clock counts until reports come again. A report found later
/// than that by a period and more waited for a host that was stopped: the start stays, so the tick
/// is late and those before it are missed. Of several such devices the first sets the pace that has
/// not failed, or the first of all.
class Pace {
 public:
  /// `rate` [Hz] of the ticks; `spin` is spun instead of slept where our clock counts.
  Pace(HapticDevice& device, double rate, std::int64_t spin) : Pace({&device}, rate, spin) {}
  Pace(std::vector<HapticDevice*> devices, double rate, std::int64_t spin)
      : devices_(std::move(devices)), rate_(rate), spin_(spin) {}

  /// Tick `index` is due one period from now.
  void begin(std::int64_t index) noexcept;
  /// Returns when tick `index` really was due, once it is.
  std::int64_t wait(std::int64_t index) noexcept;
  std::int64_t due(std::int64_t index) const noexcept { return start_ + after_start(index); }
  std::int64_t period() const noexcept { return after_start(1); }
  /// Ticks that went without the report that was waited for; from any thread.
  long unpaced() const noexcept { return unpaced_.load(std::memory_order_relaxed); }

 private:
  std::int64_t after_start(std::int64_t index) const noexcept;
  /// The device that sets the pace, null where our clock does.
  HapticDevice* find_pacer() const noexcept;

  const std::vector<HapticDevice*> devices_;
  const double rate_;
  const std::int64_t spin_;
  std::int64_t start_ = 0;
  std::atomic<long> unpaced_{0};
};

}  // namespace palpate

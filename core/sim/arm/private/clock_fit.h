// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace palpate {

/// How a device's millisecond ticks lie in the host's time: a line through the arrivals of its
/// reports, which forgets over some ten seconds. Tells the two clocks' drift, and how far each
/// arrival is off the line.
class ClockFit {
 public:
  /// A report of `tick` (16 bits that wrap), come at `time` [s]. Returns how much later than the
  /// line says [s].
  double add(std::uint16_t tick, double time) noexcept;

  /// [s] since the first report, by the device's clock.
  double device_time() const noexcept { return 1e-3 * static_cast<double>(ticks_); }
  /// Ticks that lie between the last two reports, 1 where none is missing.
  long gap() const noexcept { return gap_; }
  /// By how much the device's clock is fast: 1e-6 for 1 ppm.
  double drift() const noexcept;
  void clear() noexcept { *this = ClockFit{}; }
  /// The host's time jumps: a new run. The device's goes on.
  void restart() noexcept;

 private:
  bool begun_ = false, restarted_ = false;
  std::uint16_t last_tick_ = 0;
  std::int64_t ticks_ = 0;
  long gap_ = 0;
  double origin_ = 0.0;  ///< [s] of the first report
  // sums of a regression of the host's time over the device's, about their means
  double weight_ = 0.0, mean_device_ = 0.0, mean_host_ = 0.0, square_ = 0.0, product_ = 0.0;
};

}  // namespace palpate

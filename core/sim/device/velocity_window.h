// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace palpate {

/// The speed of something that is known in steps, from a window that adapts itself: as many of the
/// last readings as one straight line passes within a step of. Slow motion gets a long window
/// and little noise, fast motion a short one and little delay.
///
/// Readings may be missing. Allocates nothing.
class VelocityWindow {
 public:
  static constexpr int kLongest = 32;  ///< readings

  VelocityWindow() = default;
  /// `step` is how far apart two neighbouring readings are, in their unit; `longest` from 2
  /// readings to kLongest. Throws std::invalid_argument.
  explicit VelocityWindow(double step, int longest = 16);

  /// Takes a reading at `time` [s] and returns its speed, in the reading's unit per second; 0 for
  /// the first. The same time again is ignored, an earlier one starts again.
  double add(double time, double value) noexcept;
  double speed() const noexcept { return speed_; }
  /// How many readings the last speed came from.
  int length() const noexcept { return length_; }
  void clear() noexcept;

 private:
  double time_ago(int n) const noexcept { return times_[slot(n)]; }
  double value_ago(int n) const noexcept { return values_[slot(n)]; }
  std::size_t slot(int n) const noexcept {
    return static_cast<std::size_t>((newest_ - n + kLongest) % kLongest);
  }
  bool fits(int n) const noexcept;

  std::array<double, kLongest> times_{}, values_{};
  double step_ = 0.0;
  int longest_ = 16;
  int newest_ = -1, count_ = 0, length_ = 0;
  double speed_ = 0.0;
};

}  // namespace palpate

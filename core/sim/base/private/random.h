// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace palpate {

/// 0 up to 1, of no correlation with the next: SplitMix64 [SteeleLeaFlood14]. Moves `random` on.
inline double draw(std::uint64_t& random) noexcept {
  std::uint64_t z = random += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// Normally distributed, with a standard deviation of 1 [BoxMuller58].
inline double draw_normal(std::uint64_t& random) noexcept {
  const double size = std::sqrt(-2.0 * std::log(1.0 - draw(random)));
  return size * std::cos(2.0 * std::numbers::pi * draw(random));
}

}  // namespace palpate

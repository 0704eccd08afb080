// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "palpate/sim/base/types.h"

namespace palpate {

/// An axis-aligned box; empty at first.
struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& p) noexcept {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void add(const Box& box) noexcept {
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
  }
  /// [m²]
  double half_area() const noexcept {
    const Vec3 d = high - low;
    return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
  }
};
static_assert(sizeof(Box) == 48 && alignof(Box) == 8);

inline Box bound_triangle(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

inline Box bound_triangle(std::span<const Vec3> x, const Triangle& t) noexcept {
  return bound_triangle(x[static_cast<std::size_t>(t[0])], x[static_cast<std::size_t>(t[1])],
                        x[static_cast<std::size_t>(t[2])]);
}

/// a·b, summed in one fixed order: plain and vector code then agree to the bit.
inline double dot_in_order(const Vec3& a, const Vec3& b) noexcept {
  return (a.x() * b.x() + a.y() * b.y()) + a.z() * b.z();
}

/// [m²] d·d
inline double square(const Vec3& d) noexcept { return dot_in_order(d, d); }

/// [m²] A distance squared so that no square whose rounded root is that distance lies above it.
inline double square_upwards(double distance) noexcept {
  return distance * distance * (1.0 + 4.0 * std::numeric_limits<double>::epsilon());
}

/// Whether a triangle at this distance goes before the best so far; the lower one of two as near.
inline bool is_better(double distance, int triangle, double best_distance, int best) noexcept {
  if (distance != best_distance) return distance < best_distance;
  return best < 0 || triangle < best;
}

/// sin² of a triangle's first corner below which its plane is not trusted alone.
inline constexpr double kSliver = 1e-6;

/// [m²] Smallest squared distance from p to a box; 0 inside.
///
/// Rounding is monotone, so for every q inside the box square(p - q) is not less than this, and
/// the box of a parent is never farther than that of a child: pruning by it is exact.
inline double compute_squared_distance(const Vec3& p, const Vec3& low, const Vec3& high) noexcept {
  return square((low - p).cwiseMax(p - high).cwiseMax(Vec3::Zero()));
}

/// The largest float that is surely not above a number, and the smallest surely not below it, or
/// nearly so: in float a box becomes larger, never smaller.
inline constexpr double kOutwards = 1.2e-7;  // two roundings to float
inline constexpr double kLeastOutwards = 1e-44;
inline float round_down(double v) noexcept {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return static_cast<float>(std::min(kLargest, v - (std::abs(v) * kOutwards + kLeastOutwards)));
}
inline float round_up(double v) noexcept { return -round_down(-v); }

/// A segment from `from` along `direction`, at parameters t in [0, end], with boxes grown by `grow`
/// [m] on every side.
struct Segment {
  Vec3 from = Vec3::Zero();
  Vec3 direction = Vec3::Zero();
  double end = 1.0;
  double grow = 0.0;
  /// held finite, so that no product with it is NaN; not used where the direction is 0
  Vec3 inverse = direction.cwiseInverse()
                     .cwiseMin(std::numeric_limits<double>::max())
                     .cwiseMax(std::numeric_limits<double>::lowest());
};

/// The parameter at which a segment enters a grown box, 0 when it starts inside; infinity where it
/// misses. Monotone: it enters the box of a parent no later than that of a child.
inline double enter_box(const Segment& segment, const Vec3& low, const Vec3& high) noexcept {
  double in = 0.0, out = segment.end;
  for (int k = 0; k < 3; ++k) {
    const double to_low = (low[k] - segment.grow) - segment.from[k];
    const double to_high = (high[k] + segment.grow) - segment.from[k];
    if (segment.direction[k] == 0.0) {
      if (!(to_low <= 0.0 && to_high >= 0.0)) return std::numeric_limits<double>::infinity();
      continue;
    }
    const double t0 = to_low * segment.inverse[k], t1 = to_high * segment.inverse[k];
    in = std::max(in, std::min(t0, t1));
    out = std::min(out, std::max(t0, t1));
  }
  return in <= out ? in : std::numeric_limits<double>::infinity();
}

}  // namespace palpate

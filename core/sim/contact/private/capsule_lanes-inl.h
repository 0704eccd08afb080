// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by capsule_lanes.cpp: sums over slices, a lane for each.
#if defined(PALPATE_CAPSULE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_CAPSULE_LANES_INL_H
#undef PALPATE_CAPSULE_LANES_INL_H
#else
#define PALPATE_CAPSULE_LANES_INL_H
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <limits>
#include <numbers>

#include "palpate/sim/contact/private/capsule_slices.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using SliceLanes = hn::CappedTag<double, 8>;
using SliceReal = hn::Vec<SliceLanes>;
inline constexpr SliceLanes kSliceLanes;

HWY_INLINE SliceReal set(double value) { return hn::Set(kSliceLanes, value); }

HWY_INLINE SliceReal clamp(const SliceReal x, const SliceReal low, const SliceReal high) {
  return hn::Min(hn::Max(x, low), high);
}

HWY_INLINE SliceReal find_root(const SliceReal x) { return hn::Sqrt(hn::Max(x, set(0.0))); }

/// The part of each slice that lies inside the triangle.
HWY_INLINE void find_chords(const Corners& corners, const SliceReal s, SliceReal& low,
                            SliceReal& high) {
  low = set(std::numeric_limits<double>::infinity());
  high = hn::Neg(low);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &a = corners[k], &b = corners[(k + 1) % 3];
    const SliceReal from = set(a[0]), to = set(b[0]);
    const auto crosses = hn::Xor(hn::Lt(from, s), hn::Lt(to, s));
    const SliceReal slope = set((b[1] - a[1]) / (b[0] == a[0] ? 1.0 : b[0] - a[0]));
    const SliceReal y = hn::MulAdd(hn::Sub(s, from), slope, set(a[1]));
    low = hn::IfThenElse(crosses, hn::Min(low, y), low);
    high = hn::IfThenElse(crosses, hn::Max(high, y), high);
  }
}

/// What is summed in each lane.
struct LaneSums {
  SliceReal force, stiffness, area, along_plane, beside, aside_along, aside, along_axis, squared;
};

/// NearPressure, p and its slope, where the overlap is positive; 0 elsewhere.
HWY_INLINE void press(const NearPressure& law, const SliceReal overlap, SliceReal& pressure,
                      SliceReal& slope) {
  const auto pressed = hn::Gt(overlap, set(0.0));
  const SliceReal x = hn::IfThenElse(pressed, hn::Mul(overlap, set(1.0 / law.radius)), set(1.0));
  const SliceReal root = hn::Sqrt(x), scale = set(law.modulus * std::numbers::inv_pi);
  const SliceReal p = hn::Mul(
      hn::Mul(scale, root),
      hn::MulAdd(x, hn::MulAdd(x, set(kSecondOfPressure), set(kFirstOfPressure)), set(1.0)));
  const SliceReal rise = hn::Div(
      hn::Mul(
          set(law.modulus * std::numbers::inv_pi / law.radius),
          hn::MulAdd(x, hn::MulAdd(x, set(2.5 * kSecondOfPressure), set(1.5 * kFirstOfPressure)),
                     set(0.5))),
      root);
  const SliceReal stiffness = set(law.stiffness);
  pressure = hn::IfThenElseZero(pressed, hn::Min(hn::Mul(stiffness, overlap), p));
  slope = hn::IfThenElseZero(pressed, hn::Min(stiffness, rise));
}

/// One point of each slice, y = half sin(angle) beside the axis.
HWY_INLINE void add_points(const Strip& strip, const SliceReal s, const SliceReal y,
                           const SliceReal part, LaneSums& sums) {
  const SliceReal radius = set(strip.law.radius), first = set(strip.first);
  const SliceReal squared_half = hn::NegMulAdd(y, y, hn::Mul(radius, radius));
  const SliceReal half = find_root(squared_half);
  const SliceReal along =
      strip.flat > kUpright
          ? clamp(hn::Mul(hn::NegMulAdd(set(strip.rise), half, s), set(1.0 / strip.flat)), first,
                  set(strip.last))
          : first;
  const SliceReal beyond = hn::NegMulAdd(along, set(strip.flat), s);
  const SliceReal above = find_root(hn::NegMulAdd(beyond, beyond, squared_half));
  const SliceReal overlap = hn::Sub(above, hn::MulAdd(along, set(strip.rise), set(strip.height)));
  SliceReal pressure, slope;
  press(strip.law, overlap, pressure, slope);
  const SliceReal p = hn::Mul(part, pressure);
  const auto slants = hn::Gt(above, set(0.0));
  const SliceReal lever =
      hn::IfThenElseZero(slants, hn::Div(p, hn::IfThenElse(slants, above, set(1.0))));
  const SliceReal at = hn::Mul(p, along);
  sums.area = hn::Add(sums.area, part);
  sums.force = hn::Add(sums.force, p);
  sums.stiffness = hn::MulAdd(part, slope, sums.stiffness);
  sums.along_plane = hn::MulAdd(p, s, sums.along_plane);
  sums.beside = hn::MulAdd(p, y, sums.beside);
  sums.aside_along = hn::MulAdd(lever, beyond, sums.aside_along);
  sums.aside = hn::MulAdd(lever, y, sums.aside);
  sums.along_axis = hn::Add(sums.along_axis, at);
  sums.squared = hn::MulAdd(at, along, sums.squared);
}

/// The slices from `at` on. Of the cosine of an angle within a quarter turn there is but one sign.
HWY_INLINE void add_slices(const Strip& strip, const Corners& corners, const Slices& slices,
                           std::size_t at, LaneSums& sums) {
  const SliceReal s = hn::Load(kSliceLanes, slices.at.data() + at);
  const SliceReal width = hn::Load(kSliceLanes, slices.width.data() + at);
  SliceReal low, high;
  find_chords(corners, s, low, high);
  const SliceReal radius = set(strip.law.radius), one = set(1.0);
  const SliceReal foot = clamp(hn::MulSub(s, set(strip.flat), set(strip.height * strip.rise)),
                               set(strip.first), set(strip.last));
  const SliceReal beyond = hn::NegMulAdd(foot, set(strip.flat), s);
  const SliceReal height = hn::MulAdd(foot, set(strip.rise), set(strip.height));
  const SliceReal half = find_root(
      hn::NegMulAdd(height, height, hn::NegMulAdd(beyond, beyond, hn::Mul(radius, radius))));
  const auto wide = hn::And(hn::Gt(half, set(0.0)), hn::Gt(high, low));
  const SliceReal inverse = hn::Div(one, hn::IfThenElse(wide, half, one));
  const SliceReal begin = hn::IfThenElseZero(wide, hn::Mul(low, inverse));
  const SliceReal end = hn::IfThenElseZero(wide, hn::Mul(high, inverse));
  const SliceReal from = hn::Asin(kSliceLanes, clamp(begin, hn::Neg(one), one));
  const SliceReal to = hn::Asin(kSliceLanes, clamp(end, hn::Neg(one), one));
  const SliceReal angle = hn::Sub(to, from);
  const SliceReal whole = hn::IfThenElseZero(hn::And(wide, hn::Gt(angle, set(0.0))),
                                             hn::Mul(width, hn::Mul(angle, half)));
  for (std::size_t i = 0; i < kAcrossNodes.size(); ++i) {
    const SliceReal sine = hn::Sin(kSliceLanes, hn::MulAdd(set(kAcrossNodes[i]), angle, from));
    const SliceReal cosine = find_root(hn::NegMulAdd(sine, sine, one));
    const SliceReal part = hn::Mul(hn::Mul(whole, set(kAcrossWeights[i])), cosine);
    add_points(strip, s, hn::Mul(half, sine), part, sums);
  }
}

HWY_INLINE double sum_lanes(const SliceReal x) {
  return hn::GetLane(hn::SumOfLanes(kSliceLanes, x));
}

/// What is left of the last vector gets no width.
void sum_slices(const Strip& strip, const Corners& corners, Slices& slices,
                SliceSums& sums) noexcept {
  const std::size_t lanes = hn::MaxLanes(kSliceLanes);
  for (std::size_t k = slices.count; k % lanes != 0; ++k) {
    slices.at[k] = slices.at[slices.count - 1];
    slices.width[k] = 0.0;
  }
  const SliceReal zero = set(0.0);
  LaneSums sum{zero, zero, zero, zero, zero, zero, zero, zero, zero};
  for (std::size_t at = 0; at < slices.count; at += lanes) {
    add_slices(strip, corners, slices, at, sum);
  }
  sums.force = sum_lanes(sum.force);
  sums.stiffness = sum_lanes(sum.stiffness);
  sums.area = sum_lanes(sum.area);
  sums.along_plane = sum_lanes(sum.along_plane);
  sums.beside = sum_lanes(sum.beside);
  sums.aside_along = sum_lanes(sum.aside_along);
  sums.aside = sum_lanes(sum.aside);
  sums.along_axis = sum_lanes(sum.along_axis);
  sums.squared = sum_lanes(sum.squared);
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_CAPSULE_LANES_INL_H

// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by packed_kernels.cpp: points in vectors of lanes.
#if defined(PALPATE_PACKED_VECTOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_PACKED_VECTOR_INL_H
#undef PALPATE_PACKED_VECTOR_INL_H
#else
#define PALPATE_PACKED_VECTOR_INL_H
#endif

#include <hwy/highway.h>

#include "palpate/sim/packed/private/packed_model.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate::packed_kernels {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 16>;
using Real = hn::Vec<Lanes>;
inline constexpr Lanes kLanes;
inline constexpr std::size_t kWidth = hn::MaxLanes(Lanes());

/// One point or vector per lane.
struct Points {
  Real x, y, z;
};

HWY_INLINE Points operator-(const Points& a, const Points& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Points operator+(const Points& a, const Points& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Points operator*(const Real s, const Points& a) {
  return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}
/// s a + b
HWY_INLINE Points add_scaled(const Real s, const Points& a, const Points& b) {
  return {hn::MulAdd(s, a.x, b.x), hn::MulAdd(s, a.y, b.y), hn::MulAdd(s, a.z, b.z)};
}
HWY_INLINE Real dot(const Points& a, const Points& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Points cross(const Points& a, const Points& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}

HWY_INLINE Real load(const float* from) { return hn::Load(kLanes, from); }
HWY_INLINE Points load_points(const float* from) {
  return {load(from), load(from + kWidth), load(from + 2 * kWidth)};
}
HWY_INLINE void store_points(const Points& points, float* to) {
  hn::Store(points.x, kLanes, to);
  hn::Store(points.y, kLanes, to + kWidth);
  hn::Store(points.z, kLanes, to + 2 * kWidth);
}

/// 1/sqrt(square) to 22 bits or more: the machine's estimate and as many Newton steps as it needs.
HWY_INLINE Real invert_root(const Real square) {
#if HWY_TARGET == HWY_EMU128
  return hn::Div(hn::Set(kLanes, 1.0f), hn::Sqrt(square));
#else
  const Real half = hn::Mul(square, hn::Set(kLanes, -0.5f));
  Real root = hn::ApproximateReciprocalSqrt(square);
#if HWY_TARGET == HWY_NEON
  root = hn::Mul(root, hn::MulAdd(hn::Mul(half, root), root, hn::Set(kLanes, 1.5f)));
#endif
  return hn::Mul(root, hn::MulAdd(hn::Mul(half, root), root, hn::Set(kLanes, 1.5f)));
#endif
}

/// 1/number, as exact; of 0, what is not a number. Two Newton steps are far from a division's cost.
HWY_INLINE Real invert(const Real number) {
  const Real two = hn::Set(kLanes, 2.0f);
  Real inverse = hn::ApproximateReciprocal(number);
  inverse = hn::Mul(inverse, hn::NegMulAdd(number, inverse, two));
  return hn::Mul(inverse, hn::NegMulAdd(number, inverse, two));
}

/// The rows index[0], index[4], index[8], ... of four floats each, one per block of 128 bits.
template <class D>
HWY_INLINE hn::Vec<D> load_blocks(D d, const float* rows, const int* index) {
  if constexpr (hn::MaxLanes(d) <= 4) {
    return hn::Load(d, rows + 4 * static_cast<std::size_t>(index[0]));
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, load_blocks(half, rows, index + hn::MaxLanes(half)),
                       load_blocks(half, rows, index));
  }
}

template <class D>
HWY_INLINE void store_blocks(D d, hn::Vec<D> blocks, const int* index, float* rows) {
  if constexpr (hn::MaxLanes(d) <= 4) {
    hn::Store(blocks, d, rows + 4 * static_cast<std::size_t>(index[0]));
  } else {
    const hn::Half<D> half;
    store_blocks(half, hn::LowerHalf(half, blocks), index, rows);
    store_blocks(half, hn::UpperHalf(half, blocks), index + hn::MaxLanes(half), rows);
  }
}

/// Adds each block to its row, one after the other: a row may come twice.
template <class D>
HWY_INLINE void add_blocks(D d, hn::Vec<D> blocks, const int* index, float* rows) {
  if constexpr (hn::MaxLanes(d) <= 4) {
    float* row = rows + 4 * static_cast<std::size_t>(index[0]);
    hn::Store(hn::Add(hn::Load(d, row), blocks), d, row);
  } else {
    const hn::Half<D> half;
    add_blocks(half, hn::LowerHalf(half, blocks), index, rows);
    add_blocks(half, hn::UpperHalf(half, blocks), index + hn::MaxLanes(half), rows);
  }
}

/// Pairs of floats move as doubles do, which are never computed with.
using Pairs = hn::Repartition<double, Lanes>;
HWY_INLINE Real lower_pairs(const Real a, const Real b) {
  return hn::BitCast(
      kLanes, hn::InterleaveLower(Pairs(), hn::BitCast(Pairs(), a), hn::BitCast(Pairs(), b)));
}
HWY_INLINE Real upper_pairs(const Real a, const Real b) {
  return hn::BitCast(
      kLanes, hn::InterleaveUpper(Pairs(), hn::BitCast(Pairs(), a), hn::BitCast(Pairs(), b)));
}

/// Lane l is row index[l]. Loads of whole rows and a 4 x 4 transposition per block: no machine's
/// gather instruction is as fast.
HWY_INLINE Points gather(const float* rows, const int* index) {
  const Real row0 = load_blocks(kLanes, rows, index), row1 = load_blocks(kLanes, rows, index + 1);
  const Real row2 = load_blocks(kLanes, rows, index + 2);
  const Real row3 = load_blocks(kLanes, rows, index + 3);
  const Real xy01 = hn::InterleaveLower(kLanes, row0, row1);
  const Real zw01 = hn::InterleaveUpper(kLanes, row0, row1);
  const Real xy23 = hn::InterleaveLower(kLanes, row2, row3);
  const Real zw23 = hn::InterleaveUpper(kLanes, row2, row3);
  return {lower_pairs(xy01, xy23), upper_pairs(xy01, xy23), lower_pairs(zw01, zw23)};
}

/// Lane l is the fourth number of row index[l].
HWY_INLINE Real gather_fourth(const float* rows, const int* index) {
  const Real row0 = load_blocks(kLanes, rows, index), row1 = load_blocks(kLanes, rows, index + 1);
  const Real row2 = load_blocks(kLanes, rows, index + 2);
  const Real row3 = load_blocks(kLanes, rows, index + 3);
  return upper_pairs(hn::InterleaveUpper(kLanes, row0, row1),
                     hn::InterleaveUpper(kLanes, row2, row3));
}

/// Block b of row k belongs to lane 4 b + k.
struct Rows {
  Real row0, row1, row2, row3;
};

HWY_INLINE Rows transpose(const Points& points) {
  const Real zero = hn::Zero(kLanes);
  const Real xy01 = hn::InterleaveLower(kLanes, points.x, points.y);
  const Real xy23 = hn::InterleaveUpper(kLanes, points.x, points.y);
  const Real zw01 = hn::InterleaveLower(kLanes, points.z, zero);
  const Real zw23 = hn::InterleaveUpper(kLanes, points.z, zero);
  return {lower_pairs(xy01, zw01), upper_pairs(xy01, zw01), lower_pairs(xy23, zw23),
          upper_pairs(xy23, zw23)};
}

HWY_INLINE void scatter(const Points& points, const int* index, float* rows) {
  const Rows r = transpose(points);
  store_blocks(kLanes, r.row0, index, rows);
  store_blocks(kLanes, r.row1, index + 1, rows);
  store_blocks(kLanes, r.row2, index + 2, rows);
  store_blocks(kLanes, r.row3, index + 3, rows);
}

HWY_INLINE void scatter_add(const Points& points, const int* index, float* rows) {
  const Rows r = transpose(points);
  add_blocks(kLanes, r.row0, index, rows);
  add_blocks(kLanes, r.row1, index + 1, rows);
  add_blocks(kLanes, r.row2, index + 2, rows);
  add_blocks(kLanes, r.row3, index + 3, rows);
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::packed_kernels
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_PACKED_VECTOR_INL_H

// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by tree_kernels.cpp: four doubles or eight floats at a time.
#if defined(PALPATE_FOUR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_FOUR_INL_H
#undef PALPATE_FOUR_INL_H
#else
#define PALPATE_FOUR_INL_H
#endif

#include <hwy/highway.h>

#include "palpate/sim/tree/private/tree_kernels.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::FixedTag<double, 4>;
inline constexpr Tag kTag;

struct Mask {
  hn::Mask<Tag> raw;
};

struct Four {
  hn::Vec<Tag> raw;
};

PALPATE_TREE_INLINE Four set(double s) { return {hn::Set(kTag, s)}; }
PALPATE_TREE_INLINE Four load(const double* from) { return {hn::Load(kTag, from)}; }
PALPATE_TREE_INLINE void store(Four a, double* to) { hn::Store(a.raw, kTag, to); }
/// A point as x, y, z and 0; reads no more than it.
PALPATE_TREE_INLINE Four load_point(const Vec3& p) {
  return {hn::MaskedLoad(hn::FirstN(kTag, 3), kTag, p.data())};
}

PALPATE_TREE_INLINE Four operator+(Four a, Four b) { return {hn::Add(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Four operator-(Four a, Four b) { return {hn::Sub(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Four operator*(Four a, Four b) { return {hn::Mul(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Four operator/(Four a, Four b) { return {hn::Div(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Four min(Four a, Four b) { return {hn::Min(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Four max(Four a, Four b) { return {hn::Max(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Four sqrt(Four a) { return {hn::Sqrt(a.raw)}; }

PALPATE_TREE_INLINE Mask operator<(Four a, Four b) { return {hn::Lt(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Mask operator<=(Four a, Four b) { return {hn::Le(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Mask operator&(Mask a, Mask b) { return {hn::And(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Mask operator|(Mask a, Mask b) { return {hn::Or(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Four select(Mask m, Four a, Four b) {
  return {hn::IfThenElse(m.raw, a.raw, b.raw)};
}
/// Bit k is lane k.
PALPATE_TREE_INLINE unsigned bits(Mask m) {
  std::uint8_t byte = 0;
  hn::StoreMaskBits(kTag, m.raw, &byte);
  return byte;
}

/// Row k becomes lane k: a 4 x 4 transposition.
PALPATE_TREE_INLINE void transpose(const Four (&rows)[4], Four& x, Four& y, Four& z) {
  const auto xz01 = hn::InterleaveLower(kTag, rows[0].raw, rows[1].raw);
  const auto yw01 = hn::InterleaveUpper(kTag, rows[0].raw, rows[1].raw);
  const auto xz23 = hn::InterleaveLower(kTag, rows[2].raw, rows[3].raw);
  const auto yw23 = hn::InterleaveUpper(kTag, rows[2].raw, rows[3].raw);
  x = {hn::ConcatLowerLower(kTag, xz23, xz01)};
  y = {hn::ConcatLowerLower(kTag, yw23, yw01)};
  z = {hn::ConcatUpperUpper(kTag, xz23, xz01)};
}

/// Four floats, surely not above these; and not below.
PALPATE_TREE_INLINE void store_rounded_down(Four a, float* to) {
  const hn::FixedTag<float, 4> floats;
  const Four lower = a - (Four{hn::Abs(a.raw)} * set(kOutwards) + set(kLeastOutwards));
  hn::Store(hn::DemoteTo(floats, min(lower, set(std::numeric_limits<float>::max())).raw), floats,
            to);
}
PALPATE_TREE_INLINE void store_rounded_up(Four a, float* to) {
  const hn::FixedTag<float, 4> floats;
  const Four upper = a + (Four{hn::Abs(a.raw)} * set(kOutwards) + set(kLeastOutwards));
  hn::Store(hn::DemoteTo(floats, max(upper, set(std::numeric_limits<float>::lowest())).raw), floats,
            to);
}

using EightTag = hn::FixedTag<float, 8>;
inline constexpr EightTag kEightTag;

struct EightMask {
  hn::Mask<EightTag> raw;
};

struct Eight {
  hn::Vec<EightTag> raw;
};

PALPATE_TREE_INLINE Eight set_eight(float s) { return {hn::Set(kEightTag, s)}; }
PALPATE_TREE_INLINE Eight load_eight(const float* from) { return {hn::Load(kEightTag, from)}; }
PALPATE_TREE_INLINE void store(Eight a, float* to) { hn::Store(a.raw, kEightTag, to); }

PALPATE_TREE_INLINE Eight operator+(Eight a, Eight b) { return {hn::Add(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Eight operator-(Eight a, Eight b) { return {hn::Sub(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Eight operator*(Eight a, Eight b) { return {hn::Mul(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Eight min(Eight a, Eight b) { return {hn::Min(a.raw, b.raw)}; }
PALPATE_TREE_INLINE Eight max(Eight a, Eight b) { return {hn::Max(a.raw, b.raw)}; }
PALPATE_TREE_INLINE EightMask operator<=(Eight a, Eight b) { return {hn::Le(a.raw, b.raw)}; }
PALPATE_TREE_INLINE EightMask operator&(EightMask a, EightMask b) {
  return {hn::And(a.raw, b.raw)};
}
PALPATE_TREE_INLINE Eight select(EightMask m, Eight a, Eight b) {
  return {hn::IfThenElse(m.raw, a.raw, b.raw)};
}
PALPATE_TREE_INLINE unsigned bits(EightMask m) {
  std::uint8_t byte = 0;
  hn::StoreMaskBits(kEightTag, m.raw, &byte);
  return byte;
}
/// Bits of the numbers below 0.
PALPATE_TREE_INLINE unsigned find_negative(const std::array<int, 8>& numbers) {
  const hn::FixedTag<std::int32_t, 8> ints;
  std::uint8_t byte = 0;
  hn::StoreMaskBits(ints, hn::Lt(hn::Load(ints, numbers.data()), hn::Zero(ints)), &byte);
  return byte;
}

/// Numbers that are not negative sort as the integers of the same bits, and of those the last three
/// are free to say which child it is, so no two are alike: rounded down, the least stays a least.
PALPATE_TREE_INLINE void make_keys(Eight least, std::int32_t (&keys)[8]) {
  const hn::FixedTag<std::int32_t, 8> ints;
  const auto all = hn::BitCast(ints, least.raw);
  hn::Store(hn::Or(hn::AndNot(hn::Set(ints, 7), all), hn::Iota(ints, 0)), ints, keys);
}
PALPATE_TREE_INLINE float least_of(std::int32_t key) { return std::bit_cast<float>(key & ~7); }
/// Bits of the keys below one of them.
PALPATE_TREE_INLINE unsigned find_less(const std::int32_t (&keys)[8], std::int32_t key) {
  const hn::FixedTag<std::int32_t, 8> ints;
  std::uint8_t byte = 0;
  hn::StoreMaskBits(ints, hn::Lt(hn::Load(ints, keys), hn::Set(ints, key)), &byte);
  return byte;
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_FOUR_INL_H

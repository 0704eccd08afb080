// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by tree_kernels.cpp: four doubles at a time.
#if defined(PALPATE_FOUR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_FOUR_INL_H
#undef PALPATE_FOUR_INL_H
#else
#define PALPATE_FOUR_INL_H
#endif

#include <hwy/highway.h>

#include "palpate/sim/contact/tree_kernels.h"

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

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_FOUR_INL_H

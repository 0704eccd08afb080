// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by packed_kernels.cpp: what resists the shear of walls.
#if defined(PALPATE_PACKED_PRISMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_PACKED_PRISMS_INL_H
#undef PALPATE_PACKED_PRISMS_INL_H
#else
#define PALPATE_PACKED_PRISMS_INL_H
#endif

#include "palpate/sim/packed/private/packed_advance-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate::packed_kernels {
namespace HWY_NAMESPACE {

/// The six corners of a prism: three inner, then the three above them.
HWY_INLINE void gather_prism(const float* rows, const int* corner, Points* prism) {
  for (std::size_t c = 0; c < 6; ++c) prism[c] = gather(rows, corner + c * kWidth);
}

/// A diagonal of a side: the vector from its first end to its second.
struct Diagonal {
  Points along;
  Real length, inverse;
};

HWY_INLINE Diagonal measure_diagonal(const Points& along, const Real least) {
  const Real square = hn::Max(dot(along, along), least);
  const Real inverse = invert_root(square);
  return {along, hn::Mul(square, inverse), inverse};
}

/// The law of accumulate_prism_forces (forces.cpp). The difference of two lengths that are nearly
/// the same is taken as
///
///     |p| - |q| = (p - q)·(p + q) / (|p| + |q|),
///
/// which rounds in parts of the difference, not of the lengths.
HWY_INLINE Real compute_shear(const Diagonal& p, const Diagonal& q, const Real rest_difference) {
  const Real squares = dot(p.along - q.along, p.along + q.along);
  return hn::MulSub(squares, invert(hn::Add(p.length, q.length)), rest_difference);
}

/// k s²/2, which is 0 where a lane holds no prism.
HWY_INLINE void measure_side(const Real stiffness, const Real shear, Sums& sums) {
  const Real half = hn::Mul(stiffness, hn::Set(kLanes, 0.5f));
  sums.elastic = hn::MulAdd(hn::Mul(half, shear), shear, sums.elastic);
}

template <bool damped, bool measured>
HWY_INLINE void accumulate_prism_pack(const PackedPrisms& prisms, std::size_t pack,
                                      const float* position_rows, const float* velocity_rows,
                                      float* force_rows, Sums& sums) {
  const int* corner = prisms.corner.data() + 6 * kWidth * pack;
  const Real zero = hn::Zero(kLanes), least = hn::Set(kLanes, prisms.least_square);
  const Points nothing = {zero, zero, zero};
  Points x[6], v[6], f[6] = {nothing, nothing, nothing, nothing, nothing, nothing};
  gather_prism(position_rows, corner, x);
  if constexpr (damped) gather_prism(velocity_rows, corner, v);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t i = (c + 1) % 3, j = (c + 2) % 3, block = kWidth * (3 * pack + c);
    const Diagonal p = measure_diagonal(x[j + 3] - x[i], least);
    const Diagonal q = measure_diagonal(x[i + 3] - x[j], least);
    const Real stiffness = load(prisms.stiffness.data() + block);
    const Real shear = compute_shear(p, q, load(prisms.rest_difference.data() + block));
    if constexpr (measured) measure_side(stiffness, shear, sums);
    Real tension = hn::Mul(stiffness, shear);
    if constexpr (damped) {
      const Real longer = hn::Mul(dot(v[j + 3] - v[i], p.along), p.inverse);
      const Real shorter = hn::Mul(dot(v[i + 3] - v[j], q.along), q.inverse);
      const Real rate = hn::Sub(longer, shorter);
      tension = hn::MulAdd(load(prisms.damping.data() + block), rate, tension);
    }
    const Points along_p = hn::Mul(tension, p.inverse) * p.along;
    const Points along_q = hn::Mul(tension, q.inverse) * q.along;
    f[i] = f[i] + along_p;
    f[j + 3] = f[j + 3] - along_p;
    f[j] = f[j] - along_q;
    f[i + 3] = f[i + 3] + along_q;
  }
  for (std::size_t c = 0; c < 6; ++c) scatter_add(f[c], corner + c * kWidth, force_rows);
}

template <bool damped, bool measured>
void accumulate_prism_packs(const PackedModel& model, PackedState& state, Sums& sums) {
  const auto here = static_cast<std::size_t>(state.current);
  const auto packs = static_cast<std::size_t>(model.prisms.pack_count);
  for (std::size_t p = 0; p < packs; ++p) {
    accumulate_prism_pack<damped, measured>(model.prisms, p, state.position_rows[here].data(),
                                            state.velocity_rows[here].data(),
                                            state.force_rows.data(), sums);
  }
}

template <bool damped>
void accumulate_damped_prisms(const PackedModel& model, PackedState& state,
                              PackedMeasure* measure) {
  Sums sums = begin_sums();
  if (measure == nullptr) {
    accumulate_prism_packs<damped, false>(model, state, sums);
  } else {
    accumulate_prism_packs<damped, true>(model, state, sums);
    add_sums(sums, *measure);
  }
}

void accumulate_prisms(const PackedModel& model, PackedState& state, Internal&,
                       PackedMeasure* measure) noexcept {
  if (model.prisms.damping.empty()) {
    accumulate_damped_prisms<false>(model, state, measure);
  } else {
    accumulate_damped_prisms<true>(model, state, measure);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::packed_kernels
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_PACKED_PRISMS_INL_H

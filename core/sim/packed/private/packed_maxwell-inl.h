// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by packed_kernels.cpp: what relaxes beside links and angles.
#if defined(PALPATE_PACKED_MAXWELL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_PACKED_MAXWELL_INL_H
#undef PALPATE_PACKED_MAXWELL_INL_H
#else
#define PALPATE_PACKED_MAXWELL_INL_H
#endif

#include <cmath>

#include "palpate/sim/packed/private/packed_triangles-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate::packed_kernels {
namespace HWY_NAMESPACE {

// The law of maxwell_law.h. A step finds where the one before has left all, so the dashpots follow
// first, and then pull. Internal variables stand slot by slot of links, k d [N] of each lane, and
// then pack by pack of triangles: three sides [m], three cosines.

inline bool relaxes(const PackedModel& model) noexcept { return model.numbers.maxwell.ratio > 0.0; }

inline std::size_t count_slots(const PackedModel& model) noexcept {
  return static_cast<std::size_t>(model.links.first_slot.back());
}

inline std::size_t count_maxwell(const PackedModel& model) noexcept {
  return kWidth * (count_slots(model) + 6 * static_cast<std::size_t>(model.triangles.pack_count));
}

/// Lets a dashpot follow q: d = q - (q - d) kept. Returns what it leaves of q.
HWY_INLINE Real relax(const Real q, const Real kept, float* d) {
  const Real left = hn::Mul(hn::Sub(q, load(d)), kept);
  hn::Store(hn::Sub(q, left), kLanes, d);
  return left;
}

HWY_INLINE Sides relax(const Sides& q, const Real kept, float* d) {
  return {relax(q.a, kept, d), relax(q.b, kept, d + kWidth), relax(q.c, kept, d + 2 * kWidth)};
}

/// What the branches of a slice's links pull on its particles with. Unused slots lead back to the
/// particle itself and have no stiffness.
template <bool measured>
HWY_INLINE void accumulate_slice(const PackedModel& model, std::size_t s, const Real ratio,
                                 const Real kept, const float* rows, float* internal,
                                 float* force_rows, Sums& sums) {
  const PackedLinks& links = model.links;
  const int* self = model.self.data() + kWidth * s;
  const Points x = gather(rows, self);
  const Real zero = hn::Zero(kLanes), least = hn::Set(kLanes, links.least_square);
  Points f = {zero, zero, zero};
  const auto end = static_cast<std::size_t>(links.first_slot[s + 1]);
  for (auto slot = static_cast<std::size_t>(links.first_slot[s]); slot < end; ++slot) {
    const Points d = gather(rows, links.neighbour.data() + kWidth * slot) - x;
    const Real square = hn::Max(dot(d, d), least), inverse = invert_root(square);
    const Real k = load(links.stiffness.block(slot));
    const Real elastic =
        hn::MulSub(k, hn::Mul(square, inverse), load(links.rest_tension.block(slot)));
    const Real left = relax(elastic, kept, internal + kWidth * slot);
    const Real tension = hn::Mul(ratio, left);
    f = add_scaled(hn::Mul(tension, inverse), d, f);
    if constexpr (measured) {  // half of r (k q)²/(2 k): the other end has the other half
      const Real energy = hn::Mul(hn::Mul(tension, left), hn::Set(kLanes, 0.25f));
      const auto pulls = hn::Ne(k, zero);
      sums.elastic = hn::Add(sums.elastic, hn::IfThenElseZero(pulls, hn::Div(energy, k)));
    }
  }
  scatter_add(f, self, force_rows);
}

/// The bonds, angles and stretch-bend of a pack likewise.
template <AngleLaw law, bool measured>
HWY_INLINE void accumulate_branches(const PackedTriangles& triangles, std::size_t pack,
                                    const Real ratio, const Real kept, const float* rows, float* d,
                                    float* force_rows, Sums& sums) {
  const int* corner = triangles.corner.data() + 3 * kWidth * pack;
  const Points at_a = gather(rows, corner), at_b = gather(rows, corner + kWidth);
  const Points at_c = gather(rows, corner + 2 * kWidth);
  const Points side_a = at_b - at_c, side_b = at_c - at_a, side_c = at_a - at_b;
  const Sides rest = load_sides(triangles.rest_length.block(pack));
  const Measured m = measure(rest, side_a, side_b, side_c);
  const Sides stretch = relax(m.length - rest, kept, d);
  Bent bent = compute_bend(triangles, pack, m);
  bent.bend = relax(bent.bend, kept, d + 3 * kWidth);
  const Sides bond = load_sides(triangles.bond_stiffness.block(pack)) * stretch;
  const Sides tension = compute_tensions<law>(triangles, pack, m, bent, stretch);
  const Sides scale =
      Sides{ratio, ratio, ratio} * multiply_add(tension, m.pull, bond * m.direction);
  if constexpr (measured) {
    const auto is_triangle = differ(corner, corner + kWidth);
    const Real energy = hn::Mul(ratio, compute_pack_energy<law>(triangles, pack, bent, stretch));
    sums.elastic = hn::Add(sums.elastic, hn::IfThenElseZero(is_triangle, energy));
  }
  const Points pull_a = scale.a * side_a, pull_b = scale.b * side_b, pull_c = scale.c * side_c;
  scatter_add(pull_b - pull_c, corner, force_rows);
  scatter_add(pull_c - pull_a, corner + kWidth, force_rows);
  scatter_add(pull_a - pull_b, corner + 2 * kWidth, force_rows);
}

template <AngleLaw law, bool measured>
void accumulate_relaxing(const PackedModel& model, PackedState& state, Internal& internal,
                         Sums& sums) {
  const Maxwell& maxwell = model.numbers.maxwell;
  const Real ratio = hn::Set(kLanes, static_cast<float>(maxwell.ratio));
  const Real kept = hn::Set(kLanes, static_cast<float>(std::exp(-state.last_dt / maxwell.time)));
  const float* rows = state.position_rows[static_cast<std::size_t>(state.current)].data();
  for (std::size_t s = 0; s < static_cast<std::size_t>(model.slice_count); ++s) {
    accumulate_slice<measured>(model, s, ratio, kept, rows, internal.data(),
                               state.force_rows.data(), sums);
  }
  float* of_triangles = internal.data() + kWidth * count_slots(model);
  for (std::size_t p = 0; p < static_cast<std::size_t>(model.triangles.pack_count); ++p) {
    accumulate_branches<law, measured>(model.triangles, p, ratio, kept, rows,
                                       of_triangles + 6 * kWidth * p, state.force_rows.data(),
                                       sums);
  }
}

template <AngleLaw law>
void accumulate_maxwell_under(const PackedModel& model, PackedState& state, Internal& internal,
                              PackedMeasure* measure) {
  Sums sums = begin_sums();
  if (measure == nullptr) {
    accumulate_relaxing<law, false>(model, state, internal, sums);
  } else {
    accumulate_relaxing<law, true>(model, state, internal, sums);
    add_sums(sums, *measure);
  }
}

void accumulate_maxwell(const PackedModel& model, PackedState& state, Internal& internal,
                        PackedMeasure* measure) noexcept {
  if (model.angle_law == AngleLaw::gradient) {
    accumulate_maxwell_under<AngleLaw::gradient>(model, state, internal, measure);
  } else {
    accumulate_maxwell_under<AngleLaw::eq10>(model, state, internal, measure);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::packed_kernels
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_PACKED_MAXWELL_INL_H

// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by packed_kernels.cpp: what a check of the tissue needs.
#if defined(PALPATE_PACKED_COMPARE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_PACKED_COMPARE_INL_H
#undef PALPATE_PACKED_COMPARE_INL_H
#else
#define PALPATE_PACKED_COMPARE_INL_H
#endif

#include "palpate/sim/packed/private/packed_kernels.h"
#include "palpate/sim/packed/private/packed_vector-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate::packed_kernels {
namespace HWY_NAMESPACE {

/// [J] the pressure's work on the way from the last check: the force half way times the
/// displacement, which on open surfaces too is right to third order.
double compute_pressure_work(const PackedModel& model, const PackedState& state) noexcept {
  const float* now = state.position_rows[static_cast<std::size_t>(state.current)].data();
  const float* last = state.last_rows.data();
  const Real half = hn::Set(kLanes, 0.5f);
  Real sum = hn::Zero(kLanes);
  for (const int pack : state.skin.span()) {
    const int* corner = model.skin.corner.data() + 3 * kWidth * static_cast<std::size_t>(pack);
    Points move[3], middle[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const Points before = gather(last, corner + c * kWidth);
      move[c] = gather(now, corner + c * kWidth) - before;
      middle[c] = add_scaled(half, move[c], before);
    }
    const Points twice_area = cross(middle[1] - middle[0], middle[2] - middle[0]);
    sum = hn::Add(sum, dot(twice_area, move[0] + move[1] + move[2]));
  }
  return model.pressure / 6.0 * hn::GetLane(hn::SumOfLanes(kLanes, sum));
}

using Two = hn::Full128<double>;
using FourFloats = hn::Full128<float>;

/// Adds x, y, z of a row to three doubles. Pairs of them, so that every machine has the vector.
HWY_INLINE void write_row(const hn::Vec<FourFloats> row, const double* from, double* to) {
  const hn::Half<FourFloats> half;
  const auto xy = hn::PromoteTo(Two(), hn::LowerHalf(half, row));
  const auto z = hn::PromoteTo(Two(), hn::UpperHalf(half, row));
  hn::StoreU(hn::Add(hn::LoadU(Two(), from), xy), Two(), to);
  to[2] = from[2] + hn::GetLane(z);
}

/// Writes every block of 128 bits to its particle, added to what stands at `from`; from a single
/// place for all of them where `step` is 0.
template <class D>
HWY_INLINE void write_blocks(D d, hn::Vec<D> blocks, const int* particle, const double* from,
                             int step, Vec3* to) {
  if constexpr (hn::MaxLanes(d) <= 4) {
    if (*particle >= 0) write_row(blocks, from + step * *particle, to[*particle].data());
  } else {
    const hn::Half<D> half;
    write_blocks(half, hn::LowerHalf(half, blocks), particle, from, step, to);
    write_blocks(half, hn::UpperHalf(half, blocks), particle + hn::MaxLanes(half), from, step, to);
  }
}

HWY_INLINE void write_points(const Points& points, const int* particle, const double* from,
                             int step, Vec3* to) {
  const Rows rows = transpose(points);
  write_blocks(kLanes, rows.row0, particle, from, step, to);
  write_blocks(kLanes, rows.row1, particle + 1, from, step, to);
  write_blocks(kLanes, rows.row2, particle + 2, from, step, to);
  write_blocks(kLanes, rows.row3, particle + 3, from, step, to);
}

void unpack(const PackedModel& model, const Vec3* from, const float* values,
            std::span<const int> slices, Vec3* to) noexcept {
  static constexpr double kZero[3] = {0.0, 0.0, 0.0};
  const double* added = from == nullptr ? kZero : from->data();
  const int step = from == nullptr ? 0 : 3;
  for (const int slice : slices) {
    const auto s = static_cast<std::size_t>(slice);
    const int* particle = model.particle.data() + kWidth * s;
    write_points(load_points(values + 3 * kWidth * s), particle, added, step, to);
  }
}

void find_moved(const PackedModel&, float least, float product_limit, const float* anchor,
                const float* still, const PackedState& state, unsigned char* moved) noexcept {
  const Real least_square = hn::Set(kLanes, least * least);
  const Real limit_square = hn::Set(kLanes, product_limit * product_limit);
  for (const int slice : state.slices.span()) {
    const auto s = static_cast<std::size_t>(slice);
    const std::size_t at = 3 * kWidth * s;
    const Points u = load_points(state.displacement.data() + at);
    const Points move = u - load_points(anchor + at), out = u - load_points(still + at);
    const Real square = dot(move, move), longer = hn::Max(square, dot(out, out));
    // what is not a number has moved
    const auto rests =
        hn::Or(hn::Le(square, least_square), hn::Le(hn::Mul(square, longer), limit_square));
    moved[s] = !hn::AllTrue(kLanes, rests);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::packed_kernels
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_PACKED_COMPARE_INL_H

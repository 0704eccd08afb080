// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by packed_kernels.cpp: what has changed since the last look.
#if defined(PALPATE_PACKED_COMPARE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_PACKED_COMPARE_INL_H
#undef PALPATE_PACKED_COMPARE_INL_H
#else
#define PALPATE_PACKED_COMPARE_INL_H
#endif

#include "palpate/sim/dynamics/packed_kernels.h"
#include "palpate/sim/dynamics/packed_vector-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate::packed_kernels {
namespace HWY_NAMESPACE {

/// [J] the pressure's work on the way from the last look: the force half way times the way, which
/// on open surfaces too is right to third order.
double compute_pressure_work(const PackedModel& model, const PackedState& state) {
  const float* now = state.position_rows[static_cast<std::size_t>(state.current)].data();
  const float* last = state.last_rows.data();
  const Real half = hn::Set(kLanes, 0.5f);
  Real sum = hn::Zero(kLanes);
  for (const int pack : state.skin.span()) {
    const int* corner = model.skin.corner.data() + 3 * kWidth * static_cast<std::size_t>(pack);
    Points way[3], middle[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const Points before = gather(last, corner + c * kWidth);
      way[c] = gather(now, corner + c * kWidth) - before;
      middle[c] = add_scaled(half, way[c], before);
    }
    const Points twice_area = cross(middle[1] - middle[0], middle[2] - middle[0]);
    sum = hn::Add(sum, dot(twice_area, way[0] + way[1] + way[2]));
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

void unpack_all(const PackedModel& model, const Vec3* rest, const PackedState& packed,
                Vec3* position, Vec3* velocity) noexcept {
  static constexpr double kZero[3] = {0.0, 0.0, 0.0};
  for (const int slice : packed.slices.span()) {
    const auto s = static_cast<std::size_t>(slice);
    const int* particle = model.particle.data() + kWidth * s;
    const std::size_t at = 3 * kWidth * s;
    write_points(load_points(packed.displacement.data() + at), particle, rest->data(), 3, position);
    write_points(load_points(packed.velocity.data() + at), particle, kZero, 0, velocity);
  }
}

void find_moved(const PackedModel&, float least, float yield, const float* anchor,
                const float* still, const PackedState& state, unsigned char* moved) noexcept {
  const Real least_square = hn::Set(kLanes, least * least);
  const Real yield_square = hn::Set(kLanes, yield * yield);
  for (const int slice : state.slices.span()) {
    const auto s = static_cast<std::size_t>(slice);
    const std::size_t at = 3 * kWidth * s;
    const Points u = load_points(state.displacement.data() + at);
    const Points way = u - load_points(anchor + at), out = u - load_points(still + at);
    const Real square = dot(way, way), longer = hn::Max(square, dot(out, out));
    // what is not a number has moved
    const auto rests =
        hn::Or(hn::Le(square, least_square), hn::Le(hn::Mul(square, longer), yield_square));
    moved[s] = !hn::AllTrue(kLanes, rests);
  }
}

Change compare(const PackedModel& model, const Eigen::Vector3f& gravity, float farthest,
               const PackedState& state) noexcept {
  const Points g = {hn::Set(kLanes, gravity.x()), hn::Set(kLanes, gravity.y()),
                    hn::Set(kLanes, gravity.z())};
  const Real most = hn::Set(kLanes, farthest * farthest);
  Real work = hn::Zero(kLanes);
  auto within = hn::Eq(most, most);
  for (const int slice : state.slices.span()) {
    const auto s = static_cast<std::size_t>(slice);
    const std::size_t at = 3 * kWidth * s;
    const Points way = load_points(state.displacement.data() + at) -
                       load_points(state.last_displacement.data() + at);
    const Points v = load_points(state.velocity.data() + at);
    // what is not a number is not within anything
    const Real none = hn::Mul(hn::Zero(kLanes), dot(v, v));
    within = hn::And(within, hn::Le(hn::Add(dot(way, way), none), most));
    work = hn::MulAdd(load(model.mass.data() + kWidth * s), dot(g, way), work);
  }
  Change change;
  change.moved_far = !hn::AllTrue(kLanes, within);
  change.gravity_work = hn::GetLane(hn::SumOfLanes(kLanes, work));
  if (model.skin.pack_count > 0) change.pressure_work = compute_pressure_work(model, state);
  return change;
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::packed_kernels
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_PACKED_COMPARE_INL_H

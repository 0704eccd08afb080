// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by packed_kernels.cpp: what resists a change of volume.
#if defined(PALPATE_PACKED_VOLUMES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_PACKED_VOLUMES_INL_H
#undef PALPATE_PACKED_VOLUMES_INL_H
#else
#define PALPATE_PACKED_VOLUMES_INL_H
#endif

#include <hwy/contrib/math/math-inl.h>

#include "palpate/sim/dynamics/private/volume_law.h"
#include "palpate/sim/packed/private/packed_advance-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate::packed_kernels {
namespace HWY_NAMESPACE {

/// The law of volume_law.h.
struct Law {
  Real energy, slope;
};

template <bool measured>
HWY_INLINE Law compute_law(const Real j) {
  const Real half = hn::Set(kLanes, 0.5f);
  const Real at = hn::Max(j, hn::Set(kLanes, static_cast<float>(kLeastVolume)));
  const Real log = hn::Log(kLanes, at), inverse = invert(at), below = hn::Sub(j, at);
  const Real slope = hn::Mul(log, inverse);
  const Real curvature = hn::Mul(hn::Mul(hn::Sub(hn::Set(kLanes, 1.0f), log), inverse), inverse);
  Law law;
  law.slope = hn::MulAdd(below, curvature, slope);
  if constexpr (measured) {
    const Real line = hn::MulAdd(hn::Mul(half, below), curvature, slope);
    law.energy = hn::MulAdd(hn::Mul(half, log), log, hn::Mul(below, line));
  }
  return law;
}

/// The sides of tetrahedra from their first corner, and the faces between these: six times the
/// volume's slopes at the three other corners.
struct Faces {
  Points b, c, d;
  Real six_volumes;
};

HWY_INLINE Faces compute_faces(const float* rows, const int* corner) {
  const Points a = gather(rows, corner);
  const Points ab = gather(rows, corner + kWidth) - a;
  const Points ac = gather(rows, corner + 2 * kWidth) - a;
  const Points ad = gather(rows, corner + 3 * kWidth) - a;
  Faces faces = {cross(ac, ad), cross(ad, ab), cross(ab, ac), Real()};
  faces.six_volumes = dot(ab, faces.b);
  return faces;
}

/// Lanes that hold a tetrahedron.
HWY_INLINE hn::Mask<Lanes> is_tetrahedron(const int* corner) {
  return differ(corner, corner + kWidth);
}

/// Adds the volumes of a pack to the sums of its corners, and keeps its faces for push_pack(). One
/// after the other, for a row may come twice; a loop would cost as much as it adds.
HWY_INLINE void add_volumes(const PackedVolumes& volumes, std::size_t pack, const float* rows,
                            float* faces, float* sums) {
  const int* corner = volumes.corner.data() + 4 * kWidth * pack;
  const Faces found = compute_faces(rows, corner);
  store_points(found.b, faces);
  store_points(found.c, faces + 3 * kWidth);
  store_points(found.d, faces + 6 * kWidth);
  float* six_volumes = faces + 9 * kWidth;
  hn::Store(found.six_volumes, kLanes, six_volumes);
  for (std::size_t c = 0; c < 4; ++c) {
    const int* rows_of_corner = corner + c * kWidth;
#pragma GCC unroll 16
    for (std::size_t k = 0; k < kWidth; ++k) sums[rows_of_corner[k]] += six_volumes[k];
  }
}

HWY_INLINE Faces load_faces(const float* faces) {
  return {load_points(faces), load_points(faces + 3 * kWidth), load_points(faces + 6 * kWidth),
          load(faces + 9 * kWidth)};
}

/// Makes of the volume around each particle of a slice the pressure there, and leaves that as the
/// fourth number of its position row.
template <bool measured>
HWY_INLINE void average_slice(const PackedVolumes& volumes, std::size_t s, float* rows, float* sums,
                              Sums& measure) {
  HWY_ALIGN float lanes[kWidth];
  const Real sum = load(sums + kWidth * s);
  hn::Store(hn::Zero(kLanes), kLanes, sums + kWidth * s);
  const Real inverse_rest = load(volumes.inverse_rest_around.data() + kWidth * s);
  const Real stiffness = load(volumes.stiffness_around.data() + kWidth * s);
  const Real j = hn::Mul(sum, inverse_rest);
  const Law law = compute_law<measured>(j);
  hn::Store(hn::Mul(stiffness, law.slope), kLanes, lanes);
  for (std::size_t r = 0; r < kWidth; ++r) rows[4 * (kWidth * s + r) + 3] = lanes[r];
  if constexpr (measured) {
    const auto any = hn::Gt(inverse_rest, hn::Zero(kLanes));
    const Real energy = hn::Div(hn::Mul(stiffness, law.energy), inverse_rest);
    measure.elastic = hn::Add(measure.elastic, hn::IfThenElseZero(any, energy));
    measure.smallest_mean =
        hn::Min(hn::IfThenElse(any, j, measure.smallest_mean), measure.smallest_mean);
  }
}

template <bool nodal, bool measured>
HWY_INLINE void push_pack(const PackedVolumes& volumes, std::size_t pack, const float* rows,
                          const float* kept, float* force_rows, Sums& sums) {
  const int* corner = volumes.corner.data() + 4 * kWidth * pack;
  Faces faces;
  if constexpr (nodal) {
    faces = load_faces(kept);
  } else {
    faces = compute_faces(rows, corner);
  }
  const Real inverse_rest = load(volumes.inverse_rest.data() + kWidth * pack);
  const Real j = hn::Mul(faces.six_volumes, inverse_rest);
  Real pressure = hn::Zero(kLanes);
  if (!volumes.stiffness.empty()) {
    const Real stiffness = load(volumes.stiffness.data() + kWidth * pack);
    const Law law = compute_law<measured>(j);
    pressure = hn::Mul(stiffness, law.slope);
    if constexpr (measured) {
      const Real energy = hn::Div(hn::Mul(stiffness, law.energy), inverse_rest);
      sums.elastic = hn::Add(sums.elastic, hn::IfThenElseZero(is_tetrahedron(corner), energy));
    }
  }
  if constexpr (nodal) {
    for (std::size_t c = 0; c < 4; ++c) {
      pressure = hn::Add(pressure, gather_fourth(rows, corner + c * kWidth));
    }
  }
  if constexpr (measured) {
    sums.smallest_volume = hn::Min(hn::IfThenElse(is_tetrahedron(corner), j, sums.smallest_volume),
                                   sums.smallest_volume);
  }
  const Real pull = hn::Neg(pressure);
  const Points at_b = pull * faces.b, at_c = pull * faces.c, at_d = pull * faces.d;
  scatter_add(pressure * (faces.b + faces.c + faces.d), corner, force_rows);
  scatter_add(at_b, corner + kWidth, force_rows);
  scatter_add(at_c, corner + 2 * kWidth, force_rows);
  scatter_add(at_d, corner + 3 * kWidth, force_rows);
}

template <bool nodal, bool measured>
void push_all(const PackedModel& model, PackedState& state, Sums& sums) {
  const PackedVolumes& volumes = model.volumes;
  const auto packs = static_cast<std::size_t>(volumes.pack_count);
  float* rows = state.position_rows[static_cast<std::size_t>(state.current)].data();
  float* forces = state.force_rows.data();
  [[maybe_unused]] float* faces = state.faces.data();
  if constexpr (nodal) {
    float* volumes_around = state.volume_sums.data();
    for (std::size_t p = 0; p < packs; ++p) {
      add_volumes(volumes, p, rows, faces + kFaceColumns * kWidth * p, volumes_around);
    }
    for (std::size_t s = 0; s < static_cast<std::size_t>(model.slice_count); ++s) {
      average_slice<measured>(volumes, s, rows, volumes_around, sums);
    }
  }
  for (std::size_t p = 0; p < packs; ++p) {
    const float* kept = nodal ? faces + kFaceColumns * kWidth * p : nullptr;
    push_pack<nodal, measured>(volumes, p, rows, kept, forces, sums);
  }
}

template <bool nodal>
void push_measured(const PackedModel& model, PackedState& state, PackedMeasure* measure) {
  Sums sums = begin_sums();
  if (measure == nullptr) {
    push_all<nodal, false>(model, state, sums);
  } else {
    push_all<nodal, true>(model, state, sums);
    add_sums(sums, *measure);
  }
}

void accumulate_volumes(const PackedModel& model, PackedState& state, Internal&,
                        PackedMeasure* measure) noexcept {
  if (model.volumes.stiffness_around.empty()) {
    push_measured<false>(model, state, measure);
  } else {
    push_measured<true>(model, state, measure);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::packed_kernels
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_PACKED_VOLUMES_INL_H

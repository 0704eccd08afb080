// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// The law of volume is followed down to this part of the rest volume, and continued below it as a
/// parabola: finite where a tetrahedron is flat or turned inside out, and still driving it back.
/// A tissue pressed by a quarter of its thickness goes down to 0.4 [accuracy: quarter].
inline constexpr double kLeastVolume = 0.2;

/// Energy [-], its slope and its curvature, per bulk and rest volume, as functions of J:
///
///     e = (ln J)² / 2,   e' = ln J / J,   e'' = (1 - ln J) / J²
struct VolumeLaw {
  double energy, slope, curvature;
};

inline VolumeLaw compute_volume_law(double j) noexcept {
  const double at = std::max(j, kLeastVolume), log = std::log(at);
  const VolumeLaw law = {0.5 * log * log, log / at, (1.0 - log) / (at * at)};
  const double below = j - at;
  return {law.energy + below * (law.slope + 0.5 * below * law.curvature),
          law.slope + below * law.curvature, law.curvature};
}

/// [m³] of tetrahedron t.
inline double measure_volume(const Volumes& volumes, std::size_t t,
                             std::span<const Vec3> x) noexcept {
  const auto& [a, b, c, d] = volumes.corners[t];
  return compute_volume(x[a], x[b], x[c], x[d]);
}

/// The rows of the tetrahedra around particle i, of Volumes or Elastic.
template <class Table>
std::span<const int> list_around(const Table& table, std::size_t i) noexcept {
  const auto first = static_cast<std::size_t>(table.first_around[i]);
  return {table.around.data() + first, static_cast<std::size_t>(table.first_around[i + 1]) - first};
}

/// The sums over all tetrahedra around a particle.
struct VolumeAround {
  double rest = 0.0;  ///< [m³]
  double now = 0.0;   ///< [m³]
  double bulk = 0.0;  ///< [Pa] mean, weighted by rest volume
};

inline VolumeAround measure_around(const Volumes& volumes, std::size_t i,
                                   std::span<const Vec3> x) noexcept {
  VolumeAround around;
  for (const int row : list_around(volumes, i)) {
    const auto t = static_cast<std::size_t>(row);
    around.rest += volumes.rest_volume[t];
    around.now += measure_volume(volumes, t, x);
    around.bulk += volumes.bulk[t] * volumes.rest_volume[t];
  }
  if (around.rest > 0.0) around.bulk /= around.rest;
  return around;
}

/// What the volume v of a tetrahedron changes by as its corners move: column c is dv/dx_c [m²], a
/// third of the area of the face opposite, inwards. The columns sum to 0.
inline Mat34 compute_volume_slopes(const Vec3& a, const Vec3& b, const Vec3& c,
                                   const Vec3& d) noexcept {
  const Vec3 ab = b - a, ac = c - a, ad = d - a;
  Mat34 slopes;
  slopes.col(1) = ac.cross(ad) / 6.0;
  slopes.col(2) = ad.cross(ab) / 6.0;
  slopes.col(3) = ab.cross(ac) / 6.0;
  slopes.col(0) = -(slopes.col(1) + slopes.col(2) + slopes.col(3));
  return slopes;
}

}  // namespace palpate

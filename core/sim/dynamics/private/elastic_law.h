// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/private/volume_law.h"

namespace palpate {

/// A tetrahedron of Elastic or Hyperelastic at rest.
struct RestTetrahedron {
  template <class Table>
  RestTetrahedron(const Table& table, std::size_t t, std::span<const Vec3> rest) noexcept
      : corners(table.corners[t]),
        slopes(compute_volume_slopes(rest[corners[0]], rest[corners[1]], rest[corners[2]],
                                     rest[corners[3]])),
        volume(palpate::compute_volume(rest[corners[0]], rest[corners[1]], rest[corners[2]],
                                       rest[corners[3]])) {}

  /// du/dX [-] of displacements that `at(i)` [m] gives: sum of u_k g_kᵀ, where g_k = slope_k / V is
  /// the gradient of the function that is 1 at corner k and 0 at the others.
  template <class At>
  Mat3 compute_gradient(At at) const noexcept {
    Mat3 gradient = Mat3::Zero();
    for (int k = 0; k < 4; ++k) gradient += at(corners[k]) * slopes.col(k).transpose();
    return gradient / volume;
  }

  std::array<int, 4> corners;
  Mat34 slopes;   ///< [m²] dV/dx of the corners
  double volume;  ///< [m³]
};
static_assert(sizeof(RestTetrahedron) == 120 && alignof(RestTetrahedron) == 8);

/// The mean trace of the strain around a particle, by rest volume, and what resists it.
struct DilatationAround {
  double volume = 0.0;      ///< [m³]
  double dilatation = 0.0;  ///< [-]
  double lame = 0.0;        ///< [Pa]
};

template <class At>
DilatationAround measure_dilatation(const Elastic& elastic, std::size_t i,
                                    std::span<const Vec3> rest, At at) noexcept {
  DilatationAround around;
  for (const int row : list_around(elastic, i)) {
    const auto t = static_cast<std::size_t>(row);
    const RestTetrahedron tetrahedron(elastic, t, rest);
    around.volume += tetrahedron.volume;
    around.dilatation += tetrahedron.volume * tetrahedron.compute_gradient(at).trace();
    around.lame += tetrahedron.volume * elastic.lame[t];
  }
  if (!(around.volume > 0.0)) return around;
  around.dilatation /= around.volume;
  around.lame /= around.volume;
  return around;
}

/// [J] of displacements u(i) [m]: with H = du/dX, e = (H + Hᵀ)/2 and theta = tr e,
///
///     V (mu e:e + (1 - s) lambda theta²/2) over tetrahedra,  s/4 lambda_a V_a theta_a²/2 over
///     particles
template <class At>
double compute_strain_energy(const Elastic& elastic, std::span<const Vec3> rest, At u) noexcept {
  double sum = 0.0;
  const double share = elastic.nodal_share;
  for (std::size_t t = 0; t < elastic.corners.size(); ++t) {
    const RestTetrahedron tetrahedron(elastic, t, rest);
    const Mat3 gradient = tetrahedron.compute_gradient(u);
    const Mat3 strain = 0.5 * (gradient + gradient.transpose());
    const double theta = strain.trace();
    sum += tetrahedron.volume * (elastic.shear[t] * strain.squaredNorm() +
                                 0.5 * (1.0 - share) * elastic.lame[t] * theta * theta);
  }
  for (std::size_t i = 0; share > 0.0 && i + 1 < elastic.first_around.size(); ++i) {
    const DilatationAround around = measure_dilatation(elastic, i, rest, u);
    sum += 0.125 * share * around.lame * around.volume * around.dilatation * around.dilatation;
  }
  return sum;
}

}  // namespace palpate

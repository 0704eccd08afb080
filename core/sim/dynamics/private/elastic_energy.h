// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/private/elastic_law.h"
#include "palpate/sim/dynamics/private/prism_law.h"
#include "palpate/sim/dynamics/private/tensions.h"
#include "palpate/sim/dynamics/private/volume_law.h"

namespace palpate {

// Each for particles that are wherever `at(i)` [m] says.

/// Eq 8: k (l - L)² / 2 over all links.
template <class At>
double compute_link_energy(const Links& links, At at) noexcept {
  double sum = 0.0;
  for (std::size_t l = 0; l < links.ends.size(); ++l) {
    const auto [i, j] = links.ends[l];
    const double stretch = Vec3(at(j) - at(i)).norm() - links.rest_length[l];
    sum += 0.5 * links.stiffness[l] * stretch * stretch;
  }
  return sum;
}

/// Eq 9 and Eq 11 of one triangle: K_theta q² / 2 + K_btheta q (d + d') over its corners, d and d'
/// of the arms.
inline double compute_angle_energy(const AngleRow& row, const PerSide<double>& length,
                                   const PerSide<double>& cosine) noexcept {
  double sum = 0.0;
  for (int corner = 0; corner < 3; ++corner) {
    const int one = (corner + 1) % 3, two = (corner + 2) % 3;
    const double bend = cosine[corner] - row.rest_cosine[corner];
    const double stretch = length[one] + length[two] - row.rest_length[one] - row.rest_length[two];
    sum +=
        (0.5 * row.bend_stiffness[corner] * bend + row.stretch_coupling[corner] * stretch) * bend;
  }
  return sum;
}

template <class At>
double compute_angle_energy(const Angles& angles, At at) noexcept {
  double sum = 0.0;
  for (std::size_t row = 0; row < angles.corners.size(); ++row) {
    const auto [i, j, k] = angles.corners[row];
    const Vec3 a = at(i), b = at(j), c = at(k);
    const PerSide<double> length = {(b - c).norm(), (c - a).norm(), (a - b).norm()};
    const PerSide<double> inverse = invert_lengths(angles.rest_length[row], length).inverse;
    sum += compute_angle_energy(AngleRow(angles, row), length, compute_cosines(length, inverse));
  }
  return sum;
}

/// B V e(J) over all tetrahedra, and of the nodal share B_a V_a/4 e(J_a) over all particles, V_a
/// the volume around one.
template <class At>
double compute_volume_energy(const Volumes& volumes, At at) noexcept {
  double sum = 0.0;
  const double share = volumes.nodal_share;
  const auto measure = [&](std::size_t t) {
    const auto& [a, b, c, d] = volumes.corners[t];
    return compute_volume(at(a), at(b), at(c), at(d));
  };
  for (std::size_t t = 0; share < 1.0 && t < volumes.corners.size(); ++t) {
    const double rest = volumes.rest_volume[t];
    sum += (1.0 - share) * volumes.bulk[t] * rest * compute_volume_law(measure(t) / rest).energy;
  }
  for (std::size_t i = 0; share > 0.0 && i + 1 < volumes.first_around.size(); ++i) {
    double rest = 0.0, now = 0.0, stiffness = 0.0;
    for (const int row : list_around(volumes, i)) {
      const auto t = static_cast<std::size_t>(row);
      rest += volumes.rest_volume[t];
      now += measure(t);
      stiffness += volumes.bulk[t] * volumes.rest_volume[t];
    }
    if (rest > 0.0) sum += 0.25 * share * stiffness * compute_volume_law(now / rest).energy;
  }
  return sum;
}

/// Of a linear solid; see compute_strain_energy.
template <class At>
double compute_linear_energy(const TissueModel& model, At at) noexcept {
  const auto u = [&](int i) noexcept -> Vec3 { return at(i) - model.rest_position[i]; };
  return compute_strain_energy(model.elastic, model.rest_position, u);
}

/// h |x - X|² / 2 over all particles, X their places at rest.
template <class At>
double compute_home_energy(const TissueModel& model, At at) noexcept {
  double sum = 0.0;
  for (int i = 0; i < static_cast<int>(model.home.size()); ++i) {
    sum += 0.5 * model.home[i] * Vec3(at(i) - model.rest_position[i]).squaredNorm();
  }
  return sum;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "palpate/sim/dynamics/private/elastic_law.h"

namespace palpate {

// The laws of tetrahedra at finite strain as functions of the deformation gradient F: energy over
// rest volume, and its slope P = dW/dF, which forces and tangent share.

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// dJ/dF, whose columns are the cross products of those of F.
inline Mat3 compute_cofactor(const Mat3& f) noexcept {
  Mat3 cofactor;
  cofactor.col(0) = f.col(1).cross(f.col(2));
  cofactor.col(1) = f.col(2).cross(f.col(0));
  cofactor.col(2) = f.col(0).cross(f.col(1));
  return cofactor;
}

/// F = R S of a deformation gradient: the rotation R, and the trace of the symmetric S. R is proper
/// whatever F is, so that S of a tetrahedron turned inside out has one negative eigenvalue, its
/// smallest. Where two of S sum to 0 there is more than one such R, and this is one of them.
struct Polar {
  Mat3 rotation;
  double trace = 0.0;
};

Polar compute_polar(const Mat3& f) noexcept;

/// [Pa] What a tetrahedron has of Lamé's constants.
struct Moduli {
  double lame = 0.0, shear = 0.0;
};

/// Principal stretches, the largest first; the last is negative inside out.
using Stretches = std::array<double, 3>;

/// Corotated linear elasticity [laws: corotated]: Hooke's law in what the rotation R leaves of F,
///
///     W = mu |F - R|² + lambda/2 (tr RᵀF - 3)²,   P = 2 mu (F - R) + lambda (tr RᵀF - 3) R
struct Corotated {
  static double compute_energy(const Mat3& f, const Moduli& moduli) noexcept {
    const Polar polar = compute_polar(f);
    const double theta = polar.trace - 3.0;
    return moduli.shear * (f - polar.rotation).squaredNorm() + 0.5 * moduli.lame * theta * theta;
  }
  static Mat3 compute_stress(const Mat3& f, const Moduli& moduli) noexcept {
    const Polar polar = compute_polar(f);
    return 2.0 * moduli.shear * (f - polar.rotation) +
           moduli.lame * (polar.trace - 3.0) * polar.rotation;
  }
  static Mat9 compute_tangent(const Mat3& f, const Moduli& moduli);

  /// [-] By how much more than at rest shear is resisted, in parts of mu: what turns against the
  /// rotation has the eigenvalues 2 mu + 2 (lambda (tr S - 3) - 2 mu)/(s_i + s_j), 0 at rest.
  static double compute_stiffening(const Stretches& stretches, const Moduli& moduli) noexcept {
    constexpr double kLeast = 1e-6;
    const auto [one, two, three] = stretches;
    const double pull = moduli.lame / moduli.shear * (one + two + three - 3.0) - 2.0;
    const double sum = pull > 0.0 ? two + three : one + two;
    return std::max(0.0, 2.0 + 2.0 * pull / std::max(sum, kLeast));
  }
  /// [Pa] Of what is resisted as the areas of faces are: nothing but the means.
  static constexpr double kAreaShear = 0.0;
  static constexpr bool kAreaLame = false;
};

/// The stable neo-Hookean law of [Smith18], with its constants by Lamé's [laws: neo-hookean]:
///
///     W = 2/3 mu (I - 3 - ln((I + 1)/4)) - mu (J - 1) + k/2 (J - 1)²
///     P = 4/3 mu I/(I + 1) F + (k (J - 1) - mu) cof F,   k = lambda + 5/6 mu,   I = |F|²
struct NeoHookean {
  static constexpr double kAreaShear = 5.0 / 6.0;
  static constexpr bool kAreaLame = true;

  static double find_bulk(const Moduli& moduli) noexcept {
    return moduli.lame + kAreaShear * moduli.shear;
  }
  static double compute_energy(const Mat3& f, const Moduli& moduli) noexcept {
    const double more = f.squaredNorm() - 3.0, swell = f.determinant() - 1.0;
    return moduli.shear * (2.0 / 3.0 * (more - std::log1p(0.25 * more)) - swell) +
           0.5 * find_bulk(moduli) * swell * swell;
  }
  static Mat3 compute_stress(const Mat3& f, const Moduli& moduli) noexcept {
    const double square = f.squaredNorm();
    const Mat3 cofactor = compute_cofactor(f);
    const double swell = f.col(0).dot(cofactor.col(0)) - 1.0;
    return (4.0 * moduli.shear * square / (3.0 * (square + 1.0))) * f +
           (find_bulk(moduli) * swell - moduli.shear) * cofactor;
  }
  static Mat9 compute_tangent(const Mat3& f, const Moduli& moduli);

  static double compute_stiffening(const Stretches& stretches, const Moduli& moduli) noexcept {
    constexpr double kAtRest = 2.5;
    const auto [one, two, three] = stretches;
    const double square = one * one + two * two + three * three, more = square + 1.0;
    const double pressure =
        find_bulk(moduli) / moduli.shear * (one * two * three - 1.0) - 1.0;  // over mu
    const double now =
        4.0 * square / (3.0 * more) + 8.0 * square / (3.0 * more * more) + std::abs(pressure) * one;
    return std::max(0.0, now - kAtRest);
  }
};

/// The law's own part of lambda in a tetrahedron.
inline Moduli find_moduli(const Hyperelastic& table, std::size_t t) noexcept {
  return {(1.0 - table.nodal_share) * table.lame[t], table.shear[t]};
}

/// F = I + du/dX of particles at `at(i)` [m].
template <class At>
Mat3 compute_deformation(const RestTetrahedron& tetrahedron, std::span<const Vec3> rest,
                         At at) noexcept {
  return Mat3::Identity() +
         tetrahedron.compute_gradient([&](int i) noexcept -> Vec3 { return at(i) - rest[i]; });
}

/// The mean J around a particle, by rest volume, and what resists its change.
struct MeanVolume {
  double rest = 0.0;   ///< [m³]
  double swell = 0.0;  ///< [-] J - 1
  double lame = 0.0;   ///< [Pa]
};

template <class At>
MeanVolume measure_mean(const Hyperelastic& table, std::size_t i, std::span<const Vec3> rest,
                        At at) noexcept {
  MeanVolume mean;
  double now = 0.0;
  for (const int row : list_around(table, i)) {
    const auto t = static_cast<std::size_t>(row);
    const auto [a, b, c, d] = table.corners[t];
    const double volume = compute_volume(rest[a], rest[b], rest[c], rest[d]);
    mean.rest += volume;
    mean.lame += volume * table.lame[t];
    now += compute_volume(at(a), at(b), at(c), at(d));
  }
  if (!(mean.rest > 0.0)) return mean;
  mean.lame /= mean.rest;
  mean.swell = now / mean.rest - 1.0;
  return mean;
}

/// visit(particle, mean) for the particles of the nodal share.
template <class At, class Visit>
void for_each_mean(const Hyperelastic& table, std::span<const Vec3> rest, At at,
                   Visit visit) noexcept {
  if (!(table.nodal_share > 0.0)) return;
  for (std::size_t i = 0; i + 1 < table.first_around.size(); ++i) {
    const MeanVolume mean = measure_mean(table, i, rest, at);
    if (mean.rest > 0.0) visit(i, mean);
  }
}

/// [J] W V over tetrahedra, and s/4 lambda_a V_a (J_a - 1)²/2 over particles.
template <class Density, class At>
double compute_hyperelastic_energy(const Hyperelastic& table, std::span<const Vec3> rest,
                                   At at) noexcept {
  double sum = 0.0;
  for (std::size_t t = 0; t < table.corners.size(); ++t) {
    const RestTetrahedron tetrahedron(table, t, rest);
    const Mat3 f = compute_deformation(tetrahedron, rest, at);
    sum += tetrahedron.volume * Density::compute_energy(f, find_moduli(table, t));
  }
  for_each_mean(table, rest, at, [&](std::size_t, const MeanVolume& mean) noexcept {
    sum += 0.125 * table.nodal_share * mean.lame * mean.rest * mean.swell * mean.swell;
  });
  return sum;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/elastic_law.h"
#include "palpate/sim/dynamics/private/hyperelastic_law.h"

namespace palpate {

namespace {

/// f_k -= (P + P_v) slope_k at the corners of every tetrahedron, slope_k = V g_k, with the law's
/// P(F) and the stress of a viscosity eta against the rate of Green's strain [laws: viscosity],
///
///     P_v = 2 eta F E',   E' = (FᵀF' + F'ᵀF)/2,   F' = sum of v_k g_kᵀ
///
/// and of the nodal share s the mean J around each particle, as accumulate_volume_forces (forces.h)
/// takes it: f_c -= s/4 lambda_a (J_a - 1) dv/dx_c. None depends on how the body lies: momentum and
/// angular momentum are kept.
template <class Density>
void accumulate(const Hyperelastic& table, std::span<const Vec3> rest, std::span<const Vec3> x,
                std::span<const Vec3> v, std::span<Vec3> f) noexcept {
  const auto at = [x](int i) noexcept -> const Vec3& { return x[i]; };
  const auto rate_at = [v](int i) noexcept -> const Vec3& { return v[i]; };
  for (std::size_t t = 0; t < table.corners.size(); ++t) {
    const RestTetrahedron tetrahedron(table, t, rest);
    const Mat3 deformation = compute_deformation(tetrahedron, rest, at);
    Mat3 stress = Density::compute_stress(deformation, find_moduli(table, t));
    if (table.viscosity[t] > 0.0) {
      const Mat3 rate = deformation.transpose() * tetrahedron.compute_gradient(rate_at);
      stress += table.viscosity[t] * deformation * (rate + rate.transpose());
    }
    for (int k = 0; k < 4; ++k) f[tetrahedron.corners[k]] -= stress * tetrahedron.slopes.col(k);
  }
  for_each_mean(table, rest, at, [&](std::size_t i, const MeanVolume& mean) noexcept {
    const double pressure = 0.25 * table.nodal_share * mean.lame * mean.swell;
    for (const int t : list_around(table, i)) {
      const auto& [a, b, c, d] = table.corners[t];
      const Mat34 slopes = compute_volume_slopes(x[a], x[b], x[c], x[d]);
      for (int k = 0; k < 4; ++k) f[table.corners[t][k]] -= pressure * slopes.col(k);
    }
  });
}

}  // namespace

/// f_k -= sigma slope_k at the corners of every tetrahedron, with slope_k = V g_k and Hooke's law
///
///     sigma = mu (H + Hᵀ) + (1 - s) lambda tr(H) I,   H = sum of u_k g_kᵀ,   u = x - X + tau v
///
/// where tau is the damping time: strain rates count as so much more strain (Kelvin and Voigt). Of
/// the nodal share s the mean trace around each particle is taken, as accumulate_volume_forces
/// does. Momentum is kept; angular momentum about the places at rest, not about those of the
/// moment.
void accumulate_elastic_forces(const Elastic& elastic, std::span<const Vec3> rest,
                               std::span<const Vec3> x, std::span<const Vec3> v,
                               std::span<Vec3> f) noexcept {
  const double share = elastic.nodal_share, tau = elastic.damping_time;
  const auto u = [&](int i) noexcept -> Vec3 { return x[i] - rest[i] + tau * v[i]; };
  for (std::size_t t = 0; t < elastic.corners.size(); ++t) {
    const RestTetrahedron tetrahedron(elastic, t, rest);
    const Mat3 gradient = tetrahedron.compute_gradient(u);
    const Mat3 stress = elastic.shear[t] * (gradient + gradient.transpose()) +
                        (1.0 - share) * elastic.lame[t] * gradient.trace() * Mat3::Identity();
    for (int k = 0; k < 4; ++k) {
      f[tetrahedron.corners[k]] -= stress * tetrahedron.slopes.col(k);
    }
  }
  for (std::size_t i = 0; share > 0.0 && i + 1 < elastic.first_around.size(); ++i) {
    const DilatationAround around = measure_dilatation(elastic, i, rest, u);
    const double pressure = 0.25 * share * around.lame * around.dilatation;
    for (const int t : list_around(elastic, i)) {
      const RestTetrahedron tetrahedron(elastic, static_cast<std::size_t>(t), rest);
      for (int k = 0; k < 4; ++k) {
        f[tetrahedron.corners[k]] -= pressure * tetrahedron.slopes.col(k);
      }
    }
  }
}

void accumulate_corotated_forces(const Hyperelastic& table, std::span<const Vec3> rest,
                                 std::span<const Vec3> x, std::span<const Vec3> v,
                                 std::span<Vec3> f) noexcept {
  accumulate<Corotated>(table, rest, x, v, f);
}

void accumulate_neo_hookean_forces(const Hyperelastic& table, std::span<const Vec3> rest,
                                   std::span<const Vec3> x, std::span<const Vec3> v,
                                   std::span<Vec3> f) noexcept {
  accumulate<NeoHookean>(table, rest, x, v, f);
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/elastic_law.h"
#include "palpate/sim/dynamics/private/hyperelastic_law.h"
#include "palpate/sim/dynamics/private/laws.h"
#include "palpate/sim/dynamics/private/prism_law.h"
#include "palpate/sim/dynamics/private/tensions.h"

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

/// c (w·n) n along a link, c w in all directions, w = v_j - v_i (accumulate_links, forces.cpp).
void accumulate_link_damping(const Links& links, DampingLaw law, std::span<const Vec3> x,
                             std::span<const Vec3> v, std::span<Vec3> f) noexcept {
  for (std::size_t l = 0; l < links.ends.size(); ++l) {
    if (links.damping[l] == 0.0) continue;
    const auto [i, j] = links.ends[l];
    Vec3 rate = v[j] - v[i];
    if (law == DampingLaw::axis) {
      const Vec3 d = x[j] - x[i];
      const double length = d.norm();
      if (length <= kNoDirection * links.rest_length[l]) continue;
      const Vec3 n = d / length;
      rate = rate.dot(n) * n;
    }
    const Vec3 pull = links.damping[l] * rate;
    f[i] += pull;
    f[j] -= pull;
  }
}

/// c ds/dt of each side (accumulate_prism_forces, forces.cpp).
void accumulate_prism_damping(const Prisms& prisms, std::span<const Vec3> x,
                              std::span<const Vec3> v, std::span<Vec3> f) noexcept {
  const auto at = [x](int i) -> const Vec3& { return x[static_cast<std::size_t>(i)]; };
  for (std::size_t p = 0; p < prisms.corners.size(); ++p) {
    for (int c = 0; c < 3; ++c) {
      if (prisms.shear_damping[p][c] == 0.0) continue;
      const PrismSide side(prisms.corners[p], c);
      const auto [i, j, k, l] = side.ends;
      const Diagonals now(side, at);
      const double rate = (v[j] - v[i]).dot(now.unit[0]) - (v[l] - v[k]).dot(now.unit[1]);
      const double tension = prisms.shear_damping[p][c] * rate;
      f[i] += tension * now.unit[0];
      f[j] -= tension * now.unit[0];
      f[k] -= tension * now.unit[1];
      f[l] += tension * now.unit[1];
    }
  }
}

/// P_v = 2 eta F E' of every tetrahedron (accumulate, above, [laws: viscosity]).
void accumulate_viscous_damping(const Hyperelastic& table, std::span<const Vec3> rest,
                                std::span<const Vec3> x, std::span<const Vec3> v,
                                std::span<Vec3> f) noexcept {
  const auto at = [x](int i) noexcept -> const Vec3& { return x[i]; };
  const auto rate_at = [v](int i) noexcept -> const Vec3& { return v[i]; };
  for (std::size_t t = 0; t < table.corners.size(); ++t) {
    if (!(table.viscosity[t] > 0.0)) continue;
    const RestTetrahedron tetrahedron(table, t, rest);
    const Mat3 deformation = compute_deformation(tetrahedron, rest, at);
    const Mat3 rate = deformation.transpose() * tetrahedron.compute_gradient(rate_at);
    const Mat3 stress = table.viscosity[t] * deformation * (rate + rate.transpose());
    for (int k = 0; k < 4; ++k) f[tetrahedron.corners[k]] -= stress * tetrahedron.slopes.col(k);
  }
}

void accumulate_damping(const TissueModel& model, std::span<const Vec3> x, std::span<const Vec3> v,
                        std::span<Vec3> f) noexcept {
  laws::for_each([&]<class Law>(Law) {
    if constexpr (requires { Law::accumulate_damping(model, x, v, f); }) {
      Law::accumulate_damping(model, x, v, f);
    }
  });
  if (model.drag != 0.0) accumulate_drag(model.mass, model.drag, v, f);
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/elastic_law.h"

namespace palpate {

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

}  // namespace palpate

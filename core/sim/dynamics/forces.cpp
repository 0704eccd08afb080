// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/forces.h"

#include <algorithm>

#include "palpate/sim/dynamics/private/laws.h"
#include "palpate/sim/dynamics/private/prism_law.h"
#include "palpate/sim/dynamics/private/tensions.h"
#include "palpate/sim/dynamics/private/volume_law.h"

namespace palpate {
namespace {

/// Adds to `f` [N] the pull of every link at positions `x` [m] and velocities `v` [m/s]:
///
///     axis:       f_i += (k (|d| - L) + c (v_j - v_i)·n) n
///     isotropic:  f_i += k (|d| - L) n + c (v_j - v_i)
///     f_j -= the same,   d = x_j - x_i,  n = d/|d|
///
/// Hooke's law (Eq 1, 8) with damping (Eq 2); along the link [Provot95] it conserves the angular
/// momentum and leaves rotation alone, isotropic it does neither. The two pulls cancel, so the sum
/// of `f` is unchanged. A link of zero length has no direction to pull in.
template <DampingLaw law>
void accumulate_links(const Links& links, std::span<const Vec3> x, std::span<const Vec3> v,
                      std::span<Vec3> f) noexcept {
  for (std::size_t l = 0; l < links.ends.size(); ++l) {
    const auto [i, j] = links.ends[l];
    const Vec3 d = x[j] - x[i], w = v[j] - v[i];
    const double length = d.norm();
    const bool undirected = length <= kNoDirection * links.rest_length[l];
    const Vec3 n = undirected ? Vec3(Vec3::Zero()) : Vec3(d / length);
    const double tension = links.stiffness[l] * (length - links.rest_length[l]);
    Vec3 pull;
    if constexpr (law == DampingLaw::axis) {
      pull = (tension + links.damping[l] * w.dot(n)) * n;
    } else {
      pull = tension * n + links.damping[l] * w;
    }
    f[i] += pull;
    f[j] -= pull;
  }
}

/// Adds the tensions that `compute_tensions` finds in the sides of every triangle. Each length is
/// computed once, and there is no arc cosine. A side of tension tau pulls its ends together by
/// tau d/|d|, so momentum and angular momentum are conserved whatever the tensions are.
template <class Tensions>
void accumulate_sides(const Angles& angles, std::span<const Vec3> x, std::span<Vec3> f,
                      Tensions compute_tensions) noexcept {
  for (std::size_t row = 0; row < angles.corners.size(); ++row) {
    const auto [a, b, c] = angles.corners[row];
    const Vec3 side_a = x[b] - x[c], side_b = x[c] - x[a], side_c = x[a] - x[b];
    const PerSide<double> length = {side_a.norm(), side_b.norm(), side_c.norm()};
    const Divisors<double> by = invert_lengths(angles.rest_length[row], length);
    const PerSide<double> tension = compute_tensions(AngleRow(angles, row), length, by);
    const Vec3 pull_a = (tension[0] * by.direction[0]) * side_a;
    const Vec3 pull_b = (tension[1] * by.direction[1]) * side_b;
    const Vec3 pull_c = (tension[2] * by.direction[2]) * side_c;
    f[a] += pull_b - pull_c;
    f[b] += pull_c - pull_a;
    f[c] += pull_a - pull_b;
  }
}

}  // namespace

void accumulate_link_forces(const Links& links, DampingLaw law, std::span<const Vec3> x,
                            std::span<const Vec3> v, std::span<Vec3> f) noexcept {
  if (law == DampingLaw::axis) {
    accumulate_links<DampingLaw::axis>(links, x, v, f);
  } else {
    accumulate_links<DampingLaw::isotropic>(links, x, v, f);
  }
}

void accumulate_angle_forces(const Angles& angles, std::span<const Vec3> x,
                             std::span<Vec3> f) noexcept {
  // a lambda is inlined where a function pointer would not be
  accumulate_sides(angles, x, f, [](auto&&... arguments) {
    return compute_angle_tensions<double>(arguments...);
  });
}

/// f_i = K10 (cos - cos0) (x_i - x_k)/|x_i - x_k|, f_k = -f_i, nothing on the corner itself
/// [BulutDandil22]. Momentum and angular momentum are conserved, energy is not: round a closed
/// loop of positions it does work.
void accumulate_eq10_forces(const Angles& angles, std::span<const Vec3> x,
                            std::span<Vec3> f) noexcept {
  accumulate_sides(angles, x, f,
                   [](auto&&... arguments) { return compute_eq10_tensions<double>(arguments...); });
}

/// With s = |d1| - |d2| less that at rest, T = k s + c ds/dt pulls the ends of the first diagonal
/// together and pushes those of the second apart: pairs along lines, so that momentum and angular
/// momentum are conserved.
void accumulate_prism_forces(const Prisms& prisms, std::span<const Vec3> x, std::span<const Vec3> v,
                             std::span<Vec3> f) noexcept {
  const auto at = [x](int i) -> const Vec3& { return x[static_cast<std::size_t>(i)]; };
  for (std::size_t p = 0; p < prisms.corners.size(); ++p) {
    for (int c = 0; c < 3; ++c) {
      const PrismSide side(prisms.corners[p], c);
      const auto [i, j, k, l] = side.ends;
      const Diagonals now(side, at);
      const double shear = now.length[0] - now.length[1] - prisms.rest_difference[p][c];
      const double rate = (v[j] - v[i]).dot(now.unit[0]) - (v[l] - v[k]).dot(now.unit[1]);
      const double tension =
          prisms.shear_stiffness[p][c] * shear + prisms.shear_damping[p][c] * rate;
      f[i] += tension * now.unit[0];
      f[j] -= tension * now.unit[0];
      f[k] -= tension * now.unit[1];
      f[l] += tension * now.unit[1];
    }
  }
}

/// f_c -= e'(J) B dv/dx_c at the corners of every tetrahedron, with J = v/V, the law e of
/// volume_law.h, and B its bulk. Of a share s of B the mean around each particle is taken,
///
///     J_a = sum of v / sum of V over the tetrahedra around a,   B_a = sum of B V / sum of V
///     f_c -= s/4 e'(J_a) B_a dv/dx_c   for every particle a of the tetrahedron
///
/// since a quarter of each tetrahedron's energy then belongs to each of its particles. Inner
/// forces that depend on no frame: momentum and angular momentum are kept.
void accumulate_volume_forces(const Volumes& volumes, std::span<const Vec3> x,
                              std::span<Vec3> f) noexcept {
  const auto push = [&](std::size_t t, double pressure) noexcept {
    const auto& [a, b, c, d] = volumes.corners[t];
    const Eigen::Matrix<double, 3, 4> pushes =
        pressure * compute_volume_slopes(x[a], x[b], x[c], x[d]);
    for (int k = 0; k < 4; ++k) f[volumes.corners[t][k]] -= pushes.col(k);
  };
  const double share = volumes.nodal_share;
  for (std::size_t t = 0; share < 1.0 && t < volumes.corners.size(); ++t) {
    const double j = measure_volume(volumes, t, x) / volumes.rest_volume[t];
    push(t, (1.0 - share) * volumes.bulk[t] * compute_volume_law(j).slope);
  }
  for (std::size_t i = 0; share > 0.0 && i + 1 < volumes.first_around.size(); ++i) {
    const VolumeAround around = measure_around(volumes, i, x);
    if (!(around.rest > 0.0)) continue;
    const double slope = compute_volume_law(around.now / around.rest).slope;
    for (const int t : list_around(volumes, i)) {
      push(static_cast<std::size_t>(t), 0.25 * share * around.bulk * slope);
    }
  }
}

/// f_i += h_i (X_i - x_i): a spring to where the particle was at rest. It holds the body in space,
/// so it conserves no momentum.
void accumulate_home_forces(std::span<const double> home, std::span<const Vec3> rest,
                            std::span<const Vec3> x, std::span<Vec3> f) noexcept {
  for (std::size_t i = 0; i < home.size(); ++i) f[i] += home[i] * (rest[i] - x[i]);
}

/// Pressure times area along the normal of every triangle, a third to each corner. The sum over a
/// closed surface is zero, and each particle's share is the gradient of p V there.
void accumulate_pressure_forces(std::span<const Triangle> triangles, double pressure,
                                std::span<const Vec3> x, std::span<Vec3> f) noexcept {
  for (const auto& [a, b, c] : triangles) {
    const Vec3 push = (pressure / 6.0) * (x[b] - x[a]).cross(x[c] - x[a]);
    f[a] += push;
    f[b] += push;
    f[c] += push;
  }
}

/// f_i += m_i g
void accumulate_gravity(std::span<const double> mass, const Vec3& gravity,
                        std::span<Vec3> f) noexcept {
  for (std::size_t i = 0; i < mass.size(); ++i) f[i] += mass[i] * gravity;
}

/// f_i -= drag m_i v_i: every velocity decays at the same rate.
void accumulate_drag(std::span<const double> mass, double drag, std::span<const Vec3> v,
                     std::span<Vec3> f) noexcept {
  for (std::size_t i = 0; i < mass.size(); ++i) f[i] -= drag * mass[i] * v[i];
}

/// A push on a point of a triangle is shared by the point's barycentric weights, which keeps both
/// its force and its moment; and so does sharing it again by the weights of the skin, for these
/// too say where the point is.
void accumulate_push_forces(std::span<const Triangle> triangles, const Skin& skin,
                            std::span<const Push> pushes, std::span<Vec3> f) noexcept {
  for (const Push& push : pushes) {
    const Triangle& corners = triangles[static_cast<std::size_t>(push.triangle)];
    for (int c = 0; c < 3; ++c) {
      const Vec3 force = push.weights[c] * push.force;
      if (skin.corners.empty()) {
        f[corners[c]] += force;
        continue;
      }
      const auto& weights = skin.weights[static_cast<std::size_t>(corners[c])];
      for (std::size_t k = 0; k < 4; ++k) {
        f[skin.corners[static_cast<std::size_t>(corners[c])][k]] += weights[k] * force;
      }
    }
  }
}

void accumulate_load_forces(const TissueModel& model, const Load& load,
                            std::span<Vec3> f) noexcept {
  accumulate_push_forces(model.triangles, model.skin, load.pushes(), f);
  for (const auto& [particle, force] : load.forces) f[static_cast<std::size_t>(particle)] += force;
}

void compute_forces(const TissueModel& model, const Load& load, std::span<const Vec3> x,
                    std::span<const Vec3> v, std::span<Vec3> f,
                    std::span<const double> internal) noexcept {
  std::fill(f.begin(), f.end(), Vec3::Zero());
  laws::for_each_part(model, internal, [&]<class Law>(Law, std::span<const double> part) {
    Law::accumulate({model, x, v, part}, f);
  });
  accumulate_home_forces(model.home, model.rest_position, x, f);
  if (model.pressure != 0.0) accumulate_pressure_forces(model.triangles, model.pressure, x, f);
  if (load.gravity != Vec3::Zero()) accumulate_gravity(model.mass, load.gravity, f);
  if (model.drag != 0.0) accumulate_drag(model.mass, model.drag, v, f);
  accumulate_load_forces(model, load, f);
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/forces.h"

#include <algorithm>

#include "palpate/sim/dynamics/tensions.h"

namespace palpate {
namespace {

using Tensions = PerSide<double> (*)(const Angles&, std::size_t, const PerSide<double>&,
                                     const PerSide<double>&) noexcept;

/// Pulls the ends of every side of every triangle together by the tension a law gives it; each
/// length is computed once. A side without a direction exerts no force (SCIENCE 1.7).
template <Tensions compute>
void accumulate_side_tensions(const Angles& angles, std::span<const Vec3> x,
                              std::span<Vec3> f) noexcept {
  for (std::size_t row = 0; row < angles.corners.size(); ++row) {
    const Triangle& corner = angles.corners[row];
    const PerSide<double>& rest = angles.rest_length[row];
    std::array<Vec3, 3> side;
    PerSide<double> length;
    for (int c = 0; c < 3; ++c) {
      side[c] = x[corner[(c + 2) % 3]] - x[corner[(c + 1) % 3]];
      length[c] = side[c].norm();
    }
    const PerSide<double> tension =
        compute(angles, row, length, invert_lengths<double>(rest, length));
    for (int c = 0; c < 3; ++c) {
      if (length[c] <= kNoDirection * rest[c]) continue;
      const Vec3 pull = (tension[c] / length[c]) * side[c];
      f[corner[(c + 1) % 3]] += pull;
      f[corner[(c + 2) % 3]] -= pull;
    }
  }
}

}  // namespace

/// Eq 1 and Eq 8 with the damping of Eq 2, w = v_j - v_i the relative velocity:
///
///     f_i += (k (|d| - L) + c w·n) n,   f_j -= the same,   d = x_j - x_i,  n = d/|d|
///
/// Hooke's law with damping along the link [Provot95]; under DampingLaw::isotropic the damping is
/// c w. The two pulls cancel, so the sum of `f` is unchanged. A link of zero length has no
/// direction and exerts no force.
void accumulate_link_forces(const Links& links, DampingLaw law, std::span<const Vec3> x,
                            std::span<const Vec3> v, std::span<Vec3> f) noexcept {
  for (std::size_t l = 0; l < links.ends.size(); ++l) {
    const auto [i, j] = links.ends[l];
    const Vec3 d = x[j] - x[i];
    const double length = d.norm();
    if (length <= kNoDirection * links.rest_length[l]) continue;

    const Vec3 n = d / length;
    const Vec3 w = v[j] - v[i];
    const double stretch = length - links.rest_length[l];
    Vec3 pull;
    if (law == DampingLaw::axis) {
      pull = (links.stiffness[l] * stretch + links.damping[l] * w.dot(n)) * n;
    } else {
      pull = links.stiffness[l] * stretch * n + links.damping[l] * w;
    }
    f[i] += pull;
    f[j] -= pull;
  }
}

void accumulate_angle_forces(const Angles& angles, std::span<const Vec3> x,
                             std::span<Vec3> f) noexcept {
  accumulate_side_tensions<compute_angle_tensions<double>>(angles, x, f);
}

void accumulate_eq10_forces(const Angles& angles, std::span<const Vec3> x,
                            std::span<Vec3> f) noexcept {
  accumulate_side_tensions<compute_eq10_tensions<double>>(angles, x, f);
}

/// f_i += h_i (X_i - x_i): a spring to where the particle was at rest.
void accumulate_home_forces(std::span<const double> home, std::span<const Vec3> rest,
                            std::span<const Vec3> x, std::span<Vec3> f) noexcept {
  for (std::size_t i = 0; i < home.size(); ++i) f[i] += home[i] * (rest[i] - x[i]);
}

/// Pressure times area along the normal of every triangle, a third to each corner. The sum over a
/// closed surface is zero, and each particle's share is the gradient of p V there.
void accumulate_pressure_forces(std::span<const Triangle> triangles, double pressure,
                                std::span<const Vec3> x, std::span<Vec3> f) noexcept {
  for (const Triangle& triangle : triangles) {
    const auto a = static_cast<std::size_t>(triangle[0]);
    const auto b = static_cast<std::size_t>(triangle[1]);
    const auto c = static_cast<std::size_t>(triangle[2]);
    const Vec3 push = (pressure / 6.0) * (x[b] - x[a]).cross(x[c] - x[a]);
    f[a] += push;
    f[b] += push;
    f[c] += push;
  }
}

void accumulate_gravity(std::span<const double> mass, const Vec3& gravity,
                        std::span<Vec3> f) noexcept {
  for (std::size_t i = 0; i < mass.size(); ++i) f[i] += mass[i] * gravity;
}

void accumulate_drag(std::span<const double> mass, double drag, std::span<const Vec3> v,
                     std::span<Vec3> f) noexcept {
  for (std::size_t i = 0; i < mass.size(); ++i) f[i] -= drag * mass[i] * v[i];
}

/// A push on a point of a triangle is shared by the point's barycentric weights, which keeps both
/// its force and its moment.
void accumulate_push_forces(std::span<const Triangle> triangles, std::span<const Push> pushes,
                            std::span<Vec3> f) noexcept {
  for (const Push& push : pushes) {
    const Triangle& triangle = triangles[static_cast<std::size_t>(push.triangle)];
    for (std::size_t c = 0; c < 3; ++c) {
      f[static_cast<std::size_t>(triangle[c])] += push.weights[static_cast<int>(c)] * push.force;
    }
  }
}

void compute_forces(const TissueModel& model, const Load& load, std::span<const Vec3> x,
                    std::span<const Vec3> v, std::span<Vec3> f) noexcept {
  std::fill(f.begin(), f.end(), Vec3::Zero());
  accumulate_link_forces(model.springs, model.damping_law, x, v, f);
  accumulate_link_forces(model.bonds, model.damping_law, x, v, f);
  if (model.angle_law == AngleLaw::gradient) {
    accumulate_angle_forces(model.angles, x, f);
  } else {
    accumulate_eq10_forces(model.angles, x, f);
  }
  accumulate_home_forces(model.home, model.rest_position, x, f);
  if (model.pressure != 0.0) accumulate_pressure_forces(model.triangles, model.pressure, x, f);
  if (load.gravity != Vec3::Zero()) accumulate_gravity(model.mass, load.gravity, f);
  if (model.drag != 0.0) accumulate_drag(model.mass, model.drag, v, f);
  accumulate_push_forces(model.triangles, load.pushes(), f);
}

}  // namespace palpate

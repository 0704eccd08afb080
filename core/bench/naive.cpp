// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/naive.h"

#include <cmath>

#include "palpate/sim/dynamics/forces.h"

namespace palpate::bench {
namespace {

void add_links(const Links& links, std::span<const Vec3> x, std::span<const Vec3> v,
               std::span<Vec3> f) noexcept {
  for (std::size_t l = 0; l < links.ends.size(); ++l) {
    const auto i = static_cast<std::size_t>(links.ends[l][0]);
    const auto j = static_cast<std::size_t>(links.ends[l][1]);
    const Vec3 d = x[j] - x[i];
    const double length = d.norm();
    const Vec3 n = d / length;
    const double pull = links.stiffness[l] * (length - links.rest_length[l]) +
                        links.damping[l] * (v[j] - v[i]).dot(n);
    f[i] += pull * n;
    f[j] -= pull * n;
  }
}

/// One corner of Eq 9 and Eq 11 by its vectors: arms u, w from apex j to i and k.
void add_corner(const Angles& angles, std::size_t t, std::size_t corner, std::span<const Vec3> x,
                std::span<Vec3> f) noexcept {
  const auto j = static_cast<std::size_t>(angles.corners[t][corner]);
  const auto i = static_cast<std::size_t>(angles.corners[t][(corner + 1) % 3]);
  const auto k = static_cast<std::size_t>(angles.corners[t][(corner + 2) % 3]);
  const Vec3 u = x[i] - x[j];
  const Vec3 w = x[k] - x[j];
  const double r = u.norm();
  const double s = w.norm();
  const double angle = std::acos(u.dot(w) / (r * s));
  const double cosine = std::cos(angle);
  const double bend = cosine - angles.rest_cosine[t][corner];
  // the arm to i is the side opposite k, and the other way round
  const double stretch =
      (r - angles.rest_length[t][(corner + 2) % 3]) + (s - angles.rest_length[t][(corner + 1) % 3]);
  const Vec3 grad_i = (w / s - cosine * u / r) / r;
  const Vec3 grad_k = (u / r - cosine * w / s) / s;
  const double bending = angles.bend_stiffness[t][corner] * bend;
  const double coupling = angles.stretch_coupling[t][corner];
  const Vec3 f_i = -bending * grad_i - coupling * (stretch * grad_i + bend * u / r);
  const Vec3 f_k = -bending * grad_k - coupling * (stretch * grad_k + bend * w / s);
  f[i] += f_i;
  f[k] += f_k;
  f[j] -= f_i + f_k;
}

}  // namespace

void step_naively(const TissueModel& model, const Load& load, double dt, State& state) noexcept {
  const std::size_t n = state.position.size();
  std::vector<Vec3>& f = state.force;
  for (std::size_t i = 0; i < n; ++i) f[i] = Vec3::Zero();
  add_links(model.springs, state.position, state.velocity, f);
  add_links(model.bonds, state.position, state.velocity, f);
  for (std::size_t t = 0; t < model.angles.corners.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      add_corner(model.angles, t, corner, state.position, f);
    }
  }
  for (std::size_t i = 0; i < model.home.size(); ++i) {
    f[i] += model.home[i] * (model.rest_position[i] - state.position[i]);
  }
  if (model.pressure != 0.0) {
    accumulate_pressure_forces(model.triangles, model.pressure, state.position, f);
  }
  accumulate_push_forces(model.triangles, load.pushes(), f);
  for (std::size_t i = 0; i < n; ++i) {
    f[i] += model.mass[i] * load.gravity - model.drag * model.mass[i] * state.velocity[i];
  }
  for (const int i : model.fixed) f[static_cast<std::size_t>(i)] = Vec3::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    state.velocity[i] += dt / model.mass[i] * f[i];
    state.position[i] += dt * state.velocity[i];
  }
  state.time += dt;
}

std::optional<SurfacePoint> find_segment_hit_naively(std::span<const Triangle> triangles,
                                                     std::span<const Vec3> x, const Vec3& from,
                                                     const Vec3& to) noexcept {
  // Möller-Trumbore on every triangle
  const Vec3 d = to - from;
  double nearest = 1.0;
  std::optional<SurfacePoint> hit;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vec3& a = x[static_cast<std::size_t>(triangles[t][0])];
    const Vec3 ab = x[static_cast<std::size_t>(triangles[t][1])] - a;
    const Vec3 ac = x[static_cast<std::size_t>(triangles[t][2])] - a;
    const Vec3 p = d.cross(ac);
    const double det = ab.dot(p);
    if (det == 0.0) continue;
    const Vec3 s = from - a;
    const double u = s.dot(p) / det;
    if (u < 0.0 || u > 1.0) continue;
    const Vec3 q = s.cross(ab);
    const double v = d.dot(q) / det;
    if (v < 0.0 || u + v > 1.0) continue;
    const double fraction = ac.dot(q) / det;
    if (fraction < 0.0 || fraction > nearest || (hit && fraction == nearest)) continue;
    nearest = fraction;
    hit = SurfacePoint{.triangle = static_cast<int>(t),
                       .weights = {1.0 - u - v, u, v},
                       .point = from + fraction * d,
                       .distance = fraction * d.norm()};
  }
  return hit;
}

std::optional<SurfacePoint> find_closest_point_naively(std::span<const Triangle> triangles,
                                                       std::span<const Vec3> x,
                                                       const Vec3& p) noexcept {
  std::optional<SurfacePoint> best;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    SurfacePoint found = find_closest_on_triangle(p, x[static_cast<std::size_t>(triangles[t][0])],
                                                  x[static_cast<std::size_t>(triangles[t][1])],
                                                  x[static_cast<std::size_t>(triangles[t][2])]);
    if (best && found.distance >= best->distance) continue;
    found.triangle = static_cast<int>(t);
    best = found;
  }
  return best;
}

int find_in_sphere_naively(std::span<const Triangle> triangles, std::span<const Vec3> x,
                           const Vec3& centre, double radius, std::span<int> out) noexcept {
  int count = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const SurfacePoint found = find_closest_on_triangle(
        centre, x[static_cast<std::size_t>(triangles[t][0])],
        x[static_cast<std::size_t>(triangles[t][1])], x[static_cast<std::size_t>(triangles[t][2])]);
    if (found.distance > radius) continue;
    if (count < static_cast<int>(out.size())) {
      out[static_cast<std::size_t>(count)] = static_cast<int>(t);
    }
    ++count;
  }
  return count;
}

}  // namespace palpate::bench

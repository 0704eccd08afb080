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
  accumulate_push_forces(model.triangles, model.skin, load.pushes(), f);
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

}  // namespace palpate::bench

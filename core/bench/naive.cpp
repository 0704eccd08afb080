// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/naive.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/volume_law.h"

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

/// -p dv/dx_c of tetrahedron t for its four corners, each a third of the face opposite.
void add_pressure(const Volumes& volumes, std::size_t t, double pressure, std::span<const Vec3> x,
                  std::span<Vec3> f) noexcept {
  const auto& [a, b, c, d] = volumes.corners[t];
  const Vec3 ab = x[b] - x[a], ac = x[c] - x[a], ad = x[d] - x[a];
  const Vec3 at_b = pressure / 6.0 * ac.cross(ad);
  const Vec3 at_c = pressure / 6.0 * ad.cross(ab);
  const Vec3 at_d = pressure / 6.0 * ab.cross(ac);
  f[b] -= at_b;
  f[c] -= at_c;
  f[d] -= at_d;
  f[a] += at_b + at_c + at_d;
}

/// Volumes are summed around particles, there made a pressure, and given back: two loops over the
/// tetrahedra, where the reference kernel takes each four times.
void add_volumes(const Volumes& volumes, std::span<const Vec3> x, NaiveVolumes& kept,
                 std::span<Vec3> f) noexcept {
  const double share = volumes.nodal_share;
  std::fill(kept.now.begin(), kept.now.end(), 0.0);
  for (std::size_t t = 0; share > 0.0 && t < volumes.corners.size(); ++t) {
    const double volume = measure_volume(volumes, t, x);
    for (const int i : volumes.corners[t]) kept.now[static_cast<std::size_t>(i)] += volume;
  }
  for (std::size_t i = 0; share > 0.0 && i < kept.now.size(); ++i) {
    const double slope = compute_volume_law(kept.now[i] / kept.rest[i]).slope;
    kept.pressure[i] = 0.25 * share * kept.bulk[i] * slope;
  }
  for (std::size_t t = 0; t < volumes.corners.size(); ++t) {
    double pressure = 0.0;
    if (share < 1.0) {
      const double j = measure_volume(volumes, t, x) / volumes.rest_volume[t];
      pressure = (1.0 - share) * volumes.bulk[t] * compute_volume_law(j).slope;
    }
    if (share > 0.0) {
      for (const int i : volumes.corners[t]) pressure += kept.pressure[static_cast<std::size_t>(i)];
    }
    add_pressure(volumes, t, pressure, x, f);
  }
}

}  // namespace

NaiveVolumes::NaiveVolumes(const Volumes& volumes)
    : rest(volumes.first_around.empty() ? 0 : volumes.first_around.size() - 1, 0.0),
      bulk(rest.size(), 0.0),
      now(rest.size(), 0.0),
      pressure(rest.size(), 0.0) {
  for (std::size_t t = 0; t < volumes.corners.size(); ++t) {
    for (const int i : volumes.corners[t]) {
      rest[static_cast<std::size_t>(i)] += volumes.rest_volume[t];
      bulk[static_cast<std::size_t>(i)] += volumes.rest_volume[t] * volumes.bulk[t];
    }
  }
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest[i] > 0.0) bulk[i] /= rest[i];
  }
}

void step_naively(const TissueModel& model, const Load& load, double dt, State& state) noexcept {
  assert(model.volumes.corners.empty());
  NaiveVolumes none;
  step_naively(model, load, dt, state, none);
}

void step_naively(const TissueModel& model, const Load& load, double dt, State& state,
                  NaiveVolumes& kept) noexcept {
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
  if (!model.prisms.corners.empty()) {
    accumulate_prism_forces(model.prisms, state.position, state.velocity, f);
  }
  if (!model.volumes.corners.empty()) add_volumes(model.volumes, state.position, kept, f);
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

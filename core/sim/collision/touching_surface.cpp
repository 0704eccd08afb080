// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/collision/private/touching_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate {

std::vector<double> invert_surface_masses(const TissueModel& tissue) {
  std::vector<double> inverse = compute_surface_mass(tissue);
  for (double& mass : inverse) mass = 1.0 / mass;
  std::vector<unsigned char> held(tissue.rest_position.size(), 0);
  for (const int i : tissue.fixed) held[static_cast<std::size_t>(i)] = 1;
  for (std::size_t v = 0; v < inverse.size(); ++v) {
    const auto is_held = [&](int particle) {
      return held[static_cast<std::size_t>(particle)] != 0;
    };
    const bool still = tissue.skin.corners.empty()
                           ? is_held(static_cast<int>(v))
                           : std::ranges::all_of(tissue.skin.corners[v], is_held);
    if (still) inverse[v] = 0.0;
  }
  return inverse;
}

SurfaceTouch::SurfaceTouch(const TissueModel& tissue)
    : SurfaceMotion(static_cast<std::size_t>(surface_count(tissue))),
      inverse_mass(invert_surface_masses(tissue)) {
  const std::size_t count = inverse_mass.size();
  corner.assign(count, {0, 0});
  for (std::size_t t = 0; t < tissue.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      corner[static_cast<std::size_t>(tissue.triangles[t][c])] = {static_cast<int>(t),
                                                                  static_cast<int>(c)};
    }
  }
  row.assign(count, 0.0);
  force.assign(count, Vec3::Zero());
  impulse.assign(count, Vec3::Zero());
  pushed.assign(count, 0);
  is_pushed.assign(count, 0);
}

void follow_move(std::span<const Vec3> x, double elapsed, SurfaceMotion& motion) noexcept {
  double most = 0.0;
  if (motion.has_last) {
    for (std::size_t v = 0; v < x.size(); ++v) {
      most = std::max(most, (x[v] - motion.last[v]).squaredNorm());
    }
  }
  motion.move = std::sqrt(most);
  if (elapsed > 0.0) motion.speed = motion.move / elapsed;
  std::swap(motion.last, motion.before);
  std::ranges::copy(x, motion.last.begin());
  if (!motion.has_last || elapsed == 0.0) std::ranges::copy(x, motion.before.begin());
  motion.has_last = true;
}

double measure_lost(const TouchingSurface& surface) noexcept {
  const SurfaceTouch& touch = surface.touch;
  double lost = 0.0;
  for (const int vertex : touch.pushed_in_use()) {
    const auto v = static_cast<std::size_t>(vertex);
    lost -= touch.force[v].dot(surface.velocity_of(vertex) - touch.impulse[v]);
  }
  return lost;
}

Vec3 TouchingSurface::velocity_of(int vertex) const noexcept {
  const auto v = static_cast<std::size_t>(vertex);
  const Skin& skin = tissue.skin;
  if (skin.corners.empty()) return velocity[v] + touch.impulse[v];
  Vec3 sum = touch.impulse[v];
  for (std::size_t k = 0; k < 4; ++k) {
    sum += skin.weights[v][k] * velocity[static_cast<std::size_t>(skin.corners[v][k])];
  }
  return sum;
}

void TouchingSurface::add_impulse(int vertex, const Vec3& impulse) const noexcept {
  const auto v = static_cast<std::size_t>(vertex);
  touch.impulse[v] += touch.inverse_mass[v] * impulse;
  touch.has_impulse = true;
}

}  // namespace palpate

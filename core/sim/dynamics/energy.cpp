// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/energy.h"

#include <span>

#include "palpate/sim/dynamics/tensions.h"

namespace palpate {
namespace {

/// Eq 8: k (l - L)² / 2 over all links.
double compute_link_energy(const Links& links, std::span<const Vec3> x) noexcept {
  double sum = 0.0;
  for (std::size_t l = 0; l < links.ends.size(); ++l) {
    const auto i = static_cast<std::size_t>(links.ends[l][0]);
    const auto j = static_cast<std::size_t>(links.ends[l][1]);
    const double stretch = (x[j] - x[i]).norm() - links.rest_length[l];
    sum += 0.5 * links.stiffness[l] * stretch * stretch;
  }
  return sum;
}

/// Eq 9 and Eq 11: K_theta q² / 2 + K_btheta q (d + d') over all corners, d and d' of its arms.
double compute_angle_energy(const Angles& angles, std::span<const Vec3> x) noexcept {
  double sum = 0.0;
  for (std::size_t row = 0; row < angles.corners.size(); ++row) {
    const Triangle& corner = angles.corners[row];
    const PerSide<double>& rest = angles.rest_length[row];
    PerSide<double> length;
    for (int c = 0; c < 3; ++c)
      length[c] = (x[corner[(c + 2) % 3]] - x[corner[(c + 1) % 3]]).norm();
    const PerSide<double> cosine = compute_cosines(length, invert_lengths(rest, length));
    for (int c = 0; c < 3; ++c) {
      const int i = (c + 1) % 3, j = (c + 2) % 3;
      const double bend = cosine[c] - angles.rest_cosine[row][c];
      const double stretch = length[i] + length[j] - rest[i] - rest[j];
      sum +=
          (0.5 * angles.bend_stiffness[row][c] * bend + angles.stretch_coupling[row][c] * stretch) *
          bend;
    }
  }
  return sum;
}

double compute_enclosed_volume(std::span<const Triangle> triangles,
                               std::span<const Vec3> x) noexcept {
  double six_volumes = 0.0;
  for (const Triangle& t : triangles) {
    six_volumes += x[static_cast<std::size_t>(t[0])].dot(
        x[static_cast<std::size_t>(t[1])].cross(x[static_cast<std::size_t>(t[2])]));
  }
  return six_volumes / 6.0;
}

}  // namespace

Energy compute_energy(const TissueModel& model, const Vec3& gravity, const State& state) noexcept {
  Energy energy;
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    energy.kinetic += 0.5 * model.mass[i] * state.velocity[i].squaredNorm();
    energy.gravity -= model.mass[i] * gravity.dot(state.position[i]);
  }
  energy.links = compute_link_energy(model.springs, state.position) +
                 compute_link_energy(model.bonds, state.position);
  if (model.angle_law == AngleLaw::gradient) {
    energy.angles = compute_angle_energy(model.angles, state.position);
  }
  for (std::size_t i = 0; i < model.home.size(); ++i) {
    energy.home += 0.5 * model.home[i] * (state.position[i] - model.rest_position[i]).squaredNorm();
  }
  if (model.pressure != 0.0) {
    energy.pressure = -model.pressure * compute_enclosed_volume(model.triangles, state.position);
  }
  return energy;
}

}  // namespace palpate

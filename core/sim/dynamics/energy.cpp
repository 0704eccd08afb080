// SPDX-License-Identifier: BSD-3-Clause
#include <span>

#include "palpate/sim/dynamics/private/elastic_energy.h"
#include "palpate/sim/dynamics/state.h"

namespace palpate {
namespace {

double compute_enclosed_volume(std::span<const Triangle> triangles,
                               std::span<const Vec3> x) noexcept {
  double six_volumes = 0.0;
  for (const auto& [a, b, c] : triangles) six_volumes += x[a].dot(x[b].cross(x[c]));
  return six_volumes / 6.0;
}

}  // namespace

Energy compute_energy(const TissueModel& model, const Vec3& gravity, const State& state) noexcept {
  const Vec3Array& x = state.position;
  const auto at = [&x](int i) -> const Vec3& { return x[static_cast<std::size_t>(i)]; };
  Energy energy;
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    energy.kinetic += 0.5 * model.mass[i] * state.velocity[i].squaredNorm();
    energy.gravity -= model.mass[i] * gravity.dot(x[i]);
  }
  energy.links = compute_link_energy(model.springs, at) + compute_link_energy(model.bonds, at);
  if (model.angle_law == AngleLaw::gradient) energy.angles = compute_angle_energy(model.angles, at);
  energy.prisms = compute_prism_energy(model.prisms, at);
  energy.volumes = compute_volume_energy(model.volumes, at);
  energy.strain = compute_linear_energy(model, at);
  energy.home = compute_home_energy(model, at);
  if (model.pressure != 0.0) {
    energy.pressure = -model.pressure * compute_enclosed_volume(model.triangles, x);
  }
  return energy;
}

}  // namespace palpate

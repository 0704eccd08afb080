// SPDX-License-Identifier: BSD-3-Clause
#include <span>

#include "palpate/sim/dynamics/private/laws.h"
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
  laws::for_each_part(model, std::span<const double>(state.internal),
                      [&]<class Law>(Law, std::span<const double> part) {
                        energy.*Law::kEnergy += Law::compute_energy(model, at, part);
                      });
  energy.home = compute_home_energy(model, at);
  if (model.pressure != 0.0) {
    energy.pressure = -model.pressure * compute_enclosed_volume(model.triangles, x);
  }
  return energy;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/collision/private/stop.h"

#include <algorithm>

namespace palpate {

void CarriedPoint::add_particle(int index, double c) noexcept {
  for (std::size_t k = 0; k < count; ++k) {
    if (particle[k] != index) continue;
    part[k] += c;
    return;
  }
  particle[count] = index;
  part[count++] = c;
}

void CarriedPoint::add(const TissueModel& tissue, int vertex, double weight) noexcept {
  if (weight == 0.0) return;
  if (tissue.skin.corners.empty()) return add_particle(vertex, weight);
  const auto v = static_cast<std::size_t>(vertex);
  for (std::size_t k = 0; k < 4; ++k) {
    add_particle(tissue.skin.corners[v][k], weight * tissue.skin.weights[v][k]);
  }
}

double CarriedPoint::compute_inverse_mass(std::span<const double> inverse_mass) const noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    sum += part[k] * part[k] * inverse_mass[static_cast<std::size_t>(particle[k])];
  }
  return sum;
}

Vec3 CarriedPoint::sum_over(std::span<const Vec3> of_particles) const noexcept {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    sum += part[k] * of_particles[static_cast<std::size_t>(particle[k])];
  }
  return sum;
}

/// Of a point y = sum c_i x_i with the inverse mass w = sum c_i²/m_i, a depth d along n:
///
///     x_i += c_i/(m_i w) d n,   v_n <- max(v_n, 0),   v_t <- v_t max(0, 1 - mu |dv_n| / |v_t|)
///
/// and what friction takes of v_t it takes of the way of this step as well: what sticks does not
/// creep. No force is involved, so that no step is too long for it [contact: scenery].
Vec3 stop_point(const CarriedPoint& point, const Stop& stop, double dt,
                std::span<const double> inverse_mass, std::span<Vec3> position,
                std::span<Vec3> velocity) noexcept {
  const double w = point.compute_inverse_mass(inverse_mass);
  if (!(w > 0.0)) return Vec3::Zero();
  const Vec3 before = point.sum_over(velocity);
  const double along = before.dot(stop.normal), taken = std::max(0.0, -along);
  Vec3 change = taken * stop.normal, way = stop.depth * stop.normal;
  const Vec3 sideways = before - along * stop.normal;
  const double speed = sideways.norm();
  if (stop.friction > 0.0 && speed > 0.0) {
    const Vec3 rubbed = -std::min(1.0, stop.friction * taken / speed) * sideways;
    change += rubbed;
    way += dt * rubbed;
  }
  for (std::size_t k = 0; k < point.count; ++k) {
    const auto i = static_cast<std::size_t>(point.particle[k]);
    const double share = point.part[k] * inverse_mass[i] / w;
    position[i] += share * way;
    velocity[i] += share * change;
  }
  return change / w;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// A point of a body's surface as its particles carry it: the sum of c_i x_i, each particle once.
struct CarriedPoint {
  static constexpr std::size_t kMost = 12;  ///< three corners of a skin, of four particles each

  std::array<int, kMost> particle{};
  std::array<double, kMost> part{};  ///< c_i
  std::size_t count = 0;

  /// Adds a vertex of the surface, with a weight.
  void add(const TissueModel& tissue, int vertex, double weight) noexcept;
  /// [1/kg] sum of c_i²/m_i.
  double compute_inverse_mass(std::span<const double> inverse_mass) const noexcept;
  Vec3 sum_over(std::span<const Vec3> of_particles) const noexcept;

 private:
  void add_particle(int index, double c) noexcept;
};

/// What does not give way to a body.
struct Stop {
  Vec3 normal = Vec3::Zero();  ///< unit, towards where the body's point is to be
  double depth = 0.0;          ///< [m] by which the point is beyond
  double friction = 0.0;       ///< [-]
};

/// Takes a point that has come through in a step of dt [s] back to the surface, and its velocity
/// into it away; friction as much of what is along it. `inverse_mass` [1/kg] per particle, 0 of
/// those held, which stay; position [m] and velocity [m/s] too. Returns the impulse [N s] on the
/// body, 0 where nothing can move.
Vec3 stop_point(const CarriedPoint& point, const Stop& stop, double dt,
                std::span<const double> inverse_mass, std::span<Vec3> position,
                std::span<Vec3> velocity) noexcept;

}  // namespace palpate

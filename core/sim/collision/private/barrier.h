// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace palpate {

/// What pushes two surfaces apart that are nearer than its thickness [contact: bodies].
struct Barrier {
  double thickness = 0.0;  ///< [m] tau
  double stiffness = 0.0;  ///< [N/m³] k_A
  double damping = 0.0;    ///< [-] of critical
};

/// [-] of the thickness. Nearer, the pressure goes on as a line, and approach is stopped.
inline constexpr double kClosestPart = 0.1;

/// [Pa] p(g) = k_A (tau - g) / max(0.1, g / tau) for a gap g [m] below tau, else 0.
inline double compute_pressure(const Barrier& barrier, double gap) noexcept {
  if (!(gap < barrier.thickness)) return 0.0;
  return barrier.stiffness * (barrier.thickness - gap) /
         std::max(kClosestPart, gap / barrier.thickness);
}

/// [N/m³] -dp/dg: k_A tau²/g², and 10 k_A below the floor.
inline double compute_slope(const Barrier& barrier, double gap) noexcept {
  if (!(gap < barrier.thickness)) return 0.0;
  const double part = gap / barrier.thickness;
  return part > kClosestPart ? barrier.stiffness / (part * part) : barrier.stiffness / kClosestPart;
}

/// [J/m²] The integral of p from g to tau.
inline double compute_barrier_energy(const Barrier& barrier, double gap) noexcept {
  const double tau = barrier.thickness;
  if (!(gap < tau)) return 0.0;
  const double above = std::max(gap, kClosestPart * tau), depth = tau - above;
  const double energy = barrier.stiffness * tau * (tau * std::log(tau / above) - depth);
  if (gap >= above) return energy;
  const double deeper = tau - gap;
  return energy + 0.5 * barrier.stiffness / kClosestPart * (deeper * deeper - depth * depth);
}

}  // namespace palpate

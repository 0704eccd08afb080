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

/// [-] of the thickness. Nearer, the pressure goes on along its tangent, and approach is stopped.
inline constexpr double kClosestPart = 0.1;

/// [Pa] p(g) = k_A (tau - g) tau / g for a gap g [m] below tau, else 0; below the floor of a tenth
/// of tau its tangent there, 9 k_A tau + 100 k_A (0.1 tau - g).
inline double compute_pressure(const Barrier& barrier, double gap) noexcept {
  if (!(gap < barrier.thickness)) return 0.0;
  const double above = std::max(gap, kClosestPart * barrier.thickness);
  const double part = above / barrier.thickness;
  const double pressure = barrier.stiffness * (barrier.thickness - above) / part;
  return pressure + barrier.stiffness / (part * part) * (above - gap);
}

/// [N/m³] -dp/dg: k_A tau²/g², and 100 k_A below the floor.
inline double compute_slope(const Barrier& barrier, double gap) noexcept {
  if (!(gap < barrier.thickness)) return 0.0;
  const double part = std::max(kClosestPart, gap / barrier.thickness);
  return barrier.stiffness / (part * part);
}

/// [J/m²] The integral of p from g to tau.
inline double compute_barrier_energy(const Barrier& barrier, double gap) noexcept {
  const double tau = barrier.thickness;
  if (!(gap < tau)) return 0.0;
  const double above = std::max(gap, kClosestPart * tau), depth = tau - above;
  const double energy = barrier.stiffness * tau * (tau * std::log(tau / above) - depth);
  if (gap >= above) return energy;
  const double below = above - gap;
  return energy +
         below * (compute_pressure(barrier, above) + 0.5 * compute_slope(barrier, above) * below);
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/step.h"

namespace palpate {

/// How much of its limit a step uses. It covers a tenth by which Lanczos may miss an eigenvalue
/// (0.9² < 1/1.1), and a tissue that is a little stiffer in use than at rest.
inline constexpr double kLimitShare = 0.9;

/// Whether it is stable only where all that swings is damped.
inline bool needs_damping(Integrator integrator) noexcept {
  return integrator == Integrator::explicit_euler || integrator == Integrator::midpoint;
}

/// Whether its limit follows from how much the least damped motion is damped.
inline bool uses_damping(Integrator integrator) noexcept {
  return needs_damping(integrator) || integrator == Integrator::symplectic_euler_implicit_damping;
}

/// Whether it moves particles by the velocity that a step begins with, too. The force of a contact
/// of stiffness k, held over its stages, drives what it holds: with x' = x + dt v - h²/2 x and
/// v' = v - h²/dt x, h² = dt² k/m, the determinant of a step is 1 + h²/2, beyond 1 for any step.
/// Given at the start all at once, it is that of symplectic Euler: x' = x + dt v', and the
/// determinant is 1 [motion: integrators].
inline bool wants_kick(Integrator integrator) noexcept {
  return needs_damping(integrator) || integrator == Integrator::runge_kutta_4 ||
         integrator == Integrator::implicit_midpoint;
}

/// The pushes of a load at the start of a step, all at once: v += dt f/m. Returns their work [J].
double kick(const TissueModel& model, const Load& load, double dt, State& state) noexcept;

/// [s] The exact limit at rest of symplectic Euler with implicit damping: where the largest
/// eigenvalue of M⁻¹(dt² K - 2 dt C) is 4. Infinite where nothing can swing.
double find_damped_limit(const TissueModel& model);

/// [s] The least that u'Cu is of u'Ku at rest, over all displacements u: 0 where something swings
/// undamped, infinite where nothing can swing. To a thousandth of what it is for the stiffest mode.
double estimate_least_damping_time(const TissueModel& model);

/// [s] The longest step at which an integrator is stable, where w² and c of the spectrum are the
/// largest eigenvalues of M⁻¹K and M⁻¹C and `least_damping_time` [s] is as above. 0 for none,
/// infinite for an implicit one [motion: step].
double find_step_limit(Integrator integrator, const Spectrum& spectrum,
                       double least_damping_time) noexcept;

}  // namespace palpate

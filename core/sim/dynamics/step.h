// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/load.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

enum class Integrator {
  explicit_euler,    ///< x with the old velocity; never stable without damping
  symplectic_euler,  ///< v first, x with the new v: what Eq 4-5 of the paper really is
  midpoint,          ///< explicit midpoint, second order
  runge_kutta_4,
  symplectic_euler_implicit_damping,  ///< symplectic Euler, damped by the velocity it steps to
  implicit_euler_linear,              ///< one Newton step with the projected tangent
  implicit_euler,                     ///< Newton until the residual is small
  implicit_midpoint,
  xpbd,                 ///< extended position-based dynamics: constraints one after the other
  projective_dynamics,  ///< local steps and one constant matrix
};

/// "symplectic_euler" -> Integrator::symplectic_euler; none for an unknown name.
std::optional<Integrator> find_integrator(std::string_view name) noexcept;
std::string_view integrator_name(Integrator integrator) noexcept;
/// Whether it solves for the state that it steps to (ImplicitStepper). Implicit damping does not:
/// it solves for velocities alone, in the memory of a state.
bool is_implicit(Integrator integrator) noexcept;

/// Largest eigenvalues at rest of M⁻¹K [1/s²] and M⁻¹C [1/s], fixed particles left out, with
/// `coupling` [N/m] holding the particle it hurts most. Estimated from above, to a thousandth
/// without a coupling.
struct Spectrum {
  double stiffness = 0.0;  ///< [1/s²]
  double damping = 0.0;    ///< [1/s]
};

Spectrum estimate_spectrum(const TissueModel& model, double coupling = 0.0);

/// [s] A step at which symplectic Euler is stable at rest, with a margin; `coupling` [N/m] is the
/// stiffness that a tool may add at any one particle. Lies between 0.6 and 1.0 of the exact limit,
/// at which the largest eigenvalue of M⁻¹(dt² K + 2 dt C) is 4; dt² lambda_K + 2 dt lambda_C < 4
/// is sufficient [motion: step] for that. Infinite where nothing can swing. Always the same for the
/// same model. Eq 10 may flutter at any step where its triangles are uneven and damping is low.
double stable_step(const TissueModel& model, double coupling = 0.0);

/// [s] The same for any integrator [motion: step]: infinite for an implicit one, and 0 where no
/// step is stable, because something swings that nothing damps: explicit Euler and the explicit
/// midpoint rule feed it energy at any step. Lies between 0.4 and 1.0 of the exact limit where
/// damping is proportional to stiffness; of symplectic Euler with implicit damping, which has one
/// only where something swings, from 0.85 on, whatever the damping is.
double stable_step(const TissueModel& model, Integrator integrator);

/// Advances `state` by `dt` [s] with symplectic Euler, which must stay below stable_step(model).
/// Does not allocate.
void step(const TissueModel& model, const Load& load, double dt, State& state) noexcept;

/// The same with any explicit integrator; asserts on an implicit one.
void step(const TissueModel& model, const Load& load, double dt, Integrator integrator,
          State& state) noexcept;

class StepSolver;

/// Steps with an implicit integrator; owns the sparse factorisation, so it allocates and belongs
/// outside the haptic thread.
class ImplicitStepper {
 public:
  /// `iterations` are how often xpbd goes over all constraints in a step, and projective_dynamics
  /// solves with its matrix: up to 1000, 0 for the usual 5 and 10. The others take 0 alone. Throws
  /// std::invalid_argument for those two where angles have no energy (AngleLaw::eq10).
  ImplicitStepper(const TissueModel& model, Integrator integrator, int iterations = 0);
  ~ImplicitStepper();
  ImplicitStepper(ImplicitStepper&&) noexcept;

  /// Advances `state` by dt [s]; returns the iterations used, or 0 where no solution was found:
  /// positions and time are then as they were. The model must outlive this.
  int step(const Load& load, double dt, State& state);

 private:
  std::unique_ptr<StepSolver> solver_;
};

}  // namespace palpate

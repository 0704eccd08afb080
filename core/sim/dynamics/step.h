// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/load.h"

namespace palpate {

enum class Integrator {
  explicit_euler,    ///< x with the old velocity; never stable without damping
  symplectic_euler,  ///< v first, x with the new v: what Eq 4-5 of the paper really is
  midpoint,          ///< explicit midpoint, second order
  runge_kutta_4,
  implicit_euler_linear,  ///< one Newton step with the projected tangent
  implicit_euler,         ///< Newton until the residual is small
  implicit_midpoint,
};

/// "symplectic_euler" -> Integrator::symplectic_euler; none for an unknown name.
std::optional<Integrator> find_integrator(std::string_view name) noexcept;
std::string_view integrator_name(Integrator integrator) noexcept;

/// Advances `state` by `dt` [s] with symplectic Euler, which must stay below stable_step(model).
/// Does not allocate.
void step(const TissueModel& model, const Load& load, double dt, State& state) noexcept;

/// The same with any explicit integrator; asserts on an implicit one.
void step(const TissueModel& model, const Load& load, double dt, Integrator integrator,
          State& state) noexcept;

/// Steps with an implicit integrator; owns the sparse factorisation, so it allocates and belongs
/// outside the haptic thread.
class ImplicitStepper {
 public:
  ImplicitStepper(const TissueModel& model, Integrator integrator);
  ~ImplicitStepper();
  ImplicitStepper(ImplicitStepper&&) noexcept;

  /// Advances `state` by dt [s]; returns the Newton iterations used. The model must outlive this.
  int step(const Load& load, double dt, State& state);

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace palpate

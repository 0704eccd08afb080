// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "palpate/sim/dynamics/step.h"

namespace palpate {

/// What an ImplicitStepper steps with.
class StepSolver {
 public:
  virtual ~StepSolver() = default;
  /// As ImplicitStepper::step.
  virtual int step(const Load& load, double dt, State& state) = 0;
};

/// Iterations of a step unless told otherwise; 0 for an integrator that has no such number.
int usual_iterations(Integrator integrator) noexcept;

/// Throws std::invalid_argument, with `where` before its field, where an integrator cannot step
/// this tissue, or not so often.
void check_integrator(const std::string& where, const TissueModel& model, Integrator integrator,
                      int iterations);

std::unique_ptr<StepSolver> make_newton(const TissueModel& model, Integrator integrator);
std::unique_ptr<StepSolver> make_xpbd(const TissueModel& model, int iterations);
std::unique_ptr<StepSolver> make_projective_dynamics(const TissueModel& model, int iterations);

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/implicit/private/step_solver.h"

namespace palpate {
namespace {

std::unique_ptr<StepSolver> make_solver(const TissueModel& model, Integrator integrator,
                                        int iterations) {
  const int count = iterations == 0 ? usual_iterations(integrator) : iterations;
  if (integrator == Integrator::xpbd) return make_xpbd(model, count);
  if (integrator == Integrator::projective_dynamics) {
    return make_projective_dynamics(model, count);
  }
  return make_newton(model, integrator);
}

}  // namespace

int usual_iterations(Integrator integrator) noexcept {
  if (integrator == Integrator::xpbd) return 5;
  return integrator == Integrator::projective_dynamics ? 10 : 0;
}

void check_integrator(const std::string& where, const TissueModel& model, Integrator integrator,
                      int iterations) {
  constexpr int kMostIterations = 1000;
  const std::string name(integrator_name(integrator));
  const bool iterates = usual_iterations(integrator) > 0;
  if (!iterates && iterations != 0) {
    refuse(where + "iterations", std::to_string(iterations),
           "0 with " + name + ": only xpbd and projective_dynamics have a number of them");
  }
  if (iterations < 0 || iterations > kMostIterations) {
    refuse(where + "iterations", std::to_string(iterations), "0 to 1000");
  }
  if (iterates && model.angle_law == AngleLaw::eq10 && !model.angles.corners.empty()) {
    refuse(where + "integrator", name,
           "another for angles of eq10: xpbd and projective_dynamics lower an energy, and these "
           "have none");
  }
}

ImplicitStepper::ImplicitStepper(const TissueModel& model, Integrator integrator, int iterations) {
  if (!is_implicit(integrator)) {
    refuse("implicit stepper: integrator", std::string(integrator_name(integrator)),
           "an implicit one");
  }
  check_integrator("implicit stepper: ", model, integrator, iterations);
  solver_ = make_solver(model, integrator, iterations);
}

ImplicitStepper::~ImplicitStepper() = default;
ImplicitStepper::ImplicitStepper(ImplicitStepper&&) noexcept = default;

int ImplicitStepper::step(const Load& load, double dt, State& state) {
  return solver_->step(load, dt, state);
}

}  // namespace palpate

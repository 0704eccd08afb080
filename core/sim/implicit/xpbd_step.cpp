// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/dynamics/private/law.h"
#include "palpate/sim/implicit/private/step_solver.h"
#include "palpate/sim/implicit/private/xpbd.h"

namespace palpate {
namespace {

/// Extended position-based dynamics [Macklin16]: implicit Euler, whose equation
///
///     M (x - x~) = -dt² dU/dx,   x~ = x0 + dt (v0 + dt f/m)/(1 + dt d),   v = (x - x0)/dt
///
/// is solved by going over all constraints, each law's in order, a fixed number of times from x~
/// with multipliers 0. Gravity, pressure and pushes f act as they are at the start of the step,
/// drag d as at its end: it makes every mass 1 + dt d times as heavy against constraints.
class Xpbd final : public StepSolver {
 public:
  Xpbd(const TissueModel& model, int iterations) : model_(model), iterations_(iterations) {
    particles_.position = model.rest_position;
    particles_.inverse_weight.assign(model.mass.size(), 0.0);
    xpbd::add_length_constraints(model, constraints_);
    xpbd::add_solid_constraints(model, constraints_);
  }

  int step(const Load& load, double dt, State& state) override {
    for (const int i : model_.fixed) state.velocity[static_cast<std::size_t>(i)].setZero();
    predict(load, dt, state);
    for (const auto& law : constraints_) law->reset();
    for (int sweep = 0; sweep < iterations_; ++sweep) {
      for (const auto& law : constraints_) law->sweep(particles_);
    }
    for (const Vec3& x : particles_.position) {
      if (!x.allFinite()) return 0;
    }
    for_each_free(model_, [&](int index) {
      const auto i = static_cast<std::size_t>(index);
      state.velocity[i] = (particles_.position[i] - state.position[i]) / dt;
      state.position[i] = particles_.position[i];
    });
    compute_forces(model_, load, state.position, state.velocity, state.force, state.internal);
    advance_internal(model_, dt, state);
    state.time += dt;
    return iterations_;
  }

 private:
  void predict(const Load& load, double dt, State& state) noexcept {
    const double slowed = 1.0 + dt * model_.drag;
    std::fill(state.force.begin(), state.force.end(), Vec3::Zero());
    if (model_.pressure != 0.0) {
      accumulate_pressure_forces(model_.triangles, model_.pressure, state.position, state.force);
    }
    accumulate_gravity(model_.mass, load.gravity, state.force);
    accumulate_load_forces(model_, load, state.force);
    particles_.start = state.position;
    particles_.internal = state.internal;
    particles_.dt = dt;
    particles_.position = state.position;
    for_each_free(model_, [&](int index) {
      const auto i = static_cast<std::size_t>(index);
      const double mass = model_.mass[i];
      particles_.inverse_weight[i] = 1.0 / (slowed * mass);
      particles_.position[i] += (dt / slowed) * (state.velocity[i] + (dt / mass) * state.force[i]);
    });
  }

  const TissueModel& model_;
  int iterations_;
  xpbd::Particles particles_;
  xpbd::ConstraintList constraints_;
};

}  // namespace

std::unique_ptr<StepSolver> make_xpbd(const TissueModel& model, int iterations) {
  return std::make_unique<Xpbd>(model, iterations);
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/step.h"

#include <array>
#include <cassert>
#include <utility>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/dynamics/private/law.h"

namespace palpate {
namespace {

constexpr std::array<std::pair<Integrator, std::string_view>, 9> kNames = {{
    {Integrator::explicit_euler, "explicit_euler"},
    {Integrator::symplectic_euler, "symplectic_euler"},
    {Integrator::midpoint, "midpoint"},
    {Integrator::runge_kutta_4, "runge_kutta_4"},
    {Integrator::implicit_euler_linear, "implicit_euler_linear"},
    {Integrator::implicit_euler, "implicit_euler"},
    {Integrator::implicit_midpoint, "implicit_midpoint"},
    {Integrator::xpbd, "xpbd"},
    {Integrator::projective_dynamics, "projective_dynamics"},
}};

/// x += dt v;  v += dt a(x, v), both with the old x and v.
void step_explicit_euler(const TissueModel& model, const Load& load, double dt,
                         State& state) noexcept {
  compute_forces(model, load, state.position, state.velocity, state.force, state.internal);
  for_each_free(model, [&](int i) {
    state.position[i] += dt * state.velocity[i];
    state.velocity[i] += (dt / model.mass[i]) * state.force[i];
  });
}

/// v += dt a(x, v);  x += dt v with the new v: Eq 4-5 of the paper [BulutDandil22].
void step_symplectic_euler(const TissueModel& model, const Load& load, double dt,
                           State& state) noexcept {
  compute_forces(model, load, state.position, state.velocity, state.force, state.internal);
  for_each_free(model, [&](int i) {
    state.velocity[i] += (dt / model.mass[i]) * state.force[i];
    state.position[i] += dt * state.velocity[i];
  });
}

/// With x', v' half an explicit step ahead:  x += dt v';  v += dt a(x', v').
void step_midpoint(const TissueModel& model, const Load& load, double dt, State& state) noexcept {
  Vec3Array& x = state.scratch.position;
  Vec3Array& v = state.scratch.velocity;
  compute_forces(model, load, state.position, state.velocity, state.force, state.internal);
  x = state.position;
  v = state.velocity;
  for_each_free(model, [&](int i) {
    x[i] += (0.5 * dt) * state.velocity[i];
    v[i] += (0.5 * dt / model.mass[i]) * state.force[i];
  });
  compute_forces(model, load, x, v, state.force, state.internal);
  for_each_free(model, [&](int i) {
    state.position[i] += dt * v[i];
    state.velocity[i] += (dt / model.mass[i]) * state.force[i];
  });
}

/// The classical four stages [HairerLubichWanner06]: slopes at the start, twice in the middle and
/// at the end, weighted 1, 2, 2, 1. Scratch holds the stage and the sum of the slopes.
void step_runge_kutta_4(const TissueModel& model, const Load& load, double dt,
                        State& state) noexcept {
  struct Stage {
    double weight;  // of this stage's slope
    double ahead;   // how far along it, in dt, the next stage lies
  };
  constexpr std::array<Stage, 4> kStages = {{{1.0, 0.5}, {2.0, 0.5}, {2.0, 1.0}, {1.0, 0.0}}};
  // each by its name: clang 14 lets no lambda capture a structured binding
  Vec3Array &x = state.scratch.position, &v = state.scratch.velocity;
  Vec3Array &slope_x = state.scratch.slope_position, &slope_v = state.scratch.slope_velocity;
  x = state.position;
  v = state.velocity;
  for (Vec3& slope : slope_x) slope.setZero();
  for (Vec3& slope : slope_v) slope.setZero();

  for (const Stage& stage : kStages) {
    compute_forces(model, load, x, v, state.force, state.internal);
    for_each_free(model, [&](int i) {
      const Vec3 velocity = v[i], acceleration = state.force[i] / model.mass[i];
      slope_x[i] += stage.weight * velocity;
      slope_v[i] += stage.weight * acceleration;
      x[i] = state.position[i] + (stage.ahead * dt) * velocity;
      v[i] = state.velocity[i] + (stage.ahead * dt) * acceleration;
    });
  }
  for_each_free(model, [&](int i) {
    state.position[i] += (dt / 6.0) * slope_x[i];
    state.velocity[i] += (dt / 6.0) * slope_v[i];
  });
}

}  // namespace

std::optional<Integrator> find_integrator(std::string_view name) noexcept {
  for (const auto& [integrator, its_name] : kNames) {
    if (its_name == name) return integrator;
  }
  return std::nullopt;
}

std::string_view integrator_name(Integrator integrator) noexcept {
  for (const auto& [which, name] : kNames) {
    if (which == integrator) return name;
  }
  return {};
}

bool is_implicit(Integrator integrator) noexcept {
  return integrator >= Integrator::implicit_euler_linear;
}

void step(const TissueModel& model, const Load& load, double dt, State& state) noexcept {
  step(model, load, dt, Integrator::symplectic_euler, state);
}

void step(const TissueModel& model, const Load& load, double dt, Integrator integrator,
          State& state) noexcept {
  // a support has no velocity, or the links on it would be damped against one
  for (const int i : model.fixed) state.velocity[i].setZero();
  switch (integrator) {
    case Integrator::explicit_euler:
      step_explicit_euler(model, load, dt, state);
      break;
    case Integrator::symplectic_euler:
      step_symplectic_euler(model, load, dt, state);
      break;
    case Integrator::midpoint:
      step_midpoint(model, load, dt, state);
      break;
    case Integrator::runge_kutta_4:
      step_runge_kutta_4(model, load, dt, state);
      break;
    default:
      assert(!"an implicit integrator needs an ImplicitStepper");
  }
  advance_internal(model, dt, state);
  state.time += dt;
}

}  // namespace palpate

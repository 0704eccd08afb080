// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/step.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/dynamics/private/law.h"
#include "palpate/sim/dynamics/private/step_limit.h"
#include "palpate/sim/model/private/sum_over_pushes.h"

namespace palpate {
namespace {

constexpr std::array<std::pair<Integrator, std::string_view>, 10> kNames = {{
    {Integrator::explicit_euler, "explicit_euler"},
    {Integrator::symplectic_euler, "symplectic_euler"},
    {Integrator::midpoint, "midpoint"},
    {Integrator::runge_kutta_4, "runge_kutta_4"},
    {Integrator::symplectic_euler_implicit_damping, "symplectic_euler_implicit_damping"},
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

/// The velocities are solved for until what is left is this part of the change that they make.
constexpr double kLeftOver = 1e-5;
/// More than a damping rate of ten thousand a step asks for.
constexpr int kMostRounds = 400;

/// r' M⁻¹ r over the particles that move [J].
double weigh(const TissueModel& model, const Vec3Array& r) noexcept {
  double sum = 0.0;
  for_each_free(model, [&](int i) { sum += r[i].squaredNorm() / model.mass[i]; });
  return sum;
}

/// Of (M + dt C) u = r, by conjugate gradients in the metric of the masses [HestenesStiefel52]: `u`
/// is the change of velocity [m/s], `r` [N·s] what is left over, also of what supports carry.
///
/// A product with C is one pass over what is damped, and no matrix is made. What is not damped is
/// right after one round, drag alone as well: every particle is then slowed in the same proportion.
/// In the end r is below kLeftOver of what it was, and with it the error of u, as M + dt C is
/// nowhere less than M. The rounds grow with the root of how much faster a step damps one motion
/// than another.
void solve_damping(const TissueModel& model, double dt, State& state) noexcept {
  const Vec3Array& x = state.position;
  Vec3Array &u = state.scratch.position, &r = state.scratch.velocity;
  Vec3Array &p = state.scratch.slope_velocity, &q = state.scratch.slope_position;
  double left = weigh(model, r);
  const double enough = kLeftOver * kLeftOver * left;
  std::fill(p.begin(), p.end(), Vec3::Zero());
  for_each_free(model, [&](int i) { p[i] = r[i] / model.mass[i]; });
  for (int round = 0; round < kMostRounds && left > enough; ++round) {
    std::fill(q.begin(), q.end(), Vec3::Zero());
    accumulate_damping(model, x, p, q);
    double curvature = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] = model.mass[i] * p[i] - dt * q[i];
      curvature += p[i].dot(q[i]);
    }
    const double stride = left / curvature;
    for (std::size_t i = 0; i < q.size(); ++i) {
      u[i] += stride * p[i];
      r[i] -= stride * q[i];
    }
    const double before = left;
    left = weigh(model, r);
    for_each_free(model, [&](int i) { p[i] = r[i] / model.mass[i] + (left / before) * p[i]; });
  }
}

/// v += u,  x += dt v,  with  M u = dt f(x, v + u)  and f linear in velocities:
///
///     (M + dt C(x)) u = dt f(x, v)
void step_with_implicit_damping(const TissueModel& model, const Load& load, double dt,
                                State& state) noexcept {
  Vec3Array &u = state.scratch.position, &r = state.scratch.velocity;
  compute_forces(model, load, state.position, state.velocity, state.force, state.internal);
  std::fill(u.begin(), u.end(), Vec3::Zero());
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = dt * state.force[i];
  solve_damping(model, dt, state);
  for (std::size_t i = 0; i < r.size(); ++i) state.force[i] = r[i] / dt;  // of supports
  for_each_free(model, [&](int i) {
    state.force[i] = (model.mass[i] / dt) * u[i];
    state.velocity[i] += u[i];
    state.position[i] += dt * state.velocity[i];
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
    case Integrator::symplectic_euler_implicit_damping:
      step_with_implicit_damping(model, load, dt, state);
      break;
    default:
      assert(!"an implicit integrator needs an ImplicitStepper");
  }
  advance_internal(model, dt, state);
  state.time += dt;
}

double kick(const TissueModel& model, const Load& load, double dt, State& state) noexcept {
  for (const int i : model.fixed) state.velocity[static_cast<std::size_t>(i)].setZero();
  const double before = sum_over_pushes(load.pushes(), model, state.velocity);
  std::fill(state.force.begin(), state.force.end(), Vec3::Zero());
  accumulate_load_forces(model, load, state.force);
  for_each_free(model, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    state.velocity[at] += (dt / model.mass[at]) * state.force[at];
  });
  return 0.5 * dt * (before + sum_over_pushes(load.pushes(), model, state.velocity));
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <stdexcept>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/dynamics/step.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

TEST_CASE("a stepper of an explicit integrator is refused by name") {
  const TissueModel model = scenes::make_oscillator_model();

  CHECK_THROWS_WITH_AS(ImplicitStepper(model, Integrator::midpoint),
                       "implicit stepper: integrator: got midpoint, expected an implicit one",
                       std::invalid_argument);
}

TEST_CASE("implicit Euler divides an oscillator by 1 + (w dt)² and needs one iteration") {
  const TissueModel model = scenes::make_oscillator_model(0.25, 100.0);
  for (const Integrator integrator :
       {Integrator::implicit_euler_linear, Integrator::implicit_euler}) {
    State state(model);
    state.position[1].x() += 1e-3;
    ImplicitStepper stepper(model, integrator);

    const int iterations = stepper.step(Load(), 0.05, state);  // w dt = 1

    CHECK(iterations == 1);
    CHECK(state.position[1].x() - 0.01 == Approx(0.5e-3));
    CHECK(state.velocity[1].x() == Approx(-0.5e-3 / 0.05));
    CHECK(state.time == 0.05);
  }
}

TEST_CASE("implicit midpoint turns an oscillator by (1 - i h/2)/(1 + i h/2)") {
  const TissueModel model = scenes::make_oscillator_model(0.25, 100.0);
  State state(model);
  state.position[1].x() += 1e-3;
  ImplicitStepper stepper(model, Integrator::implicit_midpoint);

  stepper.step(Load(), 0.05, state);  // h = w dt = 1

  CHECK(state.position[1].x() - 0.01 == Approx(1e-3 * 0.6));   // (1 - 1/4)/(1 + 1/4)
  CHECK(state.velocity[1].x() == Approx(-20.0 * 1e-3 * 0.8));  // -w sin
}

TEST_CASE("after a full implicit step the forces at its end balance the change of momentum") {
  const TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.3, .drag = 2.0});
  Load load(1);
  load.gravity = {0, 0, -9.81};
  load.add({5, {0.3, 0.3, 0.4}, {0.05, 0.0, -0.1}});
  State state(model);
  scenes::shake(model, 1e-3, 0.1, state);
  ImplicitStepper stepper(model, Integrator::implicit_euler);
  const double dt = 5e-3;

  for (int s = 0; s < 5; ++s) {
    const State before = state;
    const int iterations = stepper.step(load, dt, state);

    Vec3Array f(state.position.size());
    compute_forces(model, load, state.position, state.velocity, f);
    double residual = 0.0, momentum = 0.0;
    std::vector<bool> held(f.size(), false);
    for (const int i : model.fixed) held[i] = true;
    for (std::size_t i = 0; i < f.size(); ++i) {
      if (held[i]) continue;
      const Vec3 change = model.mass[i] * (state.velocity[i] - before.velocity[i]);
      residual = std::max(residual, (change - dt * f[i]).norm());
      momentum = std::max(momentum, change.norm());
    }
    CHECK(residual < 1e-9 * momentum);
    CHECK(iterations > 1);
    CHECK(iterations < 20);
  }
}

TEST_CASE("Newton converges from a crushed organ too, where the exact tangent is indefinite") {
  const TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.3});
  State state(model);
  for (Vec3& x : state.position) x.x() *= 0.3;
  for (const int i : model.fixed) state.position[i] = model.rest_position[i];
  ImplicitStepper stepper(model, Integrator::implicit_euler);
  const double start = compute_energy(model, Vec3::Zero(), state).elastic();

  for (int s = 0; s < 20; ++s) CHECK(stepper.step(Load(), 0.01, state) < 50);

  const Energy energy = compute_energy(model, Vec3::Zero(), state);
  CHECK(energy.elastic() + energy.kinetic < 0.1 * start);
}

TEST_CASE("one Newton step ends near the full solution") {
  const TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.2});
  State linear(model);
  scenes::shake(model, 2e-4, 0.05, linear);
  State full = linear;
  const State start = linear;
  ImplicitStepper one(model, Integrator::implicit_euler_linear);
  ImplicitStepper all(model, Integrator::implicit_euler);

  one.step(Load(), 2e-3, linear);
  all.step(Load(), 2e-3, full);

  const double moved = scenes::max_difference(full.position, start.position);
  CHECK(scenes::max_difference(linear.position, full.position) < 0.05 * moved);
}

TEST_CASE("an implicit step of a tissue at rest leaves it at rest") {
  const TissueModel model = scenes::make_molecular_organ(1);
  State state(model);
  ImplicitStepper stepper(model, Integrator::implicit_euler);

  stepper.step(Load(), 0.01, state);

  CHECK(scenes::max_difference(state.position, model.rest_position) < 1e-15);
}

TEST_CASE("implicit steps hold under Eq 10 and inner pressure, which their tangent leaves out") {
  TissueModel model =
      scenes::make_molecular_organ(1, {.damping_ratio = 0.3, .drag = 2.0}, AngleLaw::eq10);
  model.pressure = 200.0;
  State state(model);
  scenes::shake(model, 1e-3, 0.1, state);
  ImplicitStepper stepper(model, Integrator::implicit_euler);

  for (int s = 0; s < 50; ++s) CHECK(stepper.step(Load(), 5e-3, state) < 50);

  CHECK(scenes::max_difference(state.position, model.rest_position) < 0.01);
}

TEST_CASE("a stepper that has moved house goes on") {
  const TissueModel model = scenes::make_oscillator_model(0.25, 100.0);
  State state(model);
  state.position[1].x() += 1e-3;
  ImplicitStepper first(model, Integrator::implicit_euler);
  first.step(Load(), 0.05, state);

  ImplicitStepper second = std::move(first);
  second.step(Load(), 0.05, state);

  CHECK(state.time == Approx(0.1));
  CHECK(std::isfinite(state.position[1].x()));
}

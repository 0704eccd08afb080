// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/dynamics/step.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

constexpr Integrator kExplicit[] = {Integrator::explicit_euler, Integrator::symplectic_euler,
                                    Integrator::midpoint, Integrator::runge_kutta_4,
                                    Integrator::symplectic_euler_implicit_damping};
constexpr Integrator kImplicit[] = {Integrator::implicit_euler_linear, Integrator::implicit_euler,
                                    Integrator::implicit_midpoint, Integrator::xpbd,
                                    Integrator::projective_dynamics};

/// One step of 10 ms from 1 mm beyond rest, k/m = 400 1/s², so w dt = 0.2.
State step_oscillator_once(Integrator integrator) {
  const TissueModel model = scenes::make_oscillator_model(0.25, 100.0);
  State state(model);
  state.position[1].x() += 1e-3;
  step(model, Load(), 0.01, integrator, state);
  state.position[1].x() -= 0.01;
  return state;
}

}  // namespace

TEST_CASE("every integrator is found by its name and by no other") {
  for (const Integrator integrator : kExplicit) {
    CHECK(find_integrator(integrator_name(integrator)) == integrator);
  }
  for (const Integrator integrator : kImplicit) {
    CHECK(find_integrator(integrator_name(integrator)) == integrator);
  }
  CHECK(integrator_name(Integrator::symplectic_euler) == "symplectic_euler");
  CHECK_FALSE(find_integrator("euler").has_value());
  CHECK_FALSE(find_integrator("").has_value());
}

// a = -w² x = -0.4 m/s² at x = 1 mm; h = w dt = 0.2

TEST_CASE("explicit Euler moves with the old velocity, which is nothing") {
  const State state = step_oscillator_once(Integrator::explicit_euler);

  CHECK(state.position[1].x() == Approx(1e-3));
  CHECK(state.velocity[1].x() == Approx(-4e-3));
}

TEST_CASE("symplectic Euler moves with the new velocity") {
  const State state = step_oscillator_once(Integrator::symplectic_euler);

  CHECK(state.velocity[1].x() == Approx(-4e-3));
  CHECK(state.position[1].x() == Approx(1e-3 - 4e-5));  // 1 - h²
}

TEST_CASE("implicit damping of dt c/m = 1 halves the velocity that symplectic Euler would give") {
  const TissueModel model = scenes::make_oscillator_model(0.25, 100.0, 25.0);
  State state(model);
  state.position[1].x() += 1e-3;
  step(model, Load(), 0.01, Integrator::symplectic_euler_implicit_damping, state);

  CHECK(state.velocity[1].x() == Approx(-2e-3));
  CHECK(state.position[1].x() - model.rest_position[1].x() == Approx(1e-3 - 2e-5));
  // what moved it, and what the support carries: the spring, 0.1 N, less half of it in the damper
  CHECK(state.force[1].x() == Approx(-0.05));
  CHECK(state.force[0].x() == Approx(0.05));
}

TEST_CASE("drag alone slows every particle by 1 + dt drag, exactly and in one round") {
  TissueModel model = scenes::make_chain_model(4);
  model.springs.stiffness.assign(model.springs.stiffness.size(), 0.0);
  model.drag = 300.0;
  State state(model);
  for (std::size_t i = 1; i < 4; ++i) state.velocity[i] = {0.1 * double(i), 0.2, -0.3};
  const Vec3Array before = state.velocity;
  step(model, Load(), 0.01, Integrator::symplectic_euler_implicit_damping, state);
  for (std::size_t i = 1; i < 4; ++i) {
    CHECK((state.velocity[i] - before[i] / 4.0).norm() < 1e-15);
  }
}

TEST_CASE("midpoint moves with the velocity half way") {
  const State state = step_oscillator_once(Integrator::midpoint);

  CHECK(state.position[1].x() == Approx(1e-3 * (1.0 - 0.02)));  // 1 - h²/2
  CHECK(state.velocity[1].x() == Approx(-4e-3));
}

TEST_CASE("Runge-Kutta 4 is Taylor's series of the cosine and the sine to the fourth power") {
  const State state = step_oscillator_once(Integrator::runge_kutta_4);

  CHECK(state.position[1].x() == Approx(1e-3 * (1.0 - 0.02 + 0.0016 / 24.0)).epsilon(1e-12));
  CHECK(state.velocity[1].x() == Approx(-0.02 * (0.2 - 0.008 / 6.0)).epsilon(1e-12));
}

TEST_CASE("a step is symplectic Euler unless told otherwise, and time goes on by dt") {
  const TissueModel model = scenes::make_molecular_organ(1);
  State plain(model), named(model);
  scenes::shake(model, 1e-3, 0.1, plain);
  named = plain;

  step(model, Load(), 1e-4, plain);
  step(model, Load(), 1e-4, Integrator::symplectic_euler, named);

  CHECK(plain.position == named.position);
  CHECK(plain.velocity == named.velocity);
  CHECK(plain.time == 1e-4);
}

TEST_CASE("fixed particles never move, whatever pulls at them and whatever integrator") {
  TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.2});
  model.pressure = 200.0;
  Load load(1);
  load.gravity = {3.0, 0, -9.81};
  for (int t = 0; t < static_cast<int>(model.triangles.size()); ++t) {
    if (model.triangles[t][0] != model.fixed[0]) continue;
    load.add({t, {1.0, 0.0, 0.0}, {5.0, 5.0, 5.0}});
    break;
  }
  REQUIRE(load.push_count == 1);
  const auto check_held = [&](const State& state) {
    for (const int i : model.fixed) {
      CHECK(state.position[i] == model.rest_position[i]);
      CHECK(state.velocity[i] == Vec3::Zero());
    }
    CHECK(scenes::max_difference(state.position, model.rest_position) > 1e-6);
  };

  for (const Integrator integrator : kExplicit) {
    State state(model);
    state.velocity[model.fixed[0]] = {1.0, 1.0, 1.0};
    for (int s = 0; s < 20; ++s) step(model, load, 1e-4, integrator, state);
    check_held(state);
  }
  for (const Integrator integrator : kImplicit) {
    State state(model);
    state.velocity[model.fixed[0]] = {1.0, 1.0, 1.0};
    ImplicitStepper stepper(model, integrator);
    for (int s = 0; s < 3; ++s) stepper.step(load, 1e-3, state);
    check_held(state);
  }
}

TEST_CASE("two runs of any integrator give the same bits") {
  const TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.1, .drag = 1.0});
  State start(model);
  scenes::shake(model, 1e-3, 0.1, start);
  Load load;
  load.gravity = {0, 0, -9.81};

  for (const Integrator integrator : kExplicit) {
    State one = start, two = start;
    for (int s = 0; s < 300; ++s) step(model, load, 1e-4, integrator, one);
    for (int s = 0; s < 300; ++s) step(model, load, 1e-4, integrator, two);
    CHECK(one.position == two.position);
    CHECK(one.velocity == two.velocity);
    CHECK(one.force == two.force);
  }
  for (const Integrator integrator : kImplicit) {
    State one = start, two = start;
    ImplicitStepper first(model, integrator), second(model, integrator);
    for (int s = 0; s < 5; ++s) first.step(load, 2e-3, one);
    for (int s = 0; s < 5; ++s) second.step(load, 2e-3, two);
    CHECK(one.position == two.position);
    CHECK(one.velocity == two.velocity);
  }
}

TEST_CASE("a body that flies free keeps its momentum, and its angular momentum too") {
  TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.2});
  model.fixed = {};
  State state(model);
  scenes::shake(model, 1e-3, 0.1, state);
  const auto momenta = [&](const State& at) {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
    for (std::size_t i = 0; i < model.mass.size(); ++i) {
      linear += model.mass[i] * at.velocity[i];
      angular += model.mass[i] * at.position[i].cross(at.velocity[i]);
    }
    return std::pair{linear, angular};
  };
  const auto [linear, angular] = momenta(state);

  // symplectic Euler keeps both exactly: forces act where the particles are
  for (int s = 0; s < 2000; ++s) step(model, Load(), 1e-4, state);

  const auto [linear_after, angular_after] = momenta(state);
  CHECK((linear_after - linear).norm() < 1e-11 * linear.norm());
  CHECK((angular_after - angular).norm() < 1e-11 * angular.norm());
}

TEST_CASE("drag alone slows every particle by dt drag a step") {
  TissueModel model;
  model.rest_position = {{0, 0, 0}, {1, 0, 0}};
  model.mass = {0.1, 7.0};
  model.drag = 3.0;
  State state(model);
  state.velocity = {{1, 0, 0}, {0, 2, 0}};

  step(model, Load(), 0.01, state);

  CHECK(state.velocity[0].x() == Approx(0.97));
  CHECK(state.velocity[1].y() == Approx(1.94));
}

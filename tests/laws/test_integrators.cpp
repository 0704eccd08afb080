// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "palpate/sim/dynamics/step.h"
#include "scenes/hyperelastic_solids.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

struct Ordered {
  Integrator integrator;
  int order;
};

constexpr Ordered kEvery[] = {{Integrator::explicit_euler, 1},
                              {Integrator::symplectic_euler, 1},
                              {Integrator::midpoint, 2},
                              {Integrator::runge_kutta_4, 4},
                              {Integrator::symplectic_euler_implicit_damping, 1},
                              {Integrator::implicit_euler_linear, 1},
                              {Integrator::implicit_euler, 1},
                              {Integrator::implicit_midpoint, 2},
                              {Integrator::xpbd, 1},
                              {Integrator::projective_dynamics, 1}};

State run(const TissueModel& model, const Load& load, Integrator integrator, double duration,
          int steps, State state) {
  const double dt = duration / steps;
  if (is_implicit(integrator)) {
    ImplicitStepper stepper(model, integrator);
    for (int s = 0; s < steps; ++s) stepper.step(load, dt, state);
  } else {
    for (int s = 0; s < steps; ++s) step(model, load, dt, integrator, state);
  }
  return state;
}

/// log2 of how much less the result changes at the second halving of dt than at the first.
double measure_order(const TissueModel& model, const Load& load, const State& start,
                     Integrator integrator, double duration, int steps) {
  const State one = run(model, load, integrator, duration, steps, start);
  const State two = run(model, load, integrator, duration, 2 * steps, start);
  const State four = run(model, load, integrator, duration, 4 * steps, start);
  double first = 0.0, second = 0.0;
  for (std::size_t i = 0; i < one.position.size(); ++i) {
    first += (one.position[i] - two.position[i]).squaredNorm();
    second += (two.position[i] - four.position[i]).squaredNorm();
  }
  return 0.5 * std::log2(first / second);
}

}  // namespace

TEST_CASE("every integrator converges with its order on a damped tissue in large motion") {
  TissueModel model = scenes::make_molecular_organ(0, {.damping_ratio = 0.1, .drag = 3.0});
  model.pressure = 100.0;
  Load load(1);
  load.gravity = {0.0, 2.0, -9.81};
  load.add({4, {0.2, 0.3, 0.5}, {0.3, 0.1, -0.5}});
  State start(model);
  scenes::shake(model, 2e-3, 0.2, start);

  for (const auto& each : kEvery) {
    CAPTURE(std::string(integrator_name(each.integrator)));
    const auto [integrator, order] = each;
    const int steps = integrator == Integrator::runge_kutta_4 ? 40 : order == 2 ? 100 : 400;

    const double measured = measure_order(model, load, start, integrator, 0.02, steps);

    CHECK(measured == Approx(order).epsilon(0.1));
  }
}

TEST_CASE("every integrator converges with its order on a solid of springs and volumes") {
  const TissueModel model = scenes::make_solid_organ(2, 0.9, {.damping_ratio = 0.1});
  Load load(1);
  load.gravity = {0.0, 2.0, -9.81};
  State start(model);
  scenes::shake(model, 1e-3, 0.1, start);

  for (const auto& each : kEvery) {
    CAPTURE(std::string(integrator_name(each.integrator)));
    const auto [integrator, order] = each;
    const int steps = integrator == Integrator::runge_kutta_4 ? 10 : order == 2 ? 25 : 100;

    CHECK(measure_order(model, load, start, integrator, 0.005, steps) ==
          Approx(order).epsilon(0.1));
  }
}

TEST_CASE("every integrator converges with its order on tetrahedra at finite strain" *
          doctest::test_suite("landing")) {
  Load load(1);
  load.gravity = {0.0, 2.0, -9.81};
  for (const scenes::FiniteLaw& law : scenes::kFiniteLaws) {
    const TissueModel model = scenes::make_finite_organ(law, 2, 0.9, {.damping_ratio = 0.1});
    State start(model);
    scenes::shake(model, 1e-3, 0.1, start);
    for (const auto& each : kEvery) {
      CAPTURE(std::string(law.name));
      CAPTURE(std::string(integrator_name(each.integrator)));
      const auto [integrator, order] = each;
      const int steps = integrator == Integrator::runge_kutta_4 ? 15 : order == 2 ? 25 : 100;

      CHECK(measure_order(model, load, start, integrator, 0.005, steps) ==
            Approx(order).epsilon(0.1));
    }
  }
}

TEST_CASE("every integrator converges to the same motion") {
  const TissueModel model = scenes::make_molecular_organ(0, {.damping_ratio = 0.2});
  State start(model);
  scenes::shake(model, 1e-3, 0.1, start);
  const State reference = run(model, Load(), Integrator::runge_kutta_4, 0.02, 1000, start);
  const double moved = scenes::max_difference(reference.position, start.position);

  for (const auto& each : kEvery) {
    CAPTURE(std::string(integrator_name(each.integrator)));
    const auto [integrator, order] = each;
    const State end = run(model, Load(), integrator, 0.02, order == 1 ? 4000 : 500, start);

    CHECK(scenes::max_difference(end.position, reference.position) < 0.01 * moved);
  }
}

TEST_CASE("every integrator follows an oscillator's cosine") {
  const double mass = 1e-3, stiffness = 100.0, w = std::sqrt(stiffness / mass);
  const TissueModel model = scenes::make_oscillator_model(mass, stiffness);
  State start(model);
  start.position[1].x() += 1e-3;
  const double third = 2.0 * std::numbers::pi / w / 3.0;  // of a period: the cosine is -1/2

  for (const auto& each : kEvery) {
    CAPTURE(std::string(integrator_name(each.integrator)));
    const auto [integrator, order] = each;
    const State end = run(model, Load(), integrator, third, order == 1 ? 10000 : 200, start);

    CHECK(end.position[1].x() - 0.01 == Approx(-0.5e-3).epsilon(1e-3));
  }
}

TEST_CASE("the tip of a hanging chain comes to rest m g n (n + 1) / (2 k) lower") {
  const int links = 10;
  const double mass = 1e-3, stiffness = 100.0, g = 9.81;
  TissueModel model = scenes::make_chain_model(links + 1, mass, stiffness, 0.2);
  Load load;
  load.gravity = {g, 0, 0};  // the chain runs along +x
  State state(model);

  for (int s = 0; s < 60000; ++s) step(model, load, 1e-3, state);

  const double sag = state.position[links].x() - model.rest_position[links].x();
  CHECK(sag == Approx(mass * g * links * (links + 1) / (2.0 * stiffness)).epsilon(1e-6));
}

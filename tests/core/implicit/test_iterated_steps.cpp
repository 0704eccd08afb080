// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <string>

#include "core/model/refusal.h"
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/step.h"
#include "scenes/hyperelastic_solids.h"
#include "scenes/linear_solids.h"
#include "scenes/shells.h"
#include "scenes/tissues.h"

// What XPBD and projective dynamics have in common.

using namespace palpate;
using doctest::Approx;

namespace {

constexpr Integrator kIterated[] = {Integrator::xpbd, Integrator::projective_dynamics};

struct Tissue {
  std::string name;
  TissueModel model;
};

/// One of every law, all of it damped.
std::vector<Tissue> list_tissues() {
  const scenes::Losses losses = {.damping_ratio = 0.2, .drag = 2.0};
  TissueModel relaxing = scenes::make_molecular_organ(1, losses);
  relaxing.maxwell = {.ratio = 0.5, .time = 0.4};
  std::vector<Tissue> tissues = {
      {"springs", scenes::make_spring_organ(1, losses)},
      {"springs damped all ways",
       scenes::make_spring_organ(1, {.damping_ratio = 0.2, .law = DampingLaw::isotropic})},
      {"molecular", scenes::make_molecular_organ(1, losses)},
      {"relaxing", relaxing},
      {"home springs", scenes::make_sheet_tissue(losses)},
      {"shell", scenes::make_shell_organ(1, losses)},
      {"solid", scenes::make_solid_organ(2, 0.9, losses)},
      {"linear", scenes::make_linear_organ(2, 0.9, 0.2)}};
  for (const scenes::FiniteLaw& law : scenes::kFiniteLaws) {
    tissues.push_back({law.name, scenes::make_finite_organ(law, 2, 0.9, losses)});
  }
  return tissues;
}

State shaken(const TissueModel& model) {
  State state(model);
  scenes::shake(model, 3e-4, 0.05, state);
  return state;
}

Load make_weight() {
  Load load(1);
  load.gravity = {0.0, 2.0, -9.81};
  load.add({4, {0.2, 0.3, 0.5}, {0.03, 0.01, -0.05}});
  return load;
}

State run(const TissueModel& model, Integrator integrator, int iterations, double dt, int steps,
          State state, const Load& load = make_weight()) {
  ImplicitStepper stepper(model, integrator, iterations);
  for (int s = 0; s < steps; ++s) REQUIRE(stepper.step(load, dt, state) > 0);
  return state;
}

double measure_energy(const TissueModel& model, const State& state) {
  return compute_energy(model, Vec3::Zero(), state).total();
}

}  // namespace

TEST_CASE("on one spring both are implicit Euler after one iteration") {
  // k dt²/m = 0.04, so 1 mm goes to 1/1.04 of it
  const TissueModel model = scenes::make_oscillator_model(0.25, 100.0);
  for (const Integrator integrator : kIterated) {
    State state(model);
    state.position[1].x() += 1e-3;
    ImplicitStepper stepper(model, integrator, 1);

    CHECK(stepper.step(Load(), 0.01, state) == 1);

    CHECK(state.position[1].x() - 0.01 == Approx(1e-3 / 1.04).epsilon(1e-12));
    CHECK(state.velocity[1].x() == Approx(-1e-3 * 0.04 / 1.04 / 0.01).epsilon(1e-12));
    CHECK(state.time == 0.01);
  }
}

TEST_CASE("projective dynamics comes to the step of implicit Euler under every law") {
  for (const Tissue& tissue : list_tissues()) {
    CAPTURE(tissue.name);
    const State start = shaken(tissue.model);
    const double dt = 2.0 * stable_step(tissue.model);
    const State expected = run(tissue.model, Integrator::implicit_euler, 0, dt, 2, start);
    const double moved = scenes::max_difference(expected.position, start.position);

    const State found = run(tissue.model, Integrator::projective_dynamics, 1000, dt, 2, start);

    CHECK(scenes::max_difference(found.position, expected.position) < 1e-7 * moved);
  }
}

// the gradients of a constraint turn within a step, and the pushes that XPBD has given before are
// along those of before: an error of the second order, which a law without turning has not
TEST_CASE("XPBD comes to the step of implicit Euler, but for how far things turn in a step") {
  for (const Tissue& tissue : list_tissues()) {
    CAPTURE(tissue.name);
    const State start = shaken(tissue.model);
    const auto measure = [&](double dt) {
      const State expected = run(tissue.model, Integrator::implicit_euler, 0, dt, 1, start);
      const State found = run(tissue.model, Integrator::xpbd, 1000, dt, 1, start);
      return scenes::max_difference(found.position, expected.position) /
             scenes::max_difference(expected.position, start.position);
    };
    const double step = stable_step(tissue.model), left = measure(step);
    if (tissue.name == "linear") {
      CHECK(left < 1e-9);
      continue;
    }
    CHECK(left < 0.02);
    CHECK(measure(0.25 * step) < 0.5 * left);
  }
}

TEST_CASE("what is at rest stays at rest to the last bit, or rounding") {
  for (const Tissue& tissue : list_tissues()) {
    for (const Integrator integrator : kIterated) {
      CAPTURE(tissue.name);
      const State start(tissue.model);
      const State end = run(tissue.model, integrator, 3, 1e-3, 5, start, Load());
      CHECK(scenes::max_difference(end.position, start.position) < 1e-14);
    }
  }
}

TEST_CASE("a body that flies free keeps its momentum however few iterations there are") {
  for (Tissue& tissue : list_tissues()) {
    tissue.model.fixed = {};
    tissue.model.home.clear();
    tissue.model.drag = 0.0;
    const State start = shaken(tissue.model);
    const auto momentum = [&](const State& state) {
      Vec3 total = Vec3::Zero();
      for (std::size_t i = 0; i < state.velocity.size(); ++i) {
        total += tissue.model.mass[i] * state.velocity[i];
      }
      return total;
    };
    for (const Integrator integrator : kIterated) {
      CAPTURE(tissue.name);
      const State end = run(tissue.model, integrator, 2, 5e-4, 20, start, Load());
      CHECK((momentum(end) - momentum(start)).norm() < 1e-9 * momentum(start).norm());
    }
  }
}

TEST_CASE("turning the world turns every step with it, but that of a linear solid") {
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  for (Tissue& tissue : list_tissues()) {
    if (tissue.name == "linear") continue;
    TissueModel turned = tissue.model;
    for (Vec3& x : turned.rest_position) x = turn * x;
    State start = shaken(tissue.model);
    for (const int i : tissue.model.fixed) start.velocity[static_cast<std::size_t>(i)].setZero();
    State turned_start = start;
    for (Vec3& x : turned_start.position) x = turn * x;
    for (Vec3& v : turned_start.velocity) v = turn * v;
    for (const Integrator integrator : kIterated) {
      CAPTURE(tissue.name);
      State end = run(tissue.model, integrator, 4, 1e-3, 5, start, Load());
      const State turned_end = run(turned, integrator, 4, 1e-3, 5, turned_start, Load());
      const double moved = scenes::max_difference(end.position, start.position);
      for (Vec3& x : end.position) x = turn * x;
      CHECK(scenes::max_difference(end.position, turned_end.position) < 1e-9 * moved);
    }
  }
}

TEST_CASE("with enough iterations energy only falls, at any step") {
  for (const Tissue& tissue : list_tissues()) {
    for (const double longer : {1.0, 5.0, 25.0}) {
      for (const Integrator integrator : kIterated) {
        CAPTURE(tissue.name);
        CAPTURE(longer);
        CAPTURE(std::string(integrator_name(integrator)));
        const double dt = longer * stable_step(tissue.model);
        State state = shaken(tissue.model);
        ImplicitStepper stepper(tissue.model, integrator, 100);
        double last = measure_energy(tissue.model, state);
        for (int s = 0; s < 5; ++s) {
          REQUIRE(stepper.step(Load(), dt, state) > 0);
          const double now = measure_energy(tissue.model, state);
          CHECK(now <= last * (1.0 + 1e-9));
          last = now;
        }
      }
    }
  }
}

TEST_CASE("two steppers give the same bits, and one that has moved house goes on") {
  for (const Tissue& tissue : list_tissues()) {
    for (const Integrator integrator : kIterated) {
      State one = shaken(tissue.model), two = one;
      ImplicitStepper first(tissue.model, integrator), second(tissue.model, integrator);
      for (int s = 0; s < 4; ++s) first.step(make_weight(), s % 2 ? 1e-3 : 5e-4, one);
      for (int s = 0; s < 2; ++s) second.step(make_weight(), s % 2 ? 1e-3 : 5e-4, two);
      ImplicitStepper third = std::move(second);
      for (int s = 2; s < 4; ++s) third.step(make_weight(), s % 2 ? 1e-3 : 5e-4, two);
      CHECK(one.position == two.position);
      CHECK(one.velocity == two.velocity);
    }
  }
}

TEST_CASE("a step that finds no solution leaves positions and time as they were") {
  const TissueModel model = scenes::make_spring_organ(1);
  for (const Integrator integrator : kIterated) {
    State state(model);
    state.velocity.back().x() = std::numeric_limits<double>::quiet_NaN();
    ImplicitStepper stepper(model, integrator);
    CHECK(stepper.step(Load(), 1e-3, state) == 0);
    CHECK(state.position == model.rest_position);
    CHECK(state.time == 0.0);
  }
}

TEST_CASE("forces after a step are those of its end") {
  const TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.2});
  for (const Integrator integrator : kIterated) {
    const State end = run(model, integrator, 5, 1e-3, 3, shaken(model));
    Vec3Array f(end.force.size());
    compute_forces(model, make_weight(), end.position, end.velocity, f);
    CHECK(f == end.force);
  }
}

// x'' - 2 x' + x + a x'' + b x' = 0 with a = k dt²/m of the spring and b of a contact, whose push
// is of the start of the step: -1 is a root at b = 4 + a
TEST_CASE("a contact of stiffness K holds up to K dt²/m = 4 + k dt²/m and no further") {
  const double mass = 0.25, k = 100.0, dt = 0.08, a = k * dt * dt / mass;
  TissueModel model = scenes::make_oscillator_model(mass, k);
  model.triangles = {{0, 1, 1}};
  for (const Integrator integrator : kIterated) {
    CAPTURE(std::string(integrator_name(integrator)));
    const auto largest_after = [&](double b) {
      State state(model);
      state.position[1].x() += 1e-6;
      ImplicitStepper stepper(model, integrator, 1);
      Load load(1);
      for (int s = 0; s < 400; ++s) {
        const double out = state.position[1].x() - model.rest_position[1].x();
        load.clear();
        load.add({0, {0.0, 1.0, 0.0}, {-b * mass / (dt * dt) * out, 0.0, 0.0}});
        stepper.step(load, dt, state);
      }
      return std::abs(state.position[1].x() - model.rest_position[1].x());
    };
    CHECK(largest_after(0.98 * (4.0 + a)) < 1e-6);
    CHECK(largest_after(1.02 * (4.0 + a)) > 1e-4);
  }
}

TEST_CASE("what has no energy, or no iterations to count, is refused with a sentence") {
  const TissueModel eq10 = scenes::make_molecular_organ(0, {}, AngleLaw::eq10);
  const TissueModel model = scenes::make_molecular_organ(0);
  CHECK(find_refusal([&] { ImplicitStepper(eq10, Integrator::xpbd); }) ==
        "implicit stepper: integrator: got xpbd, expected another for angles of eq10: xpbd and "
        "projective_dynamics lower an energy, and these have none");
  CHECK(find_refusal([&] { ImplicitStepper(model, Integrator::implicit_euler, 3); }) ==
        "implicit stepper: iterations: got 3, expected 0 with implicit_euler: only xpbd and "
        "projective_dynamics have a number of them");
  CHECK(find_refusal([&] { ImplicitStepper(model, Integrator::projective_dynamics, 1001); }) ==
        "implicit stepper: iterations: got 1001, expected 0 to 1000");
  CHECK(find_refusal([&] { ImplicitStepper(model, Integrator::xpbd, -1); }) ==
        "implicit stepper: iterations: got -1, expected 0 to 1000");
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "laws/linear_tissue.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/simd_targets.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::laws;

namespace {

constexpr int kSteps = 400;

/// The farther from where it is held, the faster: the whole tissue sways in its slow modes.
State sway(const TissueModel& model, const Vec3& velocity) {
  State state(model);
  std::vector<double> distance(state.position.size(), INFINITY);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    for (const int held : model.fixed) {
      distance[i] = std::min(distance[i], (state.position[i] - state.position[held]).norm());
    }
  }
  const double farthest = *std::max_element(distance.begin(), distance.end());
  for (std::size_t i = 0; i < distance.size(); ++i) {
    state.velocity[i] = distance[i] / farthest * velocity;
  }
  return state;
}

struct Outcome {
  Alarm alarm;
  int step = 0;
  double energy = 0.0;  ///< over that at the start, at the alarm
};

Outcome watch_packed(const TissueModel& model, const Vec3& velocity, double dt, int steps) {
  State state = sway(model, velocity);
  Guard guard(model, Vec3::Zero(), state);
  const PackedModel packed = pack(model);
  PackedState running(packed, model, state);
  PackedMeasure measure;
  Outcome outcome;
  for (; outcome.step < steps && !outcome.alarm; ++outcome.step) {
    step(packed, Load(), dt, running, &measure);
    unpack(packed, model, running, state);
    outcome.alarm = check(packed, model, state, measure, 0.0, running, guard, 1);
  }
  outcome.energy = guard.last_energy / guard.start_energy;
  return outcome;
}

Outcome watch(const TissueModel& model, const Vec3& velocity, double dt, int steps) {
  State state = sway(model, velocity);
  Guard guard(model, Vec3::Zero(), state);
  Outcome outcome;
  for (; outcome.step < steps && !outcome.alarm; ++outcome.step) {
    step(model, Load(), dt, state);
    outcome.alarm = check(model, Vec3::Zero(), state, 0.0, guard);
  }
  outcome.energy = guard.last_energy / guard.start_energy;
  return outcome;
}

struct Scene {
  std::string name;
  TissueModel model;
  Vec3 velocity;  ///< [m/s] of what sways fastest
};

const Vec3 kAside(0.1, 0.05, -0.05);

std::vector<Scene> make_scenes() {
  return {{"mass-spring organ", scenes::make_spring_organ(2), kAside},
          {"molecular organ", scenes::make_molecular_organ(2), kAside},
          {"sheet", scenes::make_sheet_tissue(), {0.0, 0.0, 0.1}}};
}

}  // namespace

TEST_CASE(
    "below the limit no alarm is raised, above it one before the energy is 1e4 of the first") {
  for (const Scene& scene : make_scenes()) {
    CAPTURE(scene.name);
    const auto& [name, model, velocity] = scene;
    const double limit = 2.0 / find_top_mode(LinearTissue(model)).frequency;
    for (const double part : {0.5, 0.9, 0.98}) {
      CAPTURE(part);
      CHECK(watch(model, velocity, part * limit, kSteps).alarm.kind == AlarmKind::none);
    }
    for (const double part : {1.02, 1.1, 1.5}) {
      CAPTURE(part);
      const Outcome outcome = watch(model, velocity, part * limit, kSteps);
      CAPTURE(outcome.step);
      CAPTURE(static_cast<int>(outcome.alarm.kind));
      CHECK(outcome.alarm);
      CHECK(outcome.energy < 1e4);
    }
  }
}

TEST_CASE("a packed tissue raises the same alarms, at the same speed of growth") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (const Scene& scene : make_scenes()) {
    CAPTURE(scene.name);
    const auto& [name, model, velocity] = scene;
    const double limit = 2.0 / find_top_mode(LinearTissue(model)).frequency;
    for (const double part : {0.5, 0.9, 0.98}) {
      CAPTURE(part);
      CHECK(watch_packed(model, velocity, part * limit, kSteps).alarm.kind == AlarmKind::none);
    }
    for (const double part : {1.02, 1.1, 1.5}) {
      CAPTURE(part);
      const Outcome packed = watch_packed(model, velocity, part * limit, kSteps);
      const Outcome plain = watch(model, velocity, part * limit, kSteps);
      CHECK(packed.alarm);
      CHECK(packed.energy < 1e4);
      CHECK(std::abs(packed.step - plain.step) <= 2);
    }
  }
}

TEST_CASE("what trembles by nothing but its rounding raises no alarm, however long and undamped") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  TissueModel model = scenes::make_spring_organ(2);
  // as stiff for its mass as a hundred thousand particles are
  for (double& stiffness : model.springs.stiffness) stiffness *= 2000.0;
  const double limit = 2.0 / find_top_mode(LinearTissue(model)).frequency;

  const Outcome rest = watch_packed(model, Vec3::Zero(), 0.9 * limit, 20000);
  const Outcome burst = watch_packed(model, Vec3::Zero(), 1.02 * limit, 20000);

  CHECK(rest.alarm.kind == AlarmKind::none);
  CHECK(burst.alarm);
}

TEST_CASE("an oscillator up to half its limit raises no alarm, under any explicit integrator") {
  const TissueModel model = scenes::make_oscillator_model();
  const double w = std::sqrt(1e5);
  for (const Integrator integrator :
       {Integrator::symplectic_euler, Integrator::midpoint, Integrator::runge_kutta_4}) {
    for (const double h : {0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0}) {
      // midpoint gains energy at every step, and in 100 steps up to a tenth of these it may
      if (integrator == Integrator::midpoint && h > 0.2) continue;
      CAPTURE(std::string(integrator_name(integrator)));
      CAPTURE(h);
      State state(model);
      state.position[1].x() += 1e-3;
      Guard guard(model, Vec3::Zero(), state);
      Alarm alarm;
      for (int s = 0; s < 100 && !alarm; ++s) {
        step(model, Load(), h / w, integrator, state);
        alarm = check(model, Vec3::Zero(), state, 0.0, guard);
      }
      CHECK(alarm.kind == AlarmKind::none);
    }
  }
}

TEST_CASE("the slow growth of explicit Euler is noticed") {
  const TissueModel model = scenes::make_oscillator_model();
  State state(model);
  state.position[1].x() += 1e-3;
  Guard guard(model, Vec3::Zero(), state);
  Alarm alarm;
  int steps = 0;
  for (; steps < 400 && !alarm; ++steps) {
    step(model, Load(), 0.1 / std::sqrt(1e5), Integrator::explicit_euler, state);  // 1 % a step
    alarm = check(model, Vec3::Zero(), state, 0.0, guard);
  }

  CHECK(alarm.kind == AlarmKind::energy);
  CHECK(steps > 20);
  CHECK(steps < 80);
}

TEST_CASE("a damped organ that is pressed, held, let go, hung and blown up raises no alarm") {
  for (const bool molecular : {false, true}) {
    CAPTURE(molecular);
    const scenes::Losses losses = {.damping_ratio = 0.2, .drag = 2.0};
    TissueModel model =
        molecular ? scenes::make_molecular_organ(2, losses) : scenes::make_spring_organ(2, losses);
    model.pressure = 20.0;
    model.home.assign(model.mass.size(), 5.0);
    int top = 0;
    for (int i = 0; i < particle_count(model); ++i) {
      if (model.rest_position[i].z() > model.rest_position[top].z()) top = i;
    }
    int touched = 0;
    while (model.triangles[touched][0] != top) ++touched;
    State state(model);
    Load load(1);
    load.gravity = {0, 0, -9.81};
    Guard guard(model, load.gravity, state);
    const double dt = stable_step(model);
    const int steps = static_cast<int>(1.0 / dt);

    Alarm alarm;
    double deepest = 0.0;
    for (int s = 0; s < steps && !alarm; ++s) {
      // up within 0.2 s, held, and gone at once at 0.6 s
      const double press = state.time > 0.6 ? 0.0 : 0.2 * std::min(1.0, state.time / 0.2);
      load.clear();
      load.add({touched, {1, 0, 0}, {0, 0, -press}});
      step(model, load, dt, state);
      const double work = -press * dt * state.velocity[top].z();
      alarm = check(model, load.gravity, state, work, guard);
      deepest = std::max(deepest, model.rest_position[top].z() - state.position[top].z());
    }

    CAPTURE(alarm.value);
    CAPTURE(alarm.time);
    CHECK(alarm.kind == AlarmKind::none);
    CHECK(deepest > 2e-3);
  }
}

TEST_CASE("a coupling stiffer than the step allows is noticed, and one it was chosen for is not") {
  // a spring to a fixed point stands in for a tool that holds one particle
  const double coupling = 2000.0;
  const TissueModel model = scenes::make_spring_organ(1, {.damping_ratio = 0.1});
  TissueModel held = model;
  held.home.assign(model.mass.size(), 0.0);
  held.home[model.mass.size() - 1] = coupling;

  const double without = stable_step(model), with = stable_step(model, coupling);

  REQUIRE(with < without);
  CHECK(watch(held, kAside, with, 2000).alarm.kind == AlarmKind::none);
  const Outcome outcome = watch(held, kAside, without, 2000);
  CHECK(outcome.alarm);
  CHECK(outcome.energy < 1e4);
}

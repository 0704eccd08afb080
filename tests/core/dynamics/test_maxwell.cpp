// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/dynamics/tangent.h"
#include "scenes/scenes.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

constexpr Maxwell kBranch = {.ratio = 0.5, .time = 0.4};

/// A spring of 100 N/m and 10 mm along x between two particles that are held.
TissueModel make_held_spring() {
  TissueModel model;
  model.rest_position = {{0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}};
  model.mass = {1e-3, 1e-3};
  model.fixed = {0, 1};
  model.springs = {{{0, 1}}, {0.01}, {100.0}, {0.0}};
  model.maxwell = kBranch;
  return model;
}

TissueModel make_relaxing_organ(AngleLaw law = AngleLaw::gradient) {
  TissueModel model = scenes::make_molecular_organ(1, {}, law);
  model.maxwell = kBranch;
  return model;
}

Vec3Array compute_forces_of(const TissueModel& model, const State& state) {
  Vec3Array f(model.mass.size());
  compute_forces(model, Load(), state.position, state.velocity, f, state.internal);
  return f;
}

/// Elastic energy of what no longer moves, [J].
double compute_stored(const TissueModel& model, const State& state) {
  return compute_energy(model, Vec3::Zero(), state).elastic();
}

/// A tissue strained at random whose dashpots have gone part of the way.
State strain(const TissueModel& model) {
  State state(model);
  scenes::shake(model, 4e-4, 0.0, state);
  for (int s = 0; s < 40; ++s) step(model, Load(), 1e-4, state);
  scenes::shake(model, 6e-4, 0.05, state);
  return state;
}

}  // namespace

TEST_CASE("the force of a spring held long relaxes from (1 + r) k s to k s as exp(-t/tau)") {
  const TissueModel model = make_held_spring();
  State state(model);
  state.position[1].x() = 0.012;
  CHECK(compute_forces_of(model, state)[0].x() == Approx(0.2 * 1.5).epsilon(1e-12));

  for (int s = 1; s <= 800; ++s) {
    step(model, Load(), 1e-3, state);
    const double expected = 0.2 * (1.0 + 0.5 * std::exp(-1e-3 * s / 0.4));
    REQUIRE(compute_forces_of(model, state)[0].x() == Approx(expected).epsilon(1e-11));
  }
}

TEST_CASE("the curve of a held spring is the same for every step and every integrator") {
  const TissueModel model = make_held_spring();
  for (const Integrator integrator : {Integrator::explicit_euler, Integrator::midpoint,
                                      Integrator::runge_kutta_4, Integrator::implicit_euler}) {
    for (const double dt : {1e-4, 0.05, 0.8}) {
      State state(model);
      state.position[1].x() = 0.008;
      ImplicitStepper implicit(model, Integrator::implicit_euler);
      for (int s = 0; s * dt < 0.79; ++s) {
        if (integrator == Integrator::implicit_euler) {
          implicit.step(Load(), dt, state);
        } else {
          step(model, Load(), dt, integrator, state);
        }
      }
      const double expected = -0.2 * (1.0 + 0.5 * std::exp(-state.time / 0.4));
      CHECK(compute_forces_of(model, state)[0].x() == Approx(expected).epsilon(1e-10));
    }
  }
}

TEST_CASE("a spring pulled at a steady rate has the branch of a ramp within dt/(2 tau) of it") {
  const TissueModel model = make_held_spring();
  const double rate = 2e-3;  // [m/s]
  for (const double dt : {1e-3, 1e-2}) {
    State state(model);
    for (int s = 1; s <= static_cast<int>(0.5 / dt); ++s) {
      state.position[1].x() = 0.01 + rate * dt * s;
      step(model, Load(), dt, state);
    }
    const double branch = 0.5 * 100.0 * rate * 0.4 * (1.0 - std::exp(-0.5 / 0.4));
    const double found = compute_forces_of(model, state)[0].x() - 100.0 * rate * 0.5;
    CHECK(std::abs(found - branch) < 1.05 * dt / (2.0 * 0.4) * branch);
    CHECK(std::abs(found - branch) > 0.5 * dt / (2.0 * 0.4) * branch);
  }
}

TEST_CASE("forces of a relaxing tissue are minus the gradient of its energy") {
  const TissueModel model = make_relaxing_organ();
  State state = strain(model);
  for (Vec3& v : state.velocity) v.setZero();
  const Vec3Array f = compute_forces_of(model, state);
  constexpr double kOffset = 1e-7;
  const double largest = scenes::max_norm(f);
  for (std::size_t i = 0; i < f.size(); i += 5) {
    for (int axis = 0; axis < 3; ++axis) {
      State ahead = state, behind = state;
      ahead.position[i][axis] += kOffset;
      behind.position[i][axis] -= kOffset;
      const double slope =
          (compute_stored(model, ahead) - compute_stored(model, behind)) / (2.0 * kOffset);
      CHECK(f[i][axis] == Approx(-slope).epsilon(1e-5).scale(largest));
    }
  }
}

TEST_CASE("branches keep momentum and angular momentum, and turn with the body") {
  for (const AngleLaw law : {AngleLaw::gradient, AngleLaw::eq10}) {
    TissueModel model = make_relaxing_organ(law);
    model.home.clear();
    model.drag = 0.0;
    State state = strain(model);
    for (Vec3& v : state.velocity) v.setZero();
    const Vec3Array f = compute_forces_of(model, state);
    const double largest = scenes::max_norm(f);
    CHECK(scenes::sum(f).norm() < 1e-11 * largest * f.size());
    CHECK(scenes::compute_torque(state.position, f).norm() < 1e-11 * largest * f.size());

    const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()).matrix();
    for (Vec3& x : state.position) x = (turn * x).eval();
    const Vec3Array turned = compute_forces_of(model, state);
    for (std::size_t i = 0; i < f.size(); ++i) CHECK((turned[i] - turn * f[i]).norm() < 1e-10);
  }
}

TEST_CASE("what is held still loses the energy of its branches, and no other") {
  TissueModel model = make_relaxing_organ();
  for (int i = 0; i < particle_count(model); ++i) model.fixed.push_back(i);
  std::sort(model.fixed.begin(), model.fixed.end());
  model.fixed.erase(std::unique(model.fixed.begin(), model.fixed.end()), model.fixed.end());
  TissueModel elastic = model;
  elastic.maxwell = {};
  State state = strain(model);
  State bare(elastic);
  bare.position = state.position;
  const double left = compute_stored(elastic, bare);

  double before = compute_stored(model, state);
  CHECK(before > 1.05 * left);
  for (int s = 0; s < 100; ++s) {
    step(model, Load(), 0.05, state);
    const double now = compute_stored(model, state);
    REQUIRE(now <= before);
    before = now;
  }
  CHECK(before == Approx(left).epsilon(1e-8));
}

TEST_CASE("a relaxing tissue comes to rest where it would without branches") {
  TissueModel model = scenes::make_spring_organ(1, {.damping_ratio = 0.5, .drag = 20.0});
  TissueModel relaxing = model;
  relaxing.maxwell = {.ratio = 1.0, .time = 0.02};
  Load load(1);
  load.gravity = Vec3(0.0, 0.0, -9.81);
  const double dt = 0.5 * stable_step(relaxing);
  State with(relaxing), without(model);
  for (int s = 0; s * dt < 1.5; ++s) {
    step(relaxing, load, dt, with);
    step(model, load, dt, without);
  }
  const double sunk = scenes::max_difference(without.position, model.rest_position);
  CHECK(sunk > 1e-5);
  CHECK(scenes::max_difference(with.position, without.position) < 1e-3 * sunk);
}

TEST_CASE("the tangent of a relaxing tissue is that of one strained at once") {
  const TissueModel model = make_relaxing_organ();
  State state(model);
  scenes::shake(model, 3e-4, 0.0, state);
  const Eigen::SparseMatrix<double> k = compute_stiffness(model, state.position, Projection::none);
  constexpr double kOffset = 1e-7;
  Vec3Array ahead_f(model.mass.size()), behind_f(model.mass.size());
  for (const int i : {3, 17, 30}) {
    Vec3Array ahead = state.position, behind = state.position;
    ahead[i].y() += kOffset;
    behind[i].y() -= kOffset;
    compute_forces(model, Load(), ahead, state.velocity, ahead_f);
    compute_forces(model, Load(), behind, state.velocity, behind_f);
    for (const int j : {3, 17, 30}) {
      for (int axis = 0; axis < 3; ++axis) {
        const double slope = (ahead_f[j][axis] - behind_f[j][axis]) / (2.0 * kOffset);
        CHECK(k.coeff(3 * j + axis, 3 * i + 1) == Approx(-slope).epsilon(1e-5).scale(10.0));
      }
    }
  }
}

TEST_CASE(
    "a relaxing tissue is stable at 0.95 of its exact limit, which is sqrt(1 + r) times less, "
    "and not at 1.05") {
  TissueModel model = scenes::make_spring_organ(1);
  model.home.assign(model.mass.size(), 0.0);
  const double alone = estimate_spectrum(model).stiffness;
  model.maxwell = {.ratio = 3.0, .time = 1e4};
  const double k = estimate_spectrum(model).stiffness;
  CHECK(k == Approx(4.0 * alone).epsilon(2e-3));

  const double limit = 2.0 / std::sqrt(k);
  const auto run = [&](double dt, int steps) {
    State state(model);
    scenes::shake(model, 1e-7, 0.0, state);
    for (int s = 0; s < steps; ++s) step(model, Load(), dt, state);
    return scenes::max_difference(state.position, model.rest_position);
  };
  CHECK(run(0.95 * limit, 3000) < 1e-5);
  CHECK(run(1.05 * limit, 200) > 1e-4);
}

TEST_CASE("a tissue has an internal variable for each link and six for each triangle, or none") {
  CHECK(count_internal(scenes::make_molecular_organ(1)) == 0);
  const TissueModel model = make_relaxing_organ();
  CHECK(State(model).internal.size() ==
        model.springs.ends.size() + model.bonds.ends.size() + 6 * model.angles.corners.size());
}

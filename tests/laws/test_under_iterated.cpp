// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "palpate/sim/dynamics/step.h"
#include "scenes/tissues.h"

// What XPBD and projective dynamics do wrong with too few iterations [laws: xpbd], [laws:
// projective].

using namespace palpate;
using doctest::Approx;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int kLinks = 10;
constexpr double kMass = 1e-3, kStiffness = 100.0, kGravity = 9.81, kDrag = 50.0;

/// A chain of springs along x, hung up at its first particle.
TissueModel make_hanging_chain() {
  TissueModel model = scenes::make_chain_model(kLinks + 1, kMass, kStiffness, 0.0);
  model.drag = kDrag;
  return model;
}

double measure_sag(int sweeps, double dt) {
  const TissueModel model = make_hanging_chain();
  State state(model);
  Load load;
  load.gravity = {kGravity, 0, 0};
  ImplicitStepper stepper(model, Integrator::xpbd, sweeps);
  for (double end = 30.0; state.time < end;) stepper.step(load, dt, state);
  return state.position[kLinks].x() - model.rest_position[kLinks].x();
}

/// The same from the sweeps' matrix: of A lambda = -C with A = J W Jᵀ + 1/(k dt²) they go from 0 to
/// (1 - B^j) of the solution, B = 1 - L⁻¹A with L the lower half of A. What hangs still is where
/// that balances the step of gravity, W Jᵀ lambda = -dt² g.
double predict_sag(int sweeps, double dt) {
  const double mass = (1.0 + dt * kDrag) * kMass, gravity = kGravity / (1.0 + dt * kDrag);
  MatrixXd j = MatrixXd::Identity(kLinks, kLinks);
  for (int l = 1; l < kLinks; ++l) j(l, l - 1) = -1.0;
  const MatrixXd one = MatrixXd::Identity(kLinks, kLinks);
  const MatrixXd a = j * j.transpose() / mass + one / (kStiffness * dt * dt);
  const MatrixXd lower = a.triangularView<Eigen::Lower>();
  const MatrixXd sweep = one - lower.inverse() * a;
  MatrixXd left = one;
  for (int s = 0; s < sweeps; ++s) left = left * sweep;
  const VectorXd fall = VectorXd::Constant(kLinks, dt * dt * gravity);
  const VectorXd pull = -(j.transpose().inverse() * (mass * fall));
  const VectorXd elongation = -a * ((one - left).inverse() * pull) - j * fall;
  return elongation.sum();
}

double measure_energy(const TissueModel& model, const State& state) {
  return compute_energy(model, Vec3::Zero(), state).total();
}

/// The most energy that an organ of springs has within 40 steps, over what it begins with.
double measure_growth(Integrator integrator, int iterations, double longer) {
  const TissueModel model = scenes::make_spring_organ(2);
  State state(model);
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    state.velocity[i].x() = 2.0 * (model.rest_position[i].z() + 0.03);
  }
  for (const int i : model.fixed) state.velocity[static_cast<std::size_t>(i)].setZero();
  const double start = measure_energy(model, state), dt = longer * stable_step(model);
  double most = 0.0;
  ImplicitStepper stepper(model, integrator, iterations);
  for (int s = 0; s < 40; ++s) {
    stepper.step(Load(), dt, state);
    most = std::max(most, measure_energy(model, state));
  }
  return most / start;
}

}  // namespace

TEST_CASE("XPBD of few sweeps is too soft, by as much as the sweeps leave over") {
  const double exact = kMass * kGravity * kLinks * (kLinks + 1) / (2.0 * kStiffness);
  for (const double dt : {1e-3, 3e-3, 1e-2}) {
    for (const int sweeps : {1, 5, 20}) {
      CAPTURE(dt);
      CAPTURE(sweeps);
      CHECK(measure_sag(sweeps, dt) == Approx(predict_sag(sweeps, dt)).epsilon(1e-4));
    }
  }
  CHECK(measure_sag(1, 1e-3) > 1.05 * exact);
  CHECK(measure_sag(1, 1e-2) > 5.0 * exact);
  CHECK(measure_sag(1, 1e-4) == Approx(exact).epsilon(2e-3));
  CHECK(measure_sag(400, 1e-2) == Approx(exact).epsilon(1e-3));
}

TEST_CASE("projective dynamics hangs right after one iteration a step") {
  const TissueModel model = make_hanging_chain();
  State state(model);
  Load load;
  load.gravity = {kGravity, 0, 0};
  ImplicitStepper stepper(model, Integrator::projective_dynamics, 1);
  for (int s = 0; s < 3000; ++s) stepper.step(load, 1e-2, state);
  CHECK(state.position[kLinks].x() - model.rest_position[kLinks].x() ==
        Approx(kMass * kGravity * kLinks * (kLinks + 1) / (2.0 * kStiffness)).epsilon(1e-6));
}

// A pendulum swings across its spring: of what A has there, 1 + a with a = k dt²/m, its own is
// 1 + b with b = dt² g/l. An iteration leaves 1 - (1 + b)/(1 + a) of the way to implicit Euler's
// step (y + dt v)/(1 + b), so that j of them go the part p = 1 - (...)^j.
TEST_CASE("projective dynamics of few iterations is too slow, by the rate of its iteration") {
  const double dt = 4e-3;
  const TissueModel model = scenes::make_oscillator_model(kMass, kStiffness);
  const double length = 0.01 + kMass * kGravity / kStiffness;
  const double a = dt * dt * kStiffness / kMass, b = dt * dt * kGravity / length;
  Load load;
  load.gravity = {kGravity, 0, 0};
  for (const int iterations : {1, 2, 5}) {
    CAPTURE(iterations);
    const double part = 1.0 - std::pow(1.0 - (1.0 + b) / (1.0 + a), iterations);
    State state(model);
    state.position[1] = {length, 1e-7, 0.0};
    ImplicitStepper stepper(model, Integrator::projective_dynamics, iterations);
    double y = 1e-7, v = 0.0;
    for (int s = 0; s < 30; ++s) {
      stepper.step(load, dt, state);
      const double next = (1.0 - part) * y + part * (y + dt * v) / (1.0 + b);
      v = (next - y) / dt;
      y = next;
      CHECK(state.position[1].y() == Approx(y).epsilon(1e-3));
    }
  }
}

TEST_CASE("projective dynamics of springs gains no energy however few iterations there are") {
  for (const int iterations : {1, 2, 5}) {
    for (const double longer : {1.0, 4.0, 16.0}) {
      CHECK(measure_growth(Integrator::projective_dynamics, iterations, longer) <= 1.0);
    }
  }
}

TEST_CASE("XPBD of few sweeps has energy from nowhere, since it swings as something softer") {
  CHECK(measure_growth(Integrator::xpbd, 1, 16.0) > 1.5);
  CHECK(measure_growth(Integrator::xpbd, 200, 16.0) <= 1.0);
}

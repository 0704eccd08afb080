// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "laws/linear_tissue.h"
#include "palpate/sim/dynamics/private/step_limit.h"
#include "palpate/sim/dynamics/state.h"
#include "scenes/hyperelastic_solids.h"

// Symplectic Euler with implicit damping: a mode's step has the characteristic polynomial
// (1 + 2 zeta h) m² - (2 + 2 zeta h - h²) m + 1, h = w dt [motion: step].

using namespace palpate;
using namespace palpate::laws;
using doctest::Approx;

namespace {

constexpr Integrator kDamped = Integrator::symplectic_euler_implicit_damping;
constexpr double kMass = 1e-3, kStiffness = 100.0;

/// The farthest that an oscillator of damping ratio z gets within so many steps of h/w, over 1e-5 m
/// at which it is let go.
double find_farthest(double z, double h, int steps) {
  const double w = std::sqrt(kStiffness / kMass);
  const TissueModel model =
      scenes::make_oscillator_model(kMass, kStiffness, 2.0 * z * std::sqrt(kStiffness * kMass));
  State state(model);
  state.position[1].x() += 1e-5;
  double farthest = 0.0;
  for (int s = 0; s < steps && farthest <= 1e-2; ++s) {
    step(model, Load(), h / w, kDamped, state);
    farthest = std::max(farthest, std::abs(state.position[1].x() - model.rest_position[1].x()));
  }
  return farthest / 1e-5;
}

}  // namespace

TEST_CASE("implicit damping lengthens the stable step to 2/w (sqrt(1 + z²) + z)") {
  for (const double z : {0.0, 0.05, 0.3, 0.86, 2.0, 5.0}) {
    CAPTURE(z);
    const double limit = 2.0 * (std::sqrt(1.0 + z * z) + z);

    CHECK(find_farthest(z, 0.98 * limit, 2000) <= 10.0);
    CHECK(find_farthest(z, 1.02 * limit, 2000) > 1e3);

    const TissueModel model =
        scenes::make_oscillator_model(kMass, kStiffness, 2.0 * z * std::sqrt(kStiffness * kMass));
    const double w = std::sqrt(kStiffness / kMass);
    CHECK(w * find_damped_limit(model) == Approx(limit).epsilon(1e-3));
    CHECK(w * stable_step(model, kDamped) == Approx(kLimitShare * limit).epsilon(1e-3));
  }
}

TEST_CASE("a mode loses ln(1 + 2 z h)/2 of its amplitude in a step of implicit damping") {
  const double z = 0.1, h = 0.5, w = std::sqrt(kStiffness / kMass);
  const TissueModel model =
      scenes::make_oscillator_model(kMass, kStiffness, 2.0 * z * std::sqrt(kStiffness * kMass));
  State state(model);
  state.position[1].x() += 1e-5;
  // the product of the roots of x'' - ... is 1/(1 + 2 z h): what two steps make a determinant of
  const auto advance = [&] {
    step(model, Load(), h / w, kDamped, state);
    return state.position[1].x() - model.rest_position[1].x();
  };
  double x0 = 1e-5, x1 = advance(), x2 = advance();
  for (int s = 0; s < 20; ++s) {
    const double x3 = advance(), before = x0 * x2 - x1 * x1, after = x1 * x3 - x2 * x2;
    CHECK(after / before == Approx(1.0 / (1.0 + 2.0 * z * h)).epsilon(1e-6));
    x0 = x1, x1 = x2, x2 = x3;
  }
}

TEST_CASE(
    "on a mesh the limit is where 4 - dt² K + 2 dt C turns indefinite, and never before 2/w") {
  std::vector<TissueModel> tissues;
  tissues.push_back(scenes::make_chain_model(8, 1e-3, 100.0, 0.1));
  tissues.back().springs.damping[2] = 4.0;
  tissues.push_back(scenes::make_spring_organ(0, {.damping_ratio = 0.2}));
  tissues.push_back(scenes::make_molecular_organ(0, {.drag = 300.0}));
  tissues.push_back(scenes::make_finite_organ(scenes::kFiniteLaws[0], 2, 0.9,
                                              {.damping_ratio = 0.4, .drag = 20.0}));
  for (const TissueModel& model : tissues) {
    const LinearTissue tissue(model);
    const double undamped = 2.0 / find_top_mode(tissue).frequency;
    const double exact = find_limit(tissue, kDamped, 1000.0 * undamped);
    const Spectrum spectrum = estimate_spectrum(model);

    CHECK(find_damped_limit(model) == Approx(exact).epsilon(0.01));
    CHECK(exact >= 0.999 * undamped);
    CHECK(stable_step(model, kDamped) <= exact);
    CHECK(stable_step(model, kDamped) >= 0.85 * exact);
    // that by the least damping time is enough as well
    const double t = estimate_least_damping_time(model);
    CHECK(find_step_limit(kDamped, spectrum, t) <= 1.01 * exact);
    CHECK(find_step_limit(kDamped, spectrum, t) >= 0.99 * undamped);
  }
}

TEST_CASE("undamped it is symplectic Euler, to rounding") {
  const TissueModel model = scenes::make_molecular_organ(1);
  State one(model), other(model);
  scenes::shake(model, 1e-3, 0.1, one);
  other = one;
  for (int s = 0; s < 100; ++s) {
    step(model, Load(), 1e-4, one);
    step(model, Load(), 1e-4, kDamped, other);
  }
  CHECK(scenes::max_difference(one.position, other.position) < 1e-14);
}

TEST_CASE("dampers as strong as ten thousand steps are solved for: a pair moves as one") {
  // two particles thrown at each other's damper, c dt/m = 1e4: left is the mean velocity
  TissueModel model = scenes::make_chain_model(3, 1e-3, 1.0, 0.0);
  model.springs.damping.back() = 1e4;
  State state(model);
  state.velocity[2].x() = 1.0;
  step(model, Load(), 1e-3, kDamped, state);
  CHECK(state.velocity[2].x() == Approx(0.5).epsilon(1e-3));
  CHECK(state.velocity[1].x() == Approx(0.5).epsilon(1e-3));
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/dynamics/private/step_limit.h"
#include "palpate/sim/dynamics/step.h"
#include "scenes/hyperelastic_solids.h"

// Corotated and neo-Hookean solids in motion, as users have them.

using namespace palpate;
using doctest::Approx;
using scenes::FiniteLaw;
using scenes::kFiniteLaws;

namespace {

/// How many times as far from rest as at first anything comes in 2000 steps.
double find_growth(const TissueModel& model, double dt) {
  constexpr double kOffset = 1e-8, kEnough = 1e4;
  State state(model);
  scenes::shake(model, kOffset, 0.0, state);
  double most = 0.0;
  for (int s = 0; s < 2000 && most < kEnough; ++s) {
    step(model, Load(), dt, state);
    most = std::max(most, scenes::max_difference(state.position, model.rest_position) / kOffset);
  }
  return most;
}

}  // namespace

TEST_CASE("a solid at finite strain is stable at 0.95 of the step foretold and not at 1.05") {
  for (const FiniteLaw& law : kFiniteLaws) {
    for (const double damping : {0.0, 0.2, 1.0}) {
      CAPTURE(std::string(law.name));
      CAPTURE(damping);
      const TissueModel model = scenes::make_finite_organ(law, 3, 0.9, {.damping_ratio = damping});
      const double foretold = stable_step(model) / kLimitShare;

      CHECK(find_growth(model, 0.95 * foretold) < 30.0);
      CHECK(find_growth(model, 1.05 * foretold) > 1000.0);
    }
  }
}

TEST_CASE("a bar under its weight is E times its strain, by either law") {
  // hung by its top a bar of length L and density rho is longer by rho g L²/(2 E); a bar of nu =
  // 0.3 so soft that this is 2 % is linear to about as much
  const double length = 0.1, side = 0.02, g = 9.81;
  const SolidMesh bar = scenes::make_block({side, side, length}, {2, 2, 10});
  Material material;
  material.poisson_ratio = 0.3;
  material.density = 1000.0;
  material.young_modulus = material.density * g * length / (2.0 * 0.02);
  material.damping_ratio = 0.5;
  SolidOptions options;
  options.drag = 20.0;
  options.nodal_share = 0.5;
  for (std::size_t i = 0; i < bar.vertices.size(); ++i) {
    if (bar.vertices[i].z() > 0.499 * length) options.fixed.push_back(static_cast<int>(i));
  }
  Load load;
  load.gravity = {0, 0, -g};
  for (const FiniteLaw& law : kFiniteLaws) {
    CAPTURE(std::string(law.name));
    const TissueModel model = law.build(bar, material, options);
    State state(model);
    const double dt = stable_step(model);
    for (int s = 0; s * dt < 1.5; ++s) step(model, load, dt, state);

    double sag = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < bar.vertices.size(); ++i) {
      if (bar.vertices[i].z() > -0.499 * length) continue;
      sag += model.rest_position[i].z() - state.position[i].z();
      ++count;
    }
    CHECK(sag / count == Approx(0.02 * length).epsilon(0.06));
  }
}

TEST_CASE("a thrown solid that spins keeps its energy and its angular momentum") {
  for (const FiniteLaw& law : kFiniteLaws) {
    CAPTURE(std::string(law.name));
    TissueModel model = scenes::make_finite_organ(law, 2, 0.9);
    model.fixed.clear();
    State state(model);
    for (std::size_t i = 0; i < model.mass.size(); ++i) {
      state.velocity[i] = Vec3(0, 10, 30).cross(state.position[i]);
    }
    const auto measure_spin = [&] {
      Vec3 spin = Vec3::Zero();
      for (std::size_t i = 0; i < model.mass.size(); ++i) {
        spin += model.mass[i] * state.position[i].cross(state.velocity[i]);
      }
      return spin;
    };
    const Vec3 spin = measure_spin();
    const double energy = compute_energy(model, Vec3::Zero(), state).total();
    const double dt = 0.1 * stable_step(model);

    for (int s = 0; s < 5000; ++s) step(model, Load(), dt, state);

    CHECK((measure_spin() - spin).norm() < 1e-9 * spin.norm());
    CHECK(compute_energy(model, Vec3::Zero(), state).total() == Approx(energy).epsilon(0.01));
  }
}

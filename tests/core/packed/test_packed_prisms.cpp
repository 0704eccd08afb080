// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/simd_targets.h"
#include "scenes/shells.h"
#include "skip.h"

using namespace palpate;
using doctest::Approx;

namespace {

State shake(const TissueModel& model, double size, double speed) {
  State state(model);
  scenes::shake(model, size, speed, state);
  return state;
}

State run_packed(const PackedModel& packed, const TissueModel& model, const State& start, double dt,
                 int steps) {
  PackedState running(packed, model, start);
  for (int s = 0; s < steps; ++s) step(packed, Load(), dt, running);
  State after(model);
  unpack(packed, model, running, after);
  return after;
}

}  // namespace

TEST_CASE("a packed step of a shell measures the elastic energy that the reference computes") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (const TissueModel& model : {scenes::make_shell_organ(2, {.damping_ratio = 0.2}),
                                   scenes::make_shell_organ(1), scenes::make_damped_prism()}) {
    const State state = shake(model, 3e-4, 0.05);
    const Energy expected = compute_energy(model, Vec3::Zero(), state);
    REQUIRE(expected.prisms > 0.02 * expected.elastic());
    for (const std::string& target : simd_targets()) {
      CAPTURE(target);
      const PackedModel packed = pack(model, target);
      PackedState running(packed, model, state);
      PackedMeasure measure;
      step(packed, Load(), 1e-9, running, &measure);

      CHECK(measure.elastic == Approx(expected.elastic()).epsilon(1e-5));
      CHECK(measure.kinetic == Approx(expected.kinetic).epsilon(1e-5));
    }
  }
}

TEST_CASE("a packed shell is stable at 0.95 of the exact limit and not at 1.05") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  const TissueModel model = scenes::make_shell_organ(1);
  const double limit = 2.0 / std::sqrt(estimate_spectrum(model).stiffness);
  const State start = shake(model, 1e-7, 0.0);
  const auto run = [&](double dt, int steps) {
    return scenes::max_difference(run_packed(pack(model), model, start, dt, steps).position,
                                  model.rest_position);
  };

  CHECK(run(0.95 * limit, 2000) < 1e-5);
  CHECK(run(1.05 * limit, 100) > 1e-4);
}

TEST_CASE("a packed prism tells a shear of a thousandth of its height to four digits") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  // the difference of its diagonals is a two-thousandth of their lengths
  TissueModel model = scenes::make_damped_prism();
  model.home.clear();
  State state(model);
  for (std::size_t i = 3; i < 6; ++i) state.position[i].x() += 4e-6;
  Vec3Array expected(6, Vec3::Zero());
  accumulate_prism_forces(model.prisms, state.position, state.velocity, expected);
  for (const std::string& target : simd_targets()) {
    CAPTURE(target);
    const PackedModel packed = pack(model, target);

    const State after = run_packed(packed, model, state, 1.0, 1);

    for (std::size_t i = 0; i < 6; ++i) {
      const Vec3 force = model.mass[i] * after.velocity[i];
      CHECK((force - expected[i]).norm() < 1e-4 * scenes::max_norm(expected));
    }
  }
}

TEST_CASE("a diagonal of no length pulls nowhere when packed, as in the reference") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  const TissueModel model = scenes::make_damped_prism();
  State state(model);
  state.position[5] = state.position[1];
  state.velocity[5] = Vec3(0.1, 0.0, 0.0);
  Vec3Array expected(6);
  compute_forces(model, Load(), state.position, state.velocity, expected);

  const State after = run_packed(pack(model), model, state, 1.0, 1);

  for (std::size_t i = 0; i < 6; ++i) {
    const Vec3 force = model.mass[i] * (after.velocity[i] - state.velocity[i]);
    CHECK((force - expected[i]).norm() < 1e-5 * scenes::max_norm(expected));
  }
}

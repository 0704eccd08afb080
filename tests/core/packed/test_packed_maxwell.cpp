// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/simd_targets.h"
#include "scenes/shells.h"
#include "skip.h"

using namespace palpate;
using doctest::Approx;

namespace {

std::vector<TissueModel> make_relaxing_tissues() {
  std::vector<TissueModel> tissues = {
      scenes::make_spring_organ(1, {.damping_ratio = 0.1}),
      scenes::make_molecular_organ(1, {.damping_ratio = 0.1}),
      scenes::make_molecular_organ(1, {.damping_ratio = 0.1}, AngleLaw::eq10),
      scenes::make_shell_organ(1, {.damping_ratio = 0.1}), scenes::make_sheet_tissue()};
  for (TissueModel& tissue : tissues) tissue.maxwell = {.ratio = 0.7, .time = 0.02};
  return tissues;
}

}  // namespace

TEST_CASE("packed branches move a tissue as those of the reference do") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (const TissueModel& model : make_relaxing_tissues()) {
    TissueModel elastic = model;
    elastic.maxwell = {};
    const double dt = 0.5 * stable_step(model);
    const int steps = static_cast<int>(0.01 / dt);
    State start(model), bare(elastic);
    scenes::shake(model, 3e-4, 0.0, start);
    bare.position = start.position;
    bare.velocity = start.velocity;
    State expected = start;
    for (int s = 0; s < steps; ++s) step(model, Load(), dt, expected);
    for (int s = 0; s < steps; ++s) step(elastic, Load(), dt, bare);
    const double effect = scenes::max_difference(expected.position, bare.position);
    for (const std::string& target : simd_targets()) {
      CAPTURE(target);
      const PackedModel packed = pack(model, target);
      PackedState running(packed, model, start);
      for (int s = 0; s < steps; ++s) step(packed, Load(), dt, running);
      State after(model);
      unpack(packed, model, running, after);
      CHECK(scenes::max_difference(after.position, expected.position) < 1e-3 * effect);
    }
  }
}

TEST_CASE("a packed step measures the energy of branches that the reference computes") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (const TissueModel& model : make_relaxing_tissues()) {
    const double dt = 0.5 * stable_step(model);
    State state(model);
    scenes::shake(model, 3e-4, 0.0, state);
    for (const std::string& target : simd_targets()) {
      CAPTURE(target);
      const PackedModel packed = pack(model, target);
      PackedState running(packed, model, state);
      State reference = state;
      for (int s = 0; s < 100; ++s) step(packed, Load(), dt, running);
      for (int s = 0; s < 100; ++s) step(model, Load(), dt, reference);
      PackedMeasure measure;
      step(packed, Load(), 1e-9, running, &measure);

      const double expected = compute_energy(model, Vec3::Zero(), reference).elastic();
      CHECK(measure.elastic == Approx(expected).epsilon(2e-3));
    }
  }
}

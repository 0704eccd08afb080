// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "calls.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/simd_targets.h"
#include "scenes/tissues.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

TEST_CASE("no explicit step and no check for alarms allocates") {
  TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.2, .drag = 1.0});
  model.home.assign(model.mass.size(), 1.0);
  model.pressure = 100.0;
  State state(model);
  Guard guard(model, Vec3::Zero(), state);
  Load load(4);
  int alarms = 0;

  const Calls before = count_calls_of_this_thread();
  for (int s = 0; s < 200; ++s) {
    load.clear();
    load.add({s % 7, {0.2, 0.3, 0.5}, {0, 0, -0.01}});
    for (const Integrator integrator :
         {Integrator::explicit_euler, Integrator::symplectic_euler, Integrator::midpoint,
          Integrator::runge_kutta_4, Integrator::symplectic_euler_implicit_damping}) {
      step(model, load, 1e-5, integrator, state);
    }
    step(model, load, 1e-5, state);
    alarms += static_cast<bool>(check(model, Vec3::Zero(), state, 1e-3, guard));
  }
  const Calls after = count_calls_of_this_thread();

  CHECK(after.allocations == before.allocations);
  CHECK(alarms == 0);
}

TEST_CASE("no packed step allocates") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.2, .drag = 1.0});
  model.pressure = 100.0;
  const PackedModel packed = pack(model);
  State state(model);
  PackedState running(packed, model, state);
  Load load(4);

  const Calls before = count_calls_of_this_thread();
  for (int s = 0; s < 200; ++s) {
    load.clear();
    load.add({s % 7, {0.2, 0.3, 0.5}, {0, 0, -0.01}});
    step(packed, load, 1e-5, running);
  }
  unpack(packed, model, running, state);
  const Calls after = count_calls_of_this_thread();

  CHECK(after.allocations == before.allocations);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "core/loop/puppet.h"
#include "palpate/sim/loop/loop.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// A press that goes down while the force still fades in, and up under all of it: the hand gets
/// back more than it gave, as from a contact that makes energy.
Puppet make_active_press() { return make_puppet(0.006, 0.8); }

const LoopOptions kWatchful = {.duration = 0.8, .safety = {.ramp_time = 0.6, .energy_max = 1e-5}};

}  // namespace

TEST_CASE("what the passivity controller does is counted, recorded and shown") {
  const Scene scene = press_scene();
  Puppet puppet = make_active_press();
  TickLog log;
  Loop loop(scene, puppet, kWatchful, &log);

  run(loop);

  const LoopReport report = loop.report();
  const Taken taken(log);
  CHECK(report.damped_ticks > 10);
  CHECK(report.interventions >= 1);
  CHECK(report.interventions <= report.damped_ticks / 2);
  CHECK(report.devices[0].damped_ticks == report.damped_ticks);
  CHECK(report.devices[0].interventions == report.interventions);
  CHECK(taken.count(EventKind::passivity) == report.interventions);
  for (const Event& event : taken.events) {
    if (event.kind == EventKind::passivity) CHECK(event.value > kWatchful.safety.energy_max);
  }
  REQUIRE(loop.take_snapshot());
  CHECK(loop.snapshot().instruments[0].interventions == report.interventions);
}

TEST_CASE("a press that gives back no more than it took is not damped") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet(0.006, 0.8);
  TickLog log;
  Loop loop(scene, puppet, {.duration = 0.8}, &log);

  run(loop);

  CHECK(loop.report().damped_ticks == 0);
  CHECK(loop.report().interventions == 0);
  CHECK(Taken(log).count(EventKind::passivity) == 0);
}

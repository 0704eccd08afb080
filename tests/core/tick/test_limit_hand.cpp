// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "core/tick/press_scene.h"
#include "palpate/sim/tick/private/device_coupling.h"
#include "palpate/sim/tick/private/world_internals.h"

using namespace palpate;
using doctest::Approx;

namespace {

constexpr double kDt = 1e-3;

/// [-] What is left of the force that a hand pushes with after a tick in which the smallest volume
/// of the body has gone from `before` to `now` of that at rest.
double limit(double before, double now) {
  Scene scene = palpate::testing::press_scene();
  scene.instruments[0].coupling.force_max = 0.5;  // of which a fiftieth is always left
  World world(scene);
  ScriptedDevice device = palpate::testing::press_script(2e-3, 0.4);
  for (int k = 0; k < 180; ++k) tick(scene, device.read(k * kDt), kDt, world);
  const double force = world.instruments[0].last_force.norm();
  REQUIRE(force > 0.0);
  world.bodies[0].stretch.smallest_volume = now;
  internals(world.bodies[0]).volume_before = before;
  limit_hand(scene, 0, kDt, world);
  return workspace(world).hands[0].bearable / force;
}

}  // namespace

TEST_CASE("a hand is limited the faster the less is left of a volume that it strains") {
  CHECK(std::isinf(limit(0.2, 0.2)));
  // half of the reserve is left, of which F falls by 100/s, and what shrinks is foretold
  CHECK(limit(0.075, 0.075) == Approx(0.95));
  CHECK(limit(0.145, 0.14) == Approx(1.0 - 0.1 * (1.0 - 0.13 / 0.15)));
  // it would be at 0.05 within five ticks
  CHECK(limit(0.15, 0.12) == Approx(0.7));
}

TEST_CASE("a hand that keeps a volume collapsed is limited as fast as one that collapses it") {
  // the run ends after ten such ticks: of 0.9 a tick a third would still be there
  for (const double before : {-0.3, -0.2, 0.0}) CHECK(limit(before, -0.2) == Approx(0.7));
  CHECK(limit(0.04, 0.045) == Approx(0.7));
}

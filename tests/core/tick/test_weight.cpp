// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/tick/placed_bodies.h"
#include "palpate/sim/packed/simd_targets.h"
#include "scenes/linear_solids.h"
#include "scenes/scenes.h"

using namespace palpate;
using namespace palpate::testing;

TEST_CASE("a weightless body moves under gravity as it does without, and the one beside it sags") {
  for (const Kernel kernel : {Kernel::packed, Kernel::reference}) {
    if (kernel == Kernel::packed && simd_targets().empty()) continue;
    CAPTURE(static_cast<int>(kernel));
    Scene scene;
    scene.bodies = {make_body(), make_body(kAside)};
    for (SoftBody& body : scene.bodies) body.kernel = kernel;
    scene.bodies[0].weightless = true;
    const Scene light = build_scene(scene);
    scene.gravity = {0.0, 0.0, -9.81};
    const Scene heavy = build_scene(std::move(scene));
    World with(heavy), without(light);
    ScriptedDevice hand = press_script(3e-3, 0.4);

    for (int i = 0; i < 200; ++i) {
      const HapticSample sample = read_at(hand, i);
      tick(heavy, sample, kDt, with);
      tick(light, sample, kDt, without);
      REQUIRE_FALSE(with.alarm);
    }

    CHECK(with.instruments[0].last_force.norm() > 0.0);
    CHECK(with.bodies[0].tissue.position == without.bodies[0].tissue.position);
    CHECK(with.bodies[0].guard.work == without.bodies[0].guard.work);
    const auto sagged = [&](const World& world) {
      return scenes::max_difference(world.bodies[1].tissue.position,
                                    heavy.bodies[1].tissue.rest_position);
    };
    CHECK(sagged(with) > 1e-5);
    CHECK(sagged(without) < 1e-8);  // [m] rounding of the packed laws
  }
}

TEST_CASE("a weightless linear solid is solved without its weight") {
  Scene scene;
  scene.gravity = {0.0, 0.0, -9.81};
  scene.bodies[0].tissue = scenes::make_linear_organ(5, 0.9, 0.2);
  const Scene heavy = build_scene(scene);
  scene.bodies[0].weightless = true;
  const Scene light = build_scene(std::move(scene));

  const auto largest = [](const Scene& made) {
    float most = 0.0F;
    for (const float sag : made.bodies[0].response->sag) most = std::max(most, std::abs(sag));
    return most;
  };

  CHECK(largest(heavy) > 1e-6F);
  CHECK(largest(light) == 0.0F);
}

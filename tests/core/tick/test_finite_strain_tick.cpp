// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "core/model/refusal.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/hyperelastic_solids.h"

using namespace palpate;
using scenes::FiniteLaw;
using scenes::kFiniteLaws;

namespace {

Scene make_unbuilt(const FiniteLaw& law) {
  Scene scene;
  scene.bodies[0].tissue =
      scenes::make_finite_organ(law, 4, 0.9, {.damping_ratio = 0.2, .drag = 3.0});
  return scene;
}

/// [N] Moves from `from` to `to` [m] in as many ticks.
double move(const Scene& scene, double from, double to, int ticks, World& world) {
  HapticCommand command;
  for (int i = 1; i <= ticks; ++i) {
    HapticSample hand;
    hand.position = {0.001, 0.002, from + (to - from) * i / ticks};
    command = tick(scene, hand, 1e-3, world);
  }
  return command.force.z();
}

}  // namespace

TEST_CASE("a solid at finite strain is pressed in, pushes back, and comes back") {
  for (const FiniteLaw& law : kFiniteLaws) {
    for (const double modulus : {0.0, 6270.0}) {  // the hard law, and a near field
      CAPTURE(std::string(law.name));
      CAPTURE(modulus);
      Scene unbuilt = make_unbuilt(law);
      unbuilt.bodies[0].contact_modulus = modulus;
      const Scene scene = build_scene(std::move(unbuilt));
      World world(scene);
      const double touch = 0.03 + scene.instruments[0].tool.radius;

      const double shallow = move(scene, touch + 0.005, touch - 0.0015, 200, world);
      const double deep = move(scene, touch - 0.0015, touch - 0.003, 200, world);
      move(scene, touch - 0.003, touch + 0.01, 200, world);
      const double away = move(scene, touch + 0.01, touch + 0.01, 1000, world);

      CHECK(!world.alarm);
      CHECK(shallow > 0.01);
      CHECK(deep > 1.5 * shallow);
      CHECK(away == 0.0);
      CHECK(scenes::max_difference(world.bodies[0].tissue.position,
                                   scene.bodies[0].tissue.rest_position) < 1e-4);
    }
  }
}

TEST_CASE("a solid at finite strain runs on the reference kernel, and on no other") {
  for (const FiniteLaw& law : kFiniteLaws) {
    Scene scene = make_unbuilt(law);
    CHECK(build_scene(scene).bodies[0].kernel == Kernel::reference);
    scene.bodies[0].kernel = Kernel::packed;
    CHECK(find_refusal([&] { build_scene(scene); }) ==
          "scene: kernel: got packed, expected automatic or reference for a corotated or "
          "neo-Hookean solid, which vector code does not step");
    scene.bodies[0].kernel = Kernel::response;
    CHECK(find_refusal([&] { build_scene(scene); }) ==
          "scene: kernel: got response, expected automatic, packed or reference for a tissue that "
          "is no linear solid");
  }
}

TEST_CASE("no part of a solid at finite strain may sleep") {
  for (const FiniteLaw& law : kFiniteLaws) {
    Scene scene = make_unbuilt(law);
    scene.bodies[0].force_error = 1e-3;
    CHECK(find_refusal([&] { build_scene(scene); })
              .find(std::string("scene: force_error [N]: got a ") + law.name +
                    " solid, expected 0: "
                    "solids are moved whole") == 0);
  }
}

TEST_CASE("pressed deep a solid at finite strain gets more substeps, and stays stable") {
  for (const FiniteLaw& law : kFiniteLaws) {
    CAPTURE(std::string(law.name));
    const Scene scene = build_scene(make_unbuilt(law));
    World world(scene);
    const double touch = 0.03 + scene.instruments[0].tool.radius;

    move(scene, touch + 0.005, touch - 0.02, 300, world);

    CHECK(!world.alarm);
    CHECK(world.bodies[0].stretch.largest_face > 1.0);
    CHECK(world.bodies[0].substeps >= scene.bodies[0].substeps);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/scenes.h"
#include "scenes/tables.h"

using namespace palpate;
using namespace palpate::scenes;

namespace {

constexpr double kDt = 1e-3;

/// A layer of 5 mm, 60 mm wide, that lies on a table at a gap of 0.
constexpr Layers kLayer{.side = 0.06, .cells = {12, 12, 2}};

/// [m] What a float may leave of a gap that is 0 in double.
double gap_tolerance() { return kernel_under_test() == Kernel::reference ? 1e-15 : 1e-8; }

struct Pressed {
  double deepest = 0.0;          ///< [m] of any vertex under the table, in any tick
  double smallest_volume = 1.0;  ///< [-] J, in any tick
  double noise = 0.0;            ///< [N] second difference of the force, at the end
  double force = 0.0;            ///< [N] on the hand
  double on_table = 0.0;         ///< [N] on the layer, up
  int substeps = 0;
  Alarm alarm;
};

/// Presses the layer by `depth` [m] and holds.
Pressed press(const Scene& scene, double depth, double rest = 0.3) {
  World world(scene);
  Pressed pressed;
  const double radius = scene.instruments[0].tool.radius, top = 0.0025 + radius + 1e-4;
  const int ticks = static_cast<int>(std::lround((depth / 0.04 + rest) / kDt));
  std::vector<double> forces;
  HapticSample sample;
  for (int i = 0; i < ticks && !world.alarm; ++i) {
    sample.position = {0.001, 0.002, top - std::min(depth, 0.04 * i * kDt)};
    forces.push_back(tick(scene, sample, kDt, world).force.z());
    pressed.deepest = std::max(pressed.deepest, find_depth_under(world.bodies[0], -0.0025));
    pressed.smallest_volume =
        std::min(pressed.smallest_volume, world.bodies[0].stretch.smallest_volume);
    pressed.substeps = std::max(pressed.substeps, world.bodies[0].substeps);
  }
  for (std::size_t i = forces.size() - 50; i + 1 < forces.size(); ++i) {
    pressed.noise =
        std::max(pressed.noise, std::abs(forces[i + 1] - 2.0 * forces[i] + forces[i - 1]));
  }
  pressed.force = forces.back();
  pressed.on_table = world.scenery_contacts[0].force.z();
  pressed.alarm = world.alarm;
  return pressed;
}

}  // namespace

TEST_CASE("S2: a layer that begins at a gap of 0 on a table is pressed to 50 and 70 %") {
  for (const double depth : {0.0025, 0.0035}) {
    CAPTURE(depth);
    const Pressed pressed = press(build_scene(make_layer_on_table(kLayer, 0.008)), depth);
    MESSAGE("J ", pressed.smallest_volume, " noise ", pressed.noise, " N, force ", pressed.force,
            " table ", pressed.on_table, " deepest ", pressed.deepest);
    CHECK_FALSE(pressed.alarm);
    CHECK(pressed.deepest <= gap_tolerance());
    CHECK(pressed.smallest_volume > 0.3);
    CHECK(pressed.force > 0.05);
    CHECK(pressed.on_table > 0.0);
  }
}

TEST_CASE("scenery asks for no substep") {
  Scene scene = make_layer_on_table(kLayer, 0.008);
  scene.gravity = {0.0, 0.0, -9.81};
  scene = build_scene(std::move(scene));
  World world(scene);
  HapticSample sample;
  sample.position = {0.0, 0.0, 0.2};
  for (int i = 0; i < 20; ++i) {
    tick(scene, sample, kDt, world);
    CHECK(world.bodies[0].substeps == scene.bodies[0].substeps);
  }
  CHECK(world.scenery_contacts[0].touching > 50);
}

TEST_CASE("a body passes through scenery that does not list it, an instrument through none") {
  Scene scene = make_layer_on_table(kLayer, 0.003);
  scene.scenery[0].bodies.clear();
  scene.scenery[0].mesh = make_table(0.2, 4, {0.0, 0.0, 0.02});
  scene = build_scene(std::move(scene));
  World world(scene);
  HapticSample sample;
  double lowest = 1.0;
  for (int i = 0; i < 400; ++i) {
    sample.position = {0.001, 0.002, 0.04 - std::min(0.035, 1e-3 * i)};
    const HapticCommand command = tick(scene, sample, kDt, world);
    lowest = std::min(lowest, world.instruments[0].tool.position.z());
    if (i > 300) CHECK(command.force.z() == doctest::Approx(5.0).epsilon(0.01));
  }
  CHECK_FALSE(world.alarm);
  CHECK(lowest > 0.02 + 0.003 - 1e-4);  // 5 N into 1e5 N/m
  CHECK(world.instruments[0].tool.touching);
  CHECK(world.scenery_contacts.empty());
}

TEST_CASE("an instrument of capsules and one of jaws stop at scenery as a ball does") {
  for (const bool has_jaws : {false, true}) {
    CAPTURE(has_jaws);
    Scene scene = make_layer_on_table(kLayer, 0.0025);
    scene.scenery[0].mesh = make_table(0.2, 4, {0.0, 0.0, 0.02});
    scene.scenery[0].bodies.clear();
    Tool& tool = scene.instruments[0].tool;
    tool.capsules = {{{0.0, 0.001, 0.0}, {0.0, 0.001, 0.02}},
                     {{0.0, -0.001, 0.0}, {0.0, -0.001, 0.02}}};
    if (has_jaws) tool.jaws = Jaws{};
    scene = build_scene(std::move(scene));
    World world(scene);
    HapticSample sample;
    const ToolState& state = world.instruments[0].tool;
    for (int i = 0; i < 300; ++i) {
      sample.position = {0.001, 0.002, 0.04 - std::min(0.025, 1e-3 * i)};
      tick(scene, sample, kDt, world);
      for (std::size_t c = 0; c < 2; ++c) {
        const Capsule axis = open_jaw(scene.instruments[0].tool, c, state.jaw_angle);
        REQUIRE(state.position.z() + axis.from.z() > 0.02 + 0.8 * 0.0025);
      }
    }
    CHECK_FALSE(world.alarm);
    CHECK(world.instruments[0].tool.touching);
  }
}

TEST_CASE("jaws that rub close on scenery, hold on to it and let go") {
  Scene scene = make_layer_on_table(kLayer, 0.0025);
  scene.scenery[0].mesh = make_table(0.2, 40, {0.0, 0.0, 0.02});
  scene.scenery[0].bodies.clear();
  Tool& tool = scene.instruments[0].tool;
  tool.capsules = {{{0.0, 0.001, 0.0}, {0.0, 0.001, 0.02}},
                   {{0.0, -0.001, 0.0}, {0.0, -0.001, 0.02}}};
  tool.jaws = Jaws{};
  tool.friction = 0.5;
  scene = build_scene(std::move(scene));
  World world(scene);
  HapticSample sample;
  int anchors = 0;
  for (int i = 0; i < 600; ++i) {
    sample.position = {0.001, 0.002, 0.04 - std::min(0.022, 1e-3 * i)};
    sample.buttons = i > 100 && i < 400 ? kAttachButton : 0;
    REQUIRE(tick(scene, sample, kDt, world).force.allFinite());
    anchors = std::max(anchors, world.instruments[0].tool.anchor_count);
  }
  CHECK_FALSE(world.alarm);
  CHECK(anchors > 0);
}

TEST_CASE("no flick brings a tip through scenery" * doctest::test_suite("landing")) {
  Scene scene = make_layer_on_table(kLayer, 0.0015);
  scene.scenery[0].mesh = make_table(0.2, 40, {0.0, 0.0, 0.02});
  scene.scenery[0].bodies.clear();
  scene = build_scene(std::move(scene));
  for (int k = 0; k < 50; ++k) {
    World world(scene);
    HapticSample sample;
    for (int i = 0; i < 40; ++i) {
      sample.position = {1.3e-4 * k, 7e-5 * k, 0.03 - std::min(0.022, 3e-3 * i)};
      tick(scene, sample, kDt, world);
      REQUIRE(world.instruments[0].tool.position.z() > 0.02);
    }
  }
}

TEST_CASE("a body that is thrown at a table at 1 m/s does not come through, and rests on it") {
  Scene scene;
  scene.bodies[0].kernel = kernel_under_test();
  scene.bodies[0].tissue =
      make_soft_block({0.02, 0.02, 0.02}, {5, 5, 5}, 5e3, {0.0, 0.0, 0.0605}, false);
  scene.scenery = {{make_table(0.06, 6), {0}, 0.3}};
  scene.gravity = {0.0, 0.0, -9.81};
  scene = build_scene(std::move(scene));
  World world(scene);
  double mass = 0.0;
  for (const double m : scene.bodies[0].tissue.mass) mass += m;
  HapticSample sample;
  sample.position = {0.0, 0.0, 0.2};
  for (int i = 0; i < 1500; ++i) {
    tick(scene, sample, kDt, world);
    REQUIRE_FALSE(world.alarm);
    REQUIRE(find_depth_under(world.bodies[0], 0.0) <= gap_tolerance());
  }
  CHECK(world.scenery_contacts[0].touching > 10);
  CHECK(world.scenery_contacts[0].force.z() == doctest::Approx(9.81 * mass).epsilon(0.02));
}

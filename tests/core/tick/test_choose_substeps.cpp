// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/tick/press_scene.h"
#include "palpate/sim/dynamics/private/measure_stretch.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/grasped.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// An organ that a tool holds at its middle and pulls out by `height` [m] over 0.4 s, keeps there
/// for 0.1 s, lets go, and waits for a second.
struct Pull {
  explicit Pull(double height_in) : scene(make_soft()), world(scene), height(height_in) {}

  /// Where links weigh more than home springs.
  static Scene make_soft() {
    Scene soft = press_scene();
    for (double& home : soft.bodies[0].tissue.home) home *= 0.1;
    soft.bodies[0].substeps = soft.bodies[0].substeps_max = 0;
    return build_scene(std::move(soft));
  }

  HapticSample hand(int i) const {
    HapticSample sample;
    const double up = height * std::clamp((i - 150) / 400.0, 0.0, 1.0);
    sample.position = {0.001, 0.002, i < 20 ? 0.0235 : 0.0205 + up};
    sample.buttons = i > 150 && i < 650 ? kAttachButton : 0;
    if (i >= 700) sample.position.z() = 0.06;
    return sample;
  }

  Scene scene;
  World world;
  double height;
};

}  // namespace

TEST_CASE("a tissue that is stretched gets more substeps, and gives them back at rest") {
  Pull pull(0.065);
  double stiffest = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const Stretch before = pull.world.bodies[0].stretch;
    const double now = bound_stiffness(internals(pull.world.bodies[0]).spectrum, before);
    tick(pull.scene, pull.hand(i), 1e-3, pull.world);
    // at the very next tick, and by no less than it takes
    CHECK(now <= 1.2 * internals(pull.world.bodies[0]).chosen_stiffness);
    CHECK(now >= internals(pull.world.bodies[0]).chosen_stiffness / 1.2);
    stiffest = std::max(stiffest, internals(pull.world.bodies[0]).chosen_stiffness);
  }
  REQUIRE_FALSE(pull.world.alarm);
  CHECK(stiffest > 1.2 * pull.scene.bodies[0].spectrum_stiffness);
  CHECK(internals(pull.world.bodies[0]).chosen_stiffness ==
        pull.scene.bodies[0].spectrum_stiffness);
  CHECK(pull.world.bodies[0].substeps == pull.scene.bodies[0].substeps);
}

TEST_CASE("a tissue that is hardly stretched keeps the substeps it rests with") {
  Pull pull(0.001);
  for (int i = 0; i < 1000; ++i) {
    tick(pull.scene, pull.hand(i), 1e-3, pull.world);
    CHECK(internals(pull.world.bodies[0]).chosen_stiffness ==
          pull.scene.bodies[0].spectrum_stiffness);
  }
}

TEST_CASE("in the air a stretched tissue has as many substeps as its stiffness needs") {
  Scene scene = press_scene();
  scene.bodies[0].substeps = 8;
  // so that eight are just enough
  scene.bodies[0].spectrum_damping = 0.0;
  const double rest = scene.bodies[0].spectrum_stiffness;
  scene.rate = 1.0 / (8 * 0.74 * 2.0 / std::sqrt(rest));
  World world(scene);
  world.bodies[0].stretch.longest = 2.5;
  const double stiffer =
      bound_stiffness(internals(world.bodies[0]).spectrum, world.bodies[0].stretch) / rest;
  REQUIRE(stiffer > 1.2);

  HapticSample hand;
  hand.position = {0, 0, 0.06};
  tick(scene, hand, 1.0 / scene.rate, world);

  CHECK(world.bodies[0].substeps == static_cast<int>(std::ceil(8.0 * std::sqrt(stiffer))));
}

TEST_CASE("substeps that follow the stretch are the same in every run of the same hand") {
  Pull first(0.065), second(0.065);
  int most = 0;
  for (int i = 0; i < 900; ++i) {
    const Vec3 a = tick(first.scene, first.hand(i), 1e-3, first.world).force;
    const Vec3 b = tick(second.scene, second.hand(i), 1e-3, second.world).force;
    CHECK(a == b);
    CHECK(first.world.bodies[0].substeps == second.world.bodies[0].substeps);
    most = std::max(most, first.world.bodies[0].substeps);
  }
  CHECK(most > first.scene.bodies[0].substeps);
  CHECK(compute_hash(first.world) == compute_hash(second.world));
}

TEST_CASE("two hands far from each other ask for as many substeps as the one that asks for more") {
  Scene two = press_scene();
  two.instruments.push_back(two.instruments[0]);
  two = build_scene(std::move(two));
  World both(two), first(two), second(two);
  HapticSample away;
  away.position = {0, 0, 0.08};
  for (int i = 0; i < 60; ++i) {
    HapticSample one, other;
    one.position = {0.012, 0.0, 0.0245 - 1e-4 * i};
    other.position = {-0.012, 0.0, 0.0245 - 0.8e-4 * i};
    std::array<HapticCommand, 2> felt;
    tick(two, std::array{one, other}, 1e-3, both, felt);
    tick(two, std::array{one, away}, 1e-3, first, felt);
    tick(two, std::array{away, other}, 1e-3, second, felt);
  }
  const auto contact = [](const World& world) {
    return internals(world.bodies[0]).contact_stiffness;
  };
  REQUIRE_FALSE(both.alarm);
  REQUIRE(contact(second) > 0.0);
  // the tissue that the other one presses is a little elsewhere
  CHECK(contact(both) == doctest::Approx(std::max(contact(first), contact(second))).epsilon(0.05));
  CHECK(contact(both) < 0.9 * (contact(first) + contact(second)));
}

TEST_CASE("what counts the stiffness of contacts leaves no numbers behind") {
  // a stone, or jaws on a solid, would have counted them with their own
  Scene scene = press_scene();
  World world(scene);
  for (int i = 0; i < 60; ++i) {
    HapticSample hand;
    hand.position = {0.001, 0.002, 0.0245 - 1e-4 * i};
    tick(scene, hand, 1e-3, world);
  }
  REQUIRE(internals(world.bodies[0]).contact_stiffness > 0.0);
  for (const double row : internals(world.bodies[0]).vertex_scratch) CHECK(row == 0.0);
}

namespace {

/// Holds what is grasped until what a peak has asked for is taken back, and checks that its
/// substeps are the fewest with dt² w0²/0.9² + 2 dt c/0.9 + dt² (k/m)/0.75² <= 4.
void check_held(Scene scene) {
  scene.bodies[0].substeps_max = 100;
  scenes::GraspingHand hand(scene);
  hand.close();
  hand.wait(0.2);
  hand.go(0.002, 0.1);
  hand.wait(0.6);
  const BodyInternals& work = internals(hand.world().bodies[0]);
  const double c = scene.bodies[0].spectrum_damping, dt = 1.0 / scene.rate;
  REQUIRE(work.contact_stiffness > 0.0);
  const auto asked = [&](double step) {
    const double tissue = step / 0.9, contact = step / 0.75;
    return tissue * tissue * work.chosen_stiffness + 2.0 * tissue * c +
           contact * contact * work.contact_stiffness;
  };
  const int substeps = hand.world().bodies[0].substeps;
  CHECK(substeps > scene.bodies[0].substeps);
  CHECK(asked(dt / substeps) <= 4.0);
  CHECK(asked(dt / (substeps - 2)) > 4.0);
}

}  // namespace

TEST_CASE("what jaws hold of a wall has nine tenths of its step, and contacts less") {
  check_held(scenes::make_grasped_wall(scenes::make_grasper(0.5, 1.0), 500.0));
  check_held(scenes::make_grasped_slab(scenes::make_grasper(0.5, 1.0), 500.0));
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/tick/press_scene.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/tissues.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

HapticSample hand_at(const Vec3& position, std::uint8_t buttons = 0) {
  HapticSample sample;
  sample.position = position;
  sample.buttons = buttons;
  return sample;
}

/// Ticks a hand that stays where it is; returns the last command.
HapticCommand stay(const Scene& scene, World& world, const HapticSample& sample, int ticks) {
  HapticCommand command;
  for (int i = 0; i < ticks; ++i) command = tick(scene, sample, 1e-3, world);
  return command;
}

/// Ticks a script from its start; returns all forces.
std::vector<Vec3> run(const Scene& scene, World& world, ScriptedDevice hand, int ticks) {
  std::vector<Vec3> forces;
  for (int i = 0; i < ticks; ++i) {
    forces.push_back(tick(scene, hand.read(1e-3 * i), 1e-3, world).force);
  }
  return forces;
}

}  // namespace

TEST_CASE("a hand that touches nothing feels exactly nothing and moves nothing") {
  const Scene scene = press_scene();
  World world(scene);

  const HapticCommand command = stay(scene, world, hand_at({0, 0, 0.0231}), 100);

  CHECK(command.force == Vec3::Zero());
  CHECK_FALSE(world.instruments[0].tool.touching);
  CHECK(scenes::max_difference(world.bodies[0].tissue.position,
                               scene.bodies[0].tissue.rest_position) <= scenes::rest_tolerance());
  CHECK(world.tick_count == 100);
}

TEST_CASE("pressing down is felt as a push up, harder the deeper") {
  const Scene scene = press_scene();
  World world(scene);
  ScriptedDevice hand = press_script(0.004, 1.0);

  const std::vector<Vec3> forces = run(scene, world, hand, 500);

  CHECK_FALSE(world.alarm);
  CHECK(forces[100] == Vec3::Zero());
  CHECK(forces[499].z() > 0.05);
  CHECK(forces[499].z() > 2.0 * forces[250].z());
  CHECK(world.instruments[0].tool.touching);
}

TEST_CASE("the force on the hand is at most that of the coupling") {
  Scene scene = press_scene();
  scene.instruments[0].coupling.force_max = 0.1;
  World world(scene);

  const std::vector<Vec3> forces = run(scene, world, press_script(0.010, 0.5), 500);

  const Vec3 most =
      *std::max_element(forces.begin(), forces.end(),
                        [](const Vec3& a, const Vec3& b) { return a.norm() < b.norm(); });
  CHECK(most.norm() > 0.09);
  CHECK(most.norm() <= 0.1 * (1.0 + 1e-12));
}

TEST_CASE("the same hand gives the same bits in another world") {
  const Scene scene = press_scene();
  World first(scene), second(scene);

  const auto a = run(scene, first, press_script(0.005, 0.5, true), 500);
  const auto b = run(scene, second, press_script(0.005, 0.5, true), 500);

  CHECK(a == b);
  CHECK(compute_hash(first) == compute_hash(second));
}

TEST_CASE("another hand, a moved particle or another hold give another hash") {
  const Scene scene = press_scene();
  World world(scene), other(scene);
  run(scene, world, press_script(0.005, 0.5, true), 300);
  run(scene, other, press_script(0.005, 0.5, true), 300);
  const auto hash = compute_hash(world);
  REQUIRE(compute_hash(other) == hash);

  REQUIRE(other.instruments[0].tool.hold_count > 0);
  --other.instruments[0].tool.hold_count;
  CHECK(compute_hash(other) != hash);
  ++other.instruments[0].tool.hold_count;
  other.bodies[0].tissue.velocity[7].y() =
      std::nextafter(other.bodies[0].tissue.velocity[7].y(), 1.0);
  CHECK(compute_hash(other) != hash);
}

TEST_CASE("a hand that begins inside the organ has no tool until it has come out") {
  const Scene scene = press_scene();
  World world(scene);

  const HapticCommand inside = stay(scene, world, hand_at({0, 0, 0.015}), 50);

  CHECK(inside.force == Vec3::Zero());
  CHECK_FALSE(world.instruments[0].tool.placed);
  CHECK(scenes::max_difference(world.bodies[0].tissue.position,
                               scene.bodies[0].tissue.rest_position) <= scenes::rest_tolerance());

  CHECK(stay(scene, world, hand_at({0, 0, 0.03}), 1).force == Vec3::Zero());
  CHECK(world.instruments[0].tool.placed);
  CHECK(stay(scene, world, hand_at({0, 0, 0.021}), 400).force.z() > 0.0);
}

TEST_CASE("the attach button fastens what is touched, pulling is felt, letting go frees it") {
  const Scene scene = press_scene();
  World world(scene);
  stay(scene, world, hand_at({0, 0, 0.0235}), 1);
  stay(scene, world, hand_at({0, 0, 0.0205}), 200);
  REQUIRE(world.instruments[0].tool.touching);

  stay(scene, world, hand_at({0, 0, 0.0205}, kAttachButton), 1);
  CHECK(world.instruments[0].tool.hold_count > 0);
  const HapticCommand pulled = stay(scene, world, hand_at({0, 0, 0.0285}, kAttachButton), 300);
  CHECK(pulled.force.z() < -0.05);

  CHECK(stay(scene, world, hand_at({0, 0, 0.0285}), 60).force == Vec3::Zero());
  CHECK(world.instruments[0].tool.hold_count == 0);
  CHECK_FALSE(world.alarm);
}

TEST_CASE("letting go of a pull fades over 30 ms: no tick takes more than a fifth of the load") {
  const Scene scene = press_scene();
  World world(scene);
  stay(scene, world, hand_at({0, 0, 0.0235}), 1);
  stay(scene, world, hand_at({0, 0, 0.0205}), 200);
  const HapticSample high = hand_at({0, 0, 0.0285}, kAttachButton);
  stay(scene, world, hand_at({0, 0, 0.0205}, kAttachButton), 1);
  const double load = stay(scene, world, high, 400).force.norm();
  REQUIRE(load > 0.05);
  REQUIRE(world.instruments[0].tool.hold_count > 0);

  double last = load, largest_drop = 0.0;
  for (int t = 0; t < 60; ++t) {
    const double now = tick(scene, hand_at(high.position), 1e-3, world).force.norm();
    largest_drop = std::max(largest_drop, last - now);
    last = now;
  }

  CHECK(largest_drop < 0.2 * load);
  CHECK(last == 0.0);
  CHECK(world.instruments[0].tool.hold_count == 0);
  CHECK_FALSE(world.alarm);
}

TEST_CASE("pressing the attach button in the air fastens nothing, then or later") {
  const Scene scene = press_scene();
  World world(scene);

  stay(scene, world, hand_at({0, 0, 0.03}, kAttachButton), 10);
  stay(scene, world, hand_at({0, 0, 0.021}, kAttachButton), 400);

  CHECK(world.instruments[0].tool.touching);
  CHECK(world.instruments[0].tool.hold_count == 0);
}

TEST_CASE("substeps are few in the air, never fall near the tissue, and stay within their bounds") {
  const Scene scene = press_scene();
  World world(scene);
  stay(scene, world, hand_at({0, 0, 0.04}), 10);
  CHECK(world.bodies[0].substeps == scene.bodies[0].substeps);

  stay(scene, world, hand_at({0, 0, 0.0235}), 10);
  CHECK(world.bodies[0].substeps >= 3);
  for (int i = 0; i < 800; ++i) {
    const int before = world.bodies[0].substeps;
    tick(scene, hand_at({0, 0, 0.0235 - 1e-5 * std::min(i, 800 - i)}), 1e-3, world);
    CHECK(world.bodies[0].substeps >= before);
    CHECK(world.bodies[0].substeps <= scene.bodies[0].substeps_max);
  }
  CHECK(world.bodies[0].substeps > 3);

  stay(scene, world, hand_at({0, 0, 0.04}), 20);
  CHECK(world.bodies[0].substeps == scene.bodies[0].substeps);
}

TEST_CASE("a hand faster than 3 m/s is followed at that speed and felt only where the tool is") {
  const Scene scene = press_scene();
  World world(scene);
  stay(scene, world, hand_at({0, 0, 0.05}), 1);

  const HapticCommand command = stay(scene, world, hand_at({0, 0, 0.10}), 1);

  CHECK(world.instruments[0].tool.position.z() == doctest::Approx(0.053));
  CHECK(command.force == Vec3::Zero());
  stay(scene, world, hand_at({0, 0, 0.10}), 16);
  CHECK(world.instruments[0].tool.position == Vec3(0, 0, 0.10));
}

TEST_CASE("letting go of a hard pull is no alarm") {
  const Scene scene = press_scene();
  World world(scene);
  stay(scene, world, hand_at({0, 0, 0.0235}), 1);
  stay(scene, world, hand_at({0, 0, 0.0205}), 50);
  const HapticCommand pulled = stay(scene, world, hand_at({0, 0, 0.0405}, kAttachButton), 500);
  REQUIRE(pulled.force.norm() > 1.0);

  stay(scene, world, hand_at({0, 0, 0.0405}), 1500);

  CHECK_FALSE(world.alarm);
  CHECK((world.bodies[0].tissue.position[5] - scene.bodies[0].tissue.rest_position[5]).norm() <
        1e-4);
}

TEST_CASE("a hand that jumps through the organ in one tick leaves its tool on this side") {
  const Scene scene = press_scene();
  World world(scene);
  stay(scene, world, hand_at({0.001, 0.002, 0.030}), 1);

  for (int i = 0; i < 200; ++i) {
    tick(scene, hand_at({0.001, 0.002, 0.005}), 1e-3, world);
  }

  CHECK_FALSE(world.alarm);
  CHECK(compute_winding_number(scene.bodies[0].tissue.triangles, world.bodies[0].tissue.position,
                               world.instruments[0].tool.position) < 0.5);
}

TEST_CASE("a tissue that blows up stands still from then on and the force is zero for good") {
  Scene scene = press_scene();
  scene.bodies[0].substeps = scene.bodies[0].substeps_max = 1;
  scene.rate = 1000.0 / (4.0 * press_scene().bodies[0].substeps);
  const double dt = 1.0 / scene.rate;
  World world(scene);
  world.recovers = false;
  for (int i = 0; i < 2000 && !world.alarm; ++i) {
    tick(scene, hand_at({0, 0, i == 0 ? 0.03 : 0.021}), dt, world);
  }
  REQUIRE(world.alarm);
  const Alarm alarm = world.alarm;
  const Vec3Array frozen = world.bodies[0].tissue.position;

  for (int i = 0; i < 10; ++i) {
    CHECK(tick(scene, hand_at({0, 0, 0.019}), dt, world).force == Vec3::Zero());
  }

  CHECK(world.bodies[0].tissue.position == frozen);
  CHECK(std::all_of(frozen.begin(), frozen.end(), [](const Vec3& x) { return x.allFinite(); }));
  CHECK(world.alarm.kind == alarm.kind);
  CHECK(world.alarm.time == alarm.time);
}

TEST_CASE("gravity makes a tissue sag, and the weight is not felt by a hand in the air") {
  Scene scene = press_scene();
  scene.gravity = Vec3(0, 0, -9.81);
  World world(scene);

  const HapticCommand command = stay(scene, world, hand_at({0, 0, 0.04}), 300);

  CHECK(command.force == Vec3::Zero());
  CHECK(world.bodies[0].tissue.position[5].z() <= scene.bodies[0].tissue.rest_position[5].z());
  CHECK(world.bodies[0].tissue.position != scene.bodies[0].tissue.rest_position);
  CHECK_FALSE(world.alarm);
}

TEST_CASE("what a record keeps of a tick is its force, its tool and what it touched") {
  const Scene scene = press_scene();
  World world(scene);
  stay(scene, world, hand_at({0, 0, 0.03}), 1);
  const HapticCommand command = stay(scene, world, hand_at({0, 0, 0.020}), 100);

  const Felt felt = compute_felt(command, world);

  CHECK(felt.force == command.force.cast<float>());
  CHECK(felt.position == world.instruments[0].tool.position.cast<float>());
  CHECK(felt.touched == 1);
  stay(scene, world, hand_at({0, 0, 0.020}, kAttachButton), 1);
  CHECK(compute_felt(command, world).touched == 3);
}

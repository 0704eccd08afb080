// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <type_traits>

#include "core/tick/press_scene.h"
#include "palpate/sim/loop/loop.h"
#include "palpate/sim/tick/private/check_input.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/tissues.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A press that has come to a force, and what it takes to go on with it.
struct Press {
  Scene scene = press_scene();
  World world{scene};
  HapticSample sample;
  double dt = 1e-3;
  Vec3 last = Vec3::Zero();  ///< [N]

  Press() {
    ScriptedDevice hand = press_script(0.004, 0.45);
    for (int i = 0; i < 200; ++i) {
      sample = hand.read(1e-3 * i);
      last = go();
    }
    REQUIRE(last.norm() > 0.05);
    REQUIRE_FALSE(world.alarm);
  }

  Vec3 go() { return tick(scene, sample, dt, world).force; }
};

/// What goes wrong in a press, and what the alarm must say of it.
struct Fault {
  std::string name;
  std::function<void(Press&)> apply;
  TickInput input;
};

std::vector<Fault> list_faults() {
  std::vector<Fault> faults;
  const auto add = [&](const char* name, TickInput input, std::function<void(Press&)> apply) {
    faults.push_back({name, std::move(apply), input});
  };
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    add("position", TickInput::position, [=](Press& p) { p.sample.position.y() = bad; });
    add("velocity", TickInput::velocity, [=](Press& p) { p.sample.velocity.x() = bad; });
    add("orientation", TickInput::orientation, [=](Press& p) { p.sample.orientation.w() = bad; });
    add("grip", TickInput::grip, [=](Press& p) { p.sample.grip = bad; });
    add("time", TickInput::time, [=](Press& p) { p.sample.time = bad; });
    add("gravity", TickInput::gravity, [=](Press& p) { p.scene.gravity.z() = bad; });
  }
  add("far", TickInput::position, [](Press& p) { p.sample.position.x() = -1e300; });
  for (const double bad : {kNan, kInfinity, 0.0, -1e-3}) {
    add("dt", TickInput::dt, [=](Press& p) { p.dt = bad; });
    add("radius", TickInput::tool_radius,
        [=](Press& p) { p.scene.instruments[0].tool.radius = bad; });
    add("k_A", TickInput::tool_stiffness,
        [=](Press& p) { p.scene.instruments[0].tool.stiffness = bad; });
    add("K", TickInput::coupling_stiffness,
        [=](Press& p) { p.scene.instruments[0].coupling.stiffness = bad; });
    add("F", TickInput::coupling_force_max,
        [=](Press& p) { p.scene.instruments[0].coupling.force_max = bad; });
    add("hold", TickInput::hold_stiffness,
        [=](Press& p) { p.scene.instruments[0].hold_stiffness = bad; });
  }
  for (const double bad : {kNan, kInfinity, -0.1}) {
    add("mu", TickInput::tool_friction,
        [=](Press& p) { p.scene.instruments[0].tool.friction = bad; });
  }
  add("substeps", TickInput::substeps, [](Press& p) { p.scene.bodies[0].substeps = 0; });
  add("substeps_max", TickInput::substeps_max,
      [](Press& p) { p.scene.bodies[0].substeps_max = 0; });
  return faults;
}

}  // namespace

TEST_CASE("what a tick cannot use is an alarm that names it, and the force fades within 20 ms") {
  for (const Fault& fault : list_faults()) {
    CAPTURE(fault.name);
    Press press;
    const double before = press.last.norm();
    const Vec3Array at = press.world.bodies[0].tissue.position;

    fault.apply(press);
    const Vec3 first = press.go();

    CHECK(press.world.alarm.kind == AlarmKind::invalid_input);
    CHECK(press.world.alarm.index == static_cast<int>(fault.input));
    CHECK(press.world.alarm.time == press.world.bodies[0].tissue.time);
    CHECK((first - 0.95 * press.last).norm() <= 1e-12 * before);
    double last = first.norm();
    for (int i = 2; i <= 25; ++i) {
      const double now = press.go().norm();
      CHECK(now <= last);
      CHECK(last - now <= before / 20.0 * (1.0 + 1e-9));
      last = now;
      if (i == 20) CHECK(now == 0.0);
    }
    CHECK(last == 0.0);
    CHECK(press.world.bodies[0].tissue.position == at);
  }
}

TEST_CASE("a force that fades never grows again, whatever the samples then are") {
  Press press;
  press.sample.position.x() = kNan;
  press.go();
  press.sample.position = Vec3(0, 0, 0.01);

  double last = press.last.norm();
  for (int i = 0; i < 30; ++i) {
    const double now = press.go().norm();
    CHECK(now <= last);
    last = now;
  }

  CHECK(last == 0.0);
}

TEST_CASE("the world of another scene is refused, also where all counts are the same") {
  const Scene one = press_scene(), same_counts = press_scene();
  const Scene other = build_scene(make_scene(scenes::make_spring_organ(1)));
  HapticSample hand;
  hand.position = Vec3(0, 0, 0.5);
  for (const Scene* wrong : {&same_counts, &other}) {
    World world(one);
    tick(one, hand, 1e-3, world);

    const HapticCommand command = tick(*wrong, hand, 1e-3, world);

    CHECK(command.force == Vec3::Zero());
    CHECK(world.alarm.kind == AlarmKind::invalid_input);
    CHECK(world.alarm.index == static_cast<int>(TickInput::scene));
  }
}

TEST_CASE("a scene whose tissue was exchanged after it was built is refused") {
  Scene scene = press_scene();
  World world(scene);
  scene.bodies[0].tissue = scenes::make_spring_organ(1);

  tick(scene, {}, 1e-3, world);

  CHECK(world.alarm.index == static_cast<int>(TickInput::scene));
}

TEST_CASE("a copy of a scene ticks the world of the one it was copied from") {
  Press press;
  const Scene copy = press.scene;

  const Vec3 force = tick(copy, press.sample, press.dt, press.world).force;

  CHECK_FALSE(press.world.alarm);
  CHECK(force.norm() > 0.05);
}

TEST_CASE("a loop takes no scene that is gone when it starts") {
  CHECK_FALSE(std::is_constructible_v<Loop, Scene, HapticDevice&>);
  CHECK_FALSE(std::is_constructible_v<Loop, Scene, HapticDevice&, LoopOptions>);
  CHECK(std::is_constructible_v<Loop, const Scene&, HapticDevice&>);
}

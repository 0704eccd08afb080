// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>

#include "calls.h"
#include "core/tick/placed_bodies.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tick/private/check_input.h"
#include "palpate/sim/tick/private/choose_substeps.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "scenes/solids.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

Scene make_scene_of(std::vector<SoftBody> bodies, std::size_t instruments = 1) {
  Scene scene;
  scene.bodies = std::move(bodies);
  scene.instruments.resize(instruments);
  return build_scene(std::move(scene));
}

/// [N] on a body: gravity aside, all that its load does.
Vec3 sum_pushes(const Load& load) {
  Vec3 sum = Vec3::Zero();
  for (const Push& push : load.pushes()) sum += push.force;
  return sum;
}

std::string refusal(Scene scene) {
  try {
    build_scene(std::move(scene));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Asleep, vector code beside other bodies is at rest within 0.1 um, not to the bit.
void keep_awake(World& world) {
  for (SoftState& body : world.bodies) body.asleep = false;
}

}  // namespace

TEST_CASE("a second body out of reach changes no bit of what is felt of the first") {
  const Scene one = make_scene_of({make_body()}),
              two = make_scene_of({make_body(), make_body(kAside)});
  World alone(one), both(two);
  both.follows_all = false;  // as in the live loop
  ScriptedDevice hand = press_script(0.006, 0.5, true);
  for (int i = 0; i < 500; ++i) {
    const HapticSample sample = hand.read(kDt * i);
    REQUIRE(tick(one, sample, kDt, alone).force == tick(two, sample, kDt, both).force);
    keep_awake(both);
  }
  catch_up(two, both);
  CHECK(both.bodies[0].tissue.position == alone.bodies[0].tissue.position);
  CHECK_FALSE(both.alarm);
}

TEST_CASE("each of two hands feels its own body as if it were alone") {
  SoftBody here = make_body(), there = make_body(kAside);
  // else the body with more substeps may raise those of the other
  here.substeps = here.substeps_max = there.substeps = there.substeps_max = 12;
  const Scene one = make_scene_of({here}), other = make_scene_of({there});
  const Scene two = make_scene_of({here, there}, 2);
  World first(one), second(other), both(two);
  ScriptedDevice slow = press_script(0.006, 0.5, true), quick = press_script(0.004, 0.3);
  std::array<HapticCommand, 2> commands;
  for (int i = 0; i < 500; ++i) {
    const std::array samples = {read_at(slow, i), read_at(quick, i, kAside)};
    tick(two, samples, kDt, both, commands);
    keep_awake(both);
    REQUIRE(commands[0].force == tick(one, samples[0], kDt, first).force);
    REQUIRE(commands[1].force == tick(other, samples[1], kDt, second).force);
    REQUIRE(compute_felt(commands[1], both, 1).touched ==
            compute_felt(commands[1], second).touched);
  }
  CHECK(first.instruments[0].last_force != second.instruments[0].last_force);
}

TEST_CASE("two tools in one body push it with the sum of what their hands feel") {
  const Scene scene = make_scene_of({make_body()}, 2);
  World world(scene);
  ScriptedDevice hand = press_script(0.004, 1e3);  // so slow that it stands still
  std::array<HapticCommand, 2> commands;
  const Vec3 apart(0.008, 0.0, -0.001);
  for (int i = 0; i < 300; ++i) {
    HapticSample sample = hand.read(0.45e3);
    sample.position.z() += std::max(0.0, 0.01 - 1e-4 * i);
    HapticSample beside = sample;
    beside.position += apart;
    tick(scene, std::array{sample, beside}, kDt, world, commands);
  }
  const InstrumentState &first = world.instruments[0], &second = world.instruments[1];
  REQUIRE(first.tool.touching);
  REQUIRE(second.tool.touching);
  // the last substep: what each leaves over is its residual [contact: balance]
  const Vec3 on_tissue = sum_pushes(world.bodies[0].load);
  const Vec3 on_first = sum_pushes(world.pair(0, 0).load),
             on_second = sum_pushes(world.pair(1, 0).load);
  CHECK((on_tissue - on_first - on_second).norm() < 1e-12);
  CHECK((on_first + commands[0].force).norm() < 0.02 * on_first.norm());
  CHECK((on_second + commands[1].force).norm() < 0.02 * on_second.norm());
  CHECK_FALSE(world.alarm);
}

TEST_CASE("a tool between two bodies touches both, holds both, and pulls each") {
  // the second organ stands on its head 2 mm closer than the tip is thick
  Scene scene;
  scene.bodies = {make_body(), make_body()};
  for (Vec3& x : scene.bodies[1].tissue.rest_position) x = Vec3(x.x(), -x.y(), 0.044 - x.z());
  for (SoftBody& body : scene.bodies)
    body.tissue.drag = 200.0;  // else the tip rattles between them
  scene = build_scene(std::move(scene));
  World world(scene);
  HapticSample sample;
  for (int i = 0; i < 400; ++i) {
    sample.position = {0.05 - std::min(0.05, 2e-4 * i), 0.0, 0.022};
    sample.buttons = i > 300 ? kAttachButton : 0;
    tick(scene, sample, kDt, world);
  }
  REQUIRE_FALSE(world.alarm);
  const ToolState& tool = world.instruments[0].tool;
  CHECK(world.pair(0, 0).load.push_count > 0);
  CHECK(world.pair(0, 1).load.push_count > 0);
  const auto holds = std::span(tool.holds).first(static_cast<std::size_t>(tool.hold_count));
  for (const int body : {0, 1}) {
    CHECK(
        std::ranges::any_of(holds, [&](const ToolState::Hold& hold) { return hold.body == body; }));
  }
  // one below, one above: they cancel at the hand, which feels neither
  CHECK(sum_pushes(world.pair(0, 0).load).z() < -0.01);
  CHECK(sum_pushes(world.pair(0, 1).load).z() > 0.01);
  CHECK(std::abs(world.instruments[0].last_force.z()) < 2e-3);

  sample.buttons = 0;
  for (int i = 0; i < 60; ++i) tick(scene, sample, kDt, world);
  CHECK(tool.hold_count == 0);
}

TEST_CASE("substeps of every body divide those of the finest, at the least cost") {
  const auto fit = [](std::vector<double> cost, std::vector<int> substeps) {
    make_divisors(cost, substeps);
    return substeps;
  };
  CHECK(fit({1.0}, {17}) == std::vector{17});
  CHECK(fit({1.0, 1.0}, {1, 17}) == std::vector{1, 17});
  CHECK(fit({1.0, 1.0}, {4, 8}) == std::vector{4, 8});
  CHECK(fit({1.0, 1.0}, {3, 8}) == std::vector{4, 8});  // as cheap as 3 and 9, and coarser
  CHECK(fit({1.0, 1.0}, {5, 8}) == std::vector{5, 10});
  // 17 is prime: 18 has the divisor 9
  CHECK(fit({1.0, 1.0}, {8, 17}) == std::vector{9, 18});
  // a body of many particles decides
  CHECK(fit({1.0, 100.0}, {3, 8}) == std::vector{4, 8});
  CHECK(fit({1.0, 1.0, 1.0}, {1, 2, 3}) == std::vector{1, 3, 3});
}

TEST_CASE("a coarse body beside a fine one is felt as when it is alone, within a hundredth") {
  SoftBody coarse = make_body(), fine = make_body(kAside, 20.0);
  coarse.substeps = coarse.substeps_max = 4;
  fine.substeps = fine.substeps_max = 16;
  const Scene one = make_scene_of({coarse}), two = make_scene_of({coarse, fine});
  World alone(one), both(two);
  ScriptedDevice hand = press_script(0.004, 1.0);
  double largest = 0.0, worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const HapticSample sample = hand.read(kDt * i);
    const Vec3 expected = tick(one, sample, kDt, alone).force;
    const Vec3 felt = tick(two, sample, kDt, both).force;
    REQUIRE(both.bodies[0].substeps == 4);
    REQUIRE(both.bodies[1].substeps == 16);
    largest = std::max(largest, expected.norm());
    worst = std::max(worst, (felt - expected).norm());
  }
  CHECK_FALSE(both.alarm);
  CHECK(largest > 0.1);
  CHECK(worst < 0.01 * largest);
}

TEST_CASE("the momentum that a coarse body takes up is what the tool gave in all substeps") {
  SoftBody coarse = make_body(), fine = make_body(kAside, 20.0);
  coarse.kernel = fine.kernel = Kernel::reference;
  coarse.tissue.fixed.clear();
  std::ranges::fill(coarse.tissue.home, 0.0);
  coarse.tissue.drag = 0.0;
  coarse.substeps = coarse.substeps_max = 4;
  fine.substeps = fine.substeps_max = 16;
  const Scene scene = make_scene_of({coarse, fine});
  World world(scene);
  const TissueModel& tissue = scene.bodies[0].tissue;
  const auto momentum = [&] {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < tissue.mass.size(); ++i) {
      sum += tissue.mass[i] * world.bodies[0].tissue.velocity[i];
    }
    return sum;
  };
  ScriptedDevice hand = press_script(0.004, 0.1);
  Vec3 given = Vec3::Zero();
  for (int i = 0; i < 45; ++i) {
    given -= kDt * tick(scene, hand.read(kDt * i), kDt, world).force;
  }
  REQUIRE(given.norm() > 1e-4);
  // what the Newton steps of the tool leave over is felt and not given
  CHECK((momentum() - given).norm() < 0.05 * given.norm());
}

TEST_CASE("an alarm names its body, and all tissue stands still") {
  SoftBody bad = make_body(kAside);
  bad.tissue.drag = 0.0;
  for (double& mass : bad.tissue.mass) mass *= 1e-4;
  Scene scene = make_scene_of({make_body(), bad});
  scene.bodies[1].substeps = scene.bodies[1].substeps_max = 1;  // far beyond the stable step
  World world(scene);
  world.recovers = false;
  ScriptedDevice hand = press_script(0.004, 0.5);
  Vec3 before = Vec3::Zero();
  for (int i = 0; i < 500 && !world.alarm; ++i) {
    before = world.instruments[0].last_force;
    HapticSample sample = hand.read(kDt * i);
    if (i == 200) world.bodies[1].tissue.position[0].x() += 0.0;
    tick(scene, sample, kDt, world);
  }
  if (!world.alarm) {  // nothing moved it yet: the hand goes there
    for (int i = 0; i < 500 && !world.alarm; ++i) {
      tick(scene, read_at(hand, i, kAside), kDt, world);
    }
  }
  REQUIRE(world.alarm);
  CHECK(world.alarm_body == 1);
  const Vec3Array stands = world.bodies[0].tissue.position;
  for (int i = 0; i < 30; ++i) tick(scene, hand.read(0.2), kDt, world);
  CHECK(world.bodies[0].tissue.position == stands);
  CHECK(world.instruments[0].last_force == Vec3::Zero());
}

TEST_CASE("a hand that begins in any body has no tool until it is out of all") {
  const Scene scene = make_scene_of({make_body(), make_body(kAside)});
  World world(scene);
  HapticSample sample;
  sample.position = kAside;
  for (int i = 0; i < 5; ++i) CHECK(tick(scene, sample, kDt, world).force == Vec3::Zero());
  CHECK_FALSE(world.instruments[0].tool.placed);
  sample.position = {0.05, 0.0, 0.0};
  tick(scene, sample, kDt, world);
  CHECK(world.instruments[0].tool.placed);
}

TEST_CASE("samples or commands for another number of instruments are an alarm") {
  const Scene scene = make_scene_of({make_body()}, 2);
  std::array<HapticSample, 3> samples;
  std::array<HapticCommand, 3> commands;
  for (const auto& [given, taken] : {std::pair(1, 2), {3, 2}, {2, 1}, {2, 3}}) {
    World world(scene);
    for (HapticCommand& command : commands) command.force.setConstant(1.0);
    tick(scene, std::span(samples).first(static_cast<std::size_t>(given)), kDt, world,
         std::span(commands).first(static_cast<std::size_t>(taken)));
    CHECK(world.alarm.kind == AlarmKind::invalid_input);
    CHECK(world.alarm.index == static_cast<int>(TickInput::samples));
    CHECK(world.alarm.value == (given == 2 ? taken : given));
    CHECK(commands[0].force == Vec3::Zero());
  }
}

TEST_CASE("a copied world of several bodies goes on with the same bits, apart from the first") {
  const Scene scene = make_scene_of({make_body(), make_body(kAside, 3.0)}, 2);
  World world(scene);
  ScriptedDevice hand = press_script(0.005, 0.4, true);
  std::array<HapticCommand, 2> commands;
  const auto go = [&](World& moved, int from, int to) {
    for (int i = from; i < to; ++i) {
      tick(scene, std::array{read_at(hand, i), read_at(hand, i, kAside)}, kDt, moved, commands);
    }
  };
  go(world, 0, 200);
  World copy = world;
  go(copy, 200, 400);
  const auto expected = compute_hash(copy);
  go(world, 200, 400);
  CHECK(compute_hash(world) == expected);
  go(world, 0, 1);
  CHECK(compute_hash(copy) == expected);
}

TEST_CASE("ticks of two bodies and two tools allocate nothing and take no lock") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  const Scene scene = make_scene_of({make_body(), make_body(kAside, 20.0)}, 2);
  World world(scene);
  ScriptedDevice hand = press_script(0.005, 0.4, true);
  std::array<HapticCommand, 2> commands;
  const Calls before = count_calls_of_this_thread();
  for (int i = 0; i < 1000; ++i) {
    tick(scene, std::array{read_at(hand, i % 400), read_at(hand, i % 400, kAside)}, kDt, world,
         commands);
    compute_hash(world);
  }
  const Calls after = count_calls_of_this_thread();
  CHECK_FALSE(world.alarm);
  CHECK(after.allocations == before.allocations);
  CHECK(after.locks == before.locks);
}

TEST_CASE("a refused scene of several bodies says which body or instrument") {
  Scene scene;
  scene.bodies = {make_body(), make_body(kAside)};
  scene.instruments.resize(2);
  Scene spoilt = scene;
  spoilt.bodies[1].force_error = -1.0;
  CHECK(refusal(spoilt).starts_with("scene: bodies[1].force_error [N]: got -1"));
  spoilt = scene;
  spoilt.instruments[1].tool.radius = 0.0;
  CHECK(refusal(spoilt).starts_with("scene: instruments[1].tool.radius [m]: got 0"));
  spoilt = scene;
  spoilt.bodies[1].tissue.mass[0] = -1.0;
  CHECK(refusal(spoilt).starts_with("scene: bodies[1]."));
  spoilt = scene;
  spoilt.bodies.clear();
  CHECK(refusal(spoilt).starts_with("scene: bodies: got 0, expected at least one"));
  spoilt = scene;
  spoilt.instruments.clear();
  CHECK(refusal(spoilt).starts_with("scene: instruments: got 0, expected at least one"));
}

TEST_CASE("an alarm of one body leaves every other where it was, at most a tick of motion off") {
  for (const Kernel kernel : {Kernel::packed, Kernel::reference}) {
    if (kernel == Kernel::packed && simd_targets().empty()) continue;
    SoftBody sound = make_body(kAside), wild = make_body();
    wild.kernel = Kernel::reference;
    sound.kernel = kernel;
    Scene scene;
    scene.bodies = {wild, sound};
    scene.gravity = {0.0, 0.0, -9.81};
    const Scene two = build_scene(std::move(scene));
    World world(two);
    world.recovers = false;
    HapticSample away;
    away.position = {0.0, 0.0, 0.2};
    Vec3Array earlier;
    for (int i = 0; i < 30; ++i) {
      earlier = world.bodies[1].tissue.position;
      tick(two, away, kDt, world);
    }
    const Vec3Array before = world.bodies[1].tissue.position;
    const double moved = scenes::max_difference(before, two.bodies[1].tissue.rest_position);
    const double step = scenes::max_difference(before, earlier);
    REQUIRE(moved > 0.0);
    world.bodies[0].tissue.velocity.back().x() = std::numeric_limits<double>::quiet_NaN();

    tick(two, away, kDt, world);

    REQUIRE(world.alarm);
    REQUIRE(world.alarm_body == 0);
    const double off = scenes::max_difference(world.bodies[1].tissue.position, before);
    CHECK(off <= (kernel == Kernel::packed ? 0.0 : 2.0 * step));
  }
}

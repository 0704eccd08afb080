// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "calls.h"
#include "core/tick/safeguard_scenes.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/safeguard.h"
#include "scenes/linear_solids.h"
#include "scenes/tissues.h"
#include "skip.h"

// Between an alarm and the freeze [motion: ladder].

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr double kCalm = 1.0, kLongestCalm = 16.0;  // [s]

}  // namespace

TEST_CASE("steps that are too long are halved, or halved again, and nothing ends the run") {
  struct Case {
    double times;
    Safeguard expected;
  };
  for (const auto& [times, expected] :
       {Case{0.98, Safeguard::none}, Case{1.5, Safeguard::half_steps},
        Case{2.5, Safeguard::quarter_steps}}) {
    CAPTURE(times);
    const Scene scene = make_coarse(times, 32, Kernel::reference);
    World world = make_struck(scene), alone = make_struck(scene);
    alone.recovers = false;

    const Course course = run(scene, world, 0.5);

    CHECK_FALSE(course.alarm);
    CHECK(course.highest() == expected);
    CHECK((expected == Safeguard::none) == !world.bodies[0].averted);
    CHECK((expected == Safeguard::none) == !run(scene, alone, 0.5).alarm);
    for (const Vec3& v : world.bodies[0].tissue.velocity) CHECK(v.norm() < 0.02);
  }
}

TEST_CASE("no more substeps are taken than the body may have, and then the run ends as it would") {
  Scene scene = make_coarse(8.0, 2, Kernel::reference);
  // so that implicit Euler is none of them
  scene.bodies[0].tissue.maxwell = {.ratio = 0.5, .time = 0.4};
  scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0;
  scene.rate = 1000.0;
  scene = build_scene(std::move(scene));
  scene.rate = 1.0 / (8.0 * stable_step(scene.bodies[0].tissue) / 0.9);
  scene.bodies[0].substeps = 1;
  scene.bodies[0].substeps_max = 2;
  World world = make_struck(scene), alone = make_struck(scene);
  alone.recovers = false;

  const Course course = run(scene, world, 0.5);
  run(scene, alone, 0.5);

  REQUIRE(course.alarm);
  REQUIRE(alone.alarm);
  CHECK(world.bodies[0].substeps <= 2);
  for (const Vec3& x : world.bodies[0].tissue.position) CHECK(x.allFinite());
}

TEST_CASE("what damps too hard for its steps is damped implicitly, in vector code too") {
  for (const Kernel kernel : {Kernel::reference, Kernel::packed}) {
    if (kernel == Kernel::packed && simd_targets().empty()) continue;
    CAPTURE(static_cast<int>(kernel));
    Scene scene = press_scene();
    scene.bodies[0].kernel = kernel;
    for (double& c : scene.bodies[0].tissue.springs.damping) c = 2.0;
    scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0;
    scene = build_scene(std::move(scene));
    const int needed = scene.bodies[0].substeps;
    REQUIRE(needed > 8);
    scene.bodies[0].substeps = 3;
    scene.bodies[0].substeps_max = 4;
    World world(scene), alone(scene);
    alone.recovers = false;
    ScriptedDevice hand = press_script(0.002, 1.0), again = press_script(0.002, 1.0);
    double peak = 0.0;
    Safeguard highest = Safeguard::none;
    for (int i = 0; i < 1000; ++i) {
      const Vec3 force = tick(scene, hand.read(1e-3 * i), 1e-3, world).force;
      tick(scene, again.read(1e-3 * i), 1e-3, alone);
      peak = std::max(peak, force.norm());
      highest = std::max(highest, world.bodies[0].safeguard);
    }
    Scene fine = scene;
    fine.bodies[0].substeps = needed;
    fine.bodies[0].substeps_max = 2 * needed;
    World exact(fine);
    ScriptedDevice script = press_script(0.002, 1.0);
    double expected = 0.0;
    for (int i = 0; i < 1000; ++i) {
      expected = std::max(expected, tick(fine, script.read(1e-3 * i), 1e-3, exact).force.norm());
    }

    CHECK(alone.alarm);
    CHECK_FALSE(world.alarm);
    CHECK_FALSE(exact.alarm);
    CHECK(highest == Safeguard::implicit_damping);
    CHECK(peak == doctest::Approx(expected).epsilon(0.1));
  }
}

TEST_CASE("after a calm second the safeguard below is tried, later every time it was needed") {
  const Scene scene = make_coarse(1.5, 32, Kernel::reference);
  World world = make_struck(scene);

  const Course course = run(scene, world, 60.0);

  CHECK_FALSE(course.alarm);
  const auto first = std::ranges::find(course.levels, Safeguard::half_steps);
  REQUIRE(first != course.levels.end());
  const auto taken_back = std::find(first, course.levels.end(), Safeguard::none);
  const double calm = double(taken_back - first) / scene.rate;
  CHECK(calm == doctest::Approx(kCalm).epsilon(0.01));
  // 1, 2, 4, 8, 16, 16, 16 s
  CHECK(course.climbs() >= 2);
  CHECK(course.climbs() <= 2 + static_cast<int>(60.0 / kLongestCalm) + 3);
}

TEST_CASE("bodies have safeguards of their own") {
  Scene scene = press_scene();
  scene.bodies[0].kernel = Kernel::reference;
  SoftBody other = scene.bodies[0];
  for (Vec3& x : other.tissue.rest_position) x += Vec3(0.2, 0.0, 0.0);
  scene.bodies.push_back(other);
  scene = build_scene(std::move(scene));
  const double limit = stable_step(scene.bodies[0].tissue) / 0.9;
  scene.bodies[0].substeps = 1;
  scene.bodies[1].substeps = 4;
  scene.rate = 1.0 / (1.5 * limit);
  World world(scene);
  strike(world);

  const Course course = run(scene, world, 0.3);

  CHECK_FALSE(course.alarm);
  CHECK(course.highest() == Safeguard::half_steps);
  CHECK(world.bodies[1].safeguard == Safeguard::none);
  CHECK_FALSE(world.bodies[1].averted);
}

TEST_CASE("a tick that is taken back and done again is the same to the bit") {
  std::vector<Scene> built;
  for (const Kernel kernel : {Kernel::reference, Kernel::packed}) {
    Scene scene = press_scene();
    scene.bodies[0].kernel = kernel;
    scene.bodies[0].contact_modulus = kernel == Kernel::packed ? 5000.0 : 0.0;
    scene.bodies[0].tissue.pressure = 50.0;
    for (double& c : scene.bodies[0].tissue.springs.damping) c = 0.01;
    scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0;
    built.push_back(build_scene(std::move(scene)));
  }
  built.push_back(build_scene(make_scene(scenes::make_linear_organ(4, 0.5, 0.5))));
  for (std::size_t which = 0; which < built.size(); ++which) {
    CAPTURE(which);
    const Scene& scene = built[which];
    const double top =
        std::ranges::max_element(scene.bodies[0].tissue.rest_position, {}, [](const Vec3& x) {
          return x.z();
        })->z();
    Vec3 middle = Vec3::Zero();
    for (const Vec3& x : scene.bodies[0].tissue.rest_position) middle += x;
    middle /= double(scene.bodies[0].tissue.rest_position.size());
    World world(scene);
    const auto hand = [&](double height) {
      return hand_at({middle.x() + 1e-4, middle.y() + 2e-4, top + height});
    };
    for (int i = 0; i < 60; ++i) tick(scene, hand(0.006 - 1e-4 * i), 1e-3, world);
    for (int i = 0; i < 20; ++i) tick(scene, hand(0.0), 1e-3, world);
    REQUIRE(world.instruments[0].tool.touching);
    World once = world;
    const Vec3 expected = tick(scene, hand(0.0), 1e-3, once).force;

    tick(scene, hand(0.0), 1e-3, world);
    rewind(scene, world);
    const Vec3 again = tick(scene, hand(0.0), 1e-3, world).force;

    CHECK(expected.norm() > 1e-3);
    CHECK(again == expected);
    CHECK(compute_hash(world) == compute_hash(once));
    CHECK(world.bodies[0].guard.last_energy == once.bodies[0].guard.last_energy);
    for (int i = 0; i < 50; ++i) {
      REQUIRE(tick(scene, hand(1e-4 * i), 1e-3, world).force ==
              tick(scene, hand(1e-4 * i), 1e-3, once).force);
    }
  }
}

TEST_CASE("followed or not, a safeguard is taken in the same tick and forces are the same") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  const Scene scene = make_coarse(1.5, 32, Kernel::packed);
  World whole(scene), part(scene);
  part.follows_all = false;
  const double dt = 1.0 / scene.rate;
  bool climbed = false;
  for (int i = 0; i < 3000; ++i) {
    const double depth = i % 300 < 100 ? 0.003 * (i % 300) / 100.0 : 0.0;
    const Vec3 place(0.001, 0.002, i % 300 < 200 ? 0.0232 - depth : 0.05);
    const Vec3 force = tick(scene, hand_at(place), dt, whole).force;
    REQUIRE(tick(scene, hand_at(place), dt, part).force == force);
    REQUIRE(part.bodies[0].safeguard == whole.bodies[0].safeguard);
    climbed = climbed || whole.bodies[0].safeguard != Safeguard::none;
  }
  CHECK(climbed);
  CHECK_FALSE(whole.alarm);
  catch_up(scene, part);
  CHECK(compute_hash(part) == compute_hash(whole));
}

TEST_CASE(
    "climbing, stepping under safeguards up to implicit damping and coming down allocate nothing") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  for (const Kernel kernel : {Kernel::reference, Kernel::packed}) {
    if (kernel == Kernel::packed && simd_targets().empty()) continue;
    Scene scene = press_scene();
    scene.bodies[0].kernel = kernel;
    for (double& c : scene.bodies[0].tissue.springs.damping) c = 2.0;
    scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0;
    scene = build_scene(std::move(scene));
    scene.bodies[0].substeps = 3;
    scene.bodies[0].substeps_max = 7;
    World world(scene);
    ScriptedDevice hand = press_script(0.002, 0.5);
    std::array<long, 5> seen{};

    const Calls before = count_calls_of_this_thread();
    for (int i = 0; i < 3000; ++i) {
      tick(scene, hand.read(1e-3 * (i % 500)), 1e-3, world);
      ++seen[static_cast<std::size_t>(world.bodies[0].safeguard)];
    }
    const Calls after = count_calls_of_this_thread();

    CHECK(seen[3] > 100);
    CHECK(after.allocations == before.allocations);
    CHECK(after.locks == before.locks);
  }
}

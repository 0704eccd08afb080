// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "calls.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/private/packed_checkpoint.h"
#include "palpate/sim/tick/private/device_coupling.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "scenes/layers.h"
#include "scenes/thrown.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::scenes;

namespace {

constexpr double kDt = 1e-3;

/// A cube of 20 mm that nothing holds, and beside it one at `gap` [m] along x.
Scene make_cubes(double gap, bool may_touch = true) {
  Scene scene;
  scene.bodies.resize(2);
  for (std::size_t b = 0; b < 2; ++b) {
    scene.bodies[b].kernel = kernel_under_test();
    scene.bodies[b].tissue = make_soft_block({0.02, 0.02, 0.02}, {4, 4, 4}, 5e3,
                                             {b * (0.02 + gap), b * 0.001, b * 0.0015}, false);
    scene.bodies[b].tissue.drag = 0.0;
  }
  scene.instruments[0].tool.radius = 0.003;
  if (may_touch) scene.body_pairs.resize(1);
  return scene;
}

/// Throws a body.
Vec3 sum_momentum(const Scene& scene, const World& world, std::size_t b) {
  Vec3 sum = Vec3::Zero();
  const State& tissue = world.bodies[b].tissue;
  for (std::size_t i = 0; i < tissue.velocity.size(); ++i) {
    sum += scene.bodies[b].tissue.mass[i] * tissue.velocity[i];
  }
  return sum;
}

HapticSample far_away() {
  HapticSample sample;
  sample.position = {0.0, 0.0, 0.5};
  return sample;
}

std::string refusal(Scene scene) {
  try {
    build_scene(std::move(scene));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("S4: a thrown body hands its momentum to the one it meets, and neither gains energy") {
  const double tolerance = kernel_under_test() == Kernel::reference ? 1e-12 : 1e-5;
  for (const int substeps : {0, 24}) {
    CAPTURE(substeps);
    Scene cubes = make_cubes(0.002);
    cubes.bodies[1].substeps = substeps;  // a finer body meets a coarser one
    const Scene scene = build_scene(std::move(cubes));
    World world(scene);
    const Vec3 thrown(0.3, 0.0, 0.0);
    set_velocity(scene, 0, thrown, world);
    const double whole = sum_momentum(scene, world, 0).norm();
    const double energy = world.bodies[0].guard.start_energy;
    bool touched = false;
    for (int i = 0; i < 60; ++i) {
      tick(scene, far_away(), kDt, world);
      REQUIRE_FALSE(world.alarm);
      const Vec3 both = sum_momentum(scene, world, 0) + sum_momentum(scene, world, 1);
      REQUIRE((both - whole * Vec3::UnitX()).norm() < tolerance * whole);
      touched |= world.body_pairs[0].touching > 0;
      REQUIRE(world.body_pairs[0].least_gap > 0.0);
    }
    CHECK(touched);
    CHECK(sum_momentum(scene, world, 1).x() > 0.3 * whole);
    double kinetic = 0.0;
    for (const SoftState& body : world.bodies) kinetic += body.guard.last_energy;
    CHECK(kinetic <= 1.001 * energy);
    CHECK(count_inside(scene, world, 0, 1) == 0);
  }
}

TEST_CASE("what flies farther in a tick than bodies are looked at does not come through") {
  // near at the start of the tick or not, and still until then
  for (const double gap : {0.0007, 0.002, 0.006}) {
    for (const double speed : {1.0, 4.0, 8.0}) {
      CAPTURE(gap);
      CAPTURE(speed);
      const Scene scene = build_scene(make_thrown(gap));
      World world(scene), again(scene);
      for (int i = 0; i < 3; ++i) tick(scene, far_away(), kDt, world);
      world.bodies[0].asleep = false;
      set_velocity(scene, 0, {0.0, 0.1, -speed}, world);
      again = world;
      bool touched = false;
      int inside = 0;
      double least_gap = 1.0;
      for (int i = 0; i < 30; ++i) {
        tick(scene, far_away(), kDt, world);
        REQUIRE_FALSE(world.alarm);
        touched |= world.body_pairs[0].touching > 0;
        least_gap = std::min(least_gap, world.body_pairs[0].least_gap);
        inside =
            std::max({inside, count_inside(scene, world, 0, 1), count_inside(scene, world, 1, 0)});
        tick(scene, far_away(), kDt, again);
      }
      CHECK(touched);
      CHECK(least_gap > 0.0);
      CHECK(inside == 0);
      CHECK(sum_momentum(scene, world, 0).z() > 0.0);
      CHECK(compute_hash(again) == compute_hash(world));
    }
  }
}

TEST_CASE("two bodies that are apart tick as they would without a pair, to the bit") {
  Scene with = make_cubes(0.02), without = make_cubes(0.02, false);
  const Scene paired = build_scene(std::move(with)), alone = build_scene(std::move(without));
  World first(paired), second(alone);
  first.follows_all = second.follows_all = false;
  double felt = 0.0;
  for (int i = 0; i < 200; ++i) {
    HapticSample sample;
    sample.position = {0.0, 0.0, 0.014 - 1e-5 * i};
    const Vec3 force = tick(paired, sample, kDt, first).force;
    REQUIRE(force == tick(alone, sample, kDt, second).force);
    felt = std::max(felt, force.norm());
  }
  CHECK(felt > 0.0);
  CHECK_FALSE(first.body_pairs[0].near);
  catch_up(paired, first);
  catch_up(alone, second);
  for (std::size_t b = 0; b < 2; ++b) {
    CHECK(first.bodies[b].tissue.position == second.bodies[b].tissue.position);
  }
}

TEST_CASE(
    "bodies that touch tick alike again, from a copy, and with tissues that lag, to the bit") {
  Layers layers{.side = 0.04, .cells = {8, 8, 2}};
  const Scene scene = build_scene(make_layers(layers, 0.008));
  World one(scene), other(scene), copy(scene);
  other.follows_all = false;
  for (int i = 0; i < 300; ++i) {
    HapticSample sample;
    sample.position = {0.001, 0.002, 0.0165 - 3e-5 * std::min(i, 200)};
    const Vec3 force = tick(scene, sample, kDt, one).force;
    REQUIRE(force == tick(scene, sample, kDt, other).force);
    if (i == 150) copy = one;
    if (i > 150) REQUIRE(force == tick(scene, sample, kDt, copy).force);
  }
  CHECK(one.body_pairs[0].touching > 10);
  catch_up(scene, other);
  CHECK(compute_hash(one) == compute_hash(other));
  CHECK(compute_hash(one) == compute_hash(copy));
}

TEST_CASE("ticks in which bodies touch neither allocate nor lock") {
  SKIP_UNLESS(testing::calls_are_counted(), "calls cannot be counted under a sanitizer");
  Layers layers{.side = 0.04, .cells = {8, 8, 2}};
  const Scene scene = build_scene(make_layers(layers, 0.008));
  World world(scene);
  const testing::Calls before = testing::count_calls_of_this_thread();
  for (int i = 0; i < 200; ++i) {
    HapticSample sample;
    sample.position = {0.001, 0.002, 0.0165 - 3e-5 * i};
    tick(scene, sample, kDt, world);
  }
  const testing::Calls after = testing::count_calls_of_this_thread();
  CHECK(world.body_pairs[0].touching > 0);
  CHECK(after.allocations == before.allocations);
  CHECK(after.locks == before.locks);
}

TEST_CASE("a body that sleeps is woken by one that comes to touch it") {
  const Scene scene = build_scene(make_cubes(0.004));
  World world(scene);
  for (int i = 0; i < 2000 && !world.bodies[1].asleep; ++i) tick(scene, far_away(), kDt, world);
  REQUIRE(world.bodies[1].asleep);
  world.bodies[0].asleep = false;
  set_velocity(scene, 0, {0.2, 0.0, 0.0}, world);
  for (int i = 0; i < 60; ++i) tick(scene, far_away(), kDt, world);
  CHECK_FALSE(world.alarm);
  CHECK(sum_momentum(scene, world, 1).x() > 0.0);
}

TEST_CASE("what a pair cannot be is refused with where, what and why") {
  const auto with = [](auto change) {
    Scene scene = make_cubes(0.002);
    change(scene);
    return refusal(std::move(scene));
  };
  CHECK(says(with([](Scene& s) { s.body_pairs[0].second = 2; }),
             "scene: body_pairs[0]: got body 2, expected one of the 2 bodies"));
  CHECK(says(with([](Scene& s) { s.body_pairs[0].second = 0; }), "body 0 with itself"));
  CHECK(says(with([](Scene& s) {
               s.body_pairs.push_back({1, 0});
             }),
             "body_pairs[1]: got bodies 1 and 0 again"));
  CHECK(says(with([](Scene& s) { s.body_pairs[0].thickness = 0.01; }), "thickness [m]: got 0.01"));
  CHECK(
      says(with([](Scene& s) { s.body_pairs[0].stiffness = -1.0; }), "stiffness [N/m^3]: got -1"));
  CHECK(says(
      with([](Scene& s) { s.body_pairs[0].damping = std::numeric_limits<double>::quiet_NaN(); }),
      "damping [-]: got nan"));
  CHECK(says(with([](Scene& s) { s.body_pairs[0].friction = -0.1; }),
             "body_pairs[0].friction [-]: got -0.1, expected 0, or a positive number"));
  CHECK(says(with([](Scene& s) { s.bodies[1].force_error = 1e-3; }), "force_error"));
  CHECK(says(with([](Scene& s) { s.exchange_rate = 100.0; }), "exchange_rate"));
  CHECK(
      says(with([](Scene& s) {
             s.bodies[1].tissue = build_linear_solid(make_block({0.02, 0.02, 0.02}, {2, 2, 2}), {});
             s.bodies[1].kernel = Kernel::response;
           }),
           "a linear solid under its response"));
}

TEST_CASE("S7: bodies that begin in each other are refused, with how deep they are") {
  const std::string said = refusal(make_cubes(-0.001));
  CHECK(says(said, "scene: body_pairs[0]: got vertex "));
  CHECK(says(said, " 1 mm inside of body "));
  CHECK(says(said, "move one of them"));
  CHECK(says(refusal(make_cubes(1e-4)), " 0.1 mm from body "));
}

TEST_CASE("a body that may fold has a pair with itself, once however often it is built") {
  Scene scene = make_cubes(0.002);
  scene.bodies[1].may_fold = true;
  const Scene built = build_scene(build_scene(scene));
  REQUIRE(built.body_pairs.size() == 2);
  CHECK(built.body_pairs[1].first == 1);
  CHECK(built.body_pairs[1].second == 1);
  CHECK(built.body_pairs[1].stiffness > 0.0);
}

TEST_CASE("organs under a skin touch by their skins, momentum and bits as those of bare ones") {
  Scene scene;
  scene.bodies.resize(2);
  for (std::size_t b = 0; b < 2; ++b) {
    TissueModel& tissue = scene.bodies[b].tissue;
    tissue = make_covered_organ(5, 0.9);
    scene.bodies[b].kernel = kernel_under_test();
    scene.bodies[b].contact_modulus = 6e3;
    if (b == 1) tissue.fixed.clear();
    for (Vec3& x : tissue.rest_position) x.z() += b * 0.0545;
  }
  scene.body_pairs.resize(1);
  scene = build_scene(std::move(scene));
  World one(scene), other(scene);
  other.follows_all = false;
  double least = 1.0;
  Vec3 pushed = Vec3::Zero();
  for (int i = 0; i < 300; ++i) {
    HapticSample sample;
    sample.position = {0.0, 0.0, 0.0855 - 5e-5 * std::min(i, 200)};
    const Vec3 before = sum_momentum(scene, one, 1);
    const Vec3 force = tick(scene, sample, kDt, one).force;
    REQUIRE(force == tick(scene, sample, kDt, other).force);
    REQUIRE_FALSE(one.alarm);
    least = std::min(least, one.body_pairs[0].least_gap);
    // what the upper one gains is of the tool and of the lower one
    const Vec3 gained = (sum_momentum(scene, one, 1) - before) / kDt;
    pushed = gained + force - one.body_pairs[0].force;
    REQUIRE(pushed.norm() < 1e-3 + 0.1 * force.norm());
  }
  CHECK(one.body_pairs[0].touching > 3);
  CHECK(least > 0.0);
  CHECK(one.body_pairs[0].force.z() > 0.02);
  CHECK(compute_hash(one) == compute_hash(other));
}

TEST_CASE("a hand presses a body no harder into another than the barrier between them bears") {
  const Layers layers{.side = 0.04, .cells = {8, 8, 2}, .lower_modulus = 2e4};
  Scene made = make_layers(layers, 0.006);
  made.instruments[0].coupling.force_max = 0.2;  // of which a fiftieth is always left
  const Scene scene = build_scene(std::move(made));
  World world(scene);
  push_layers(scene, layers, 0.001, 0.02, 0.05, world);
  const double force = world.instruments[0].last_force.norm();
  const double& bearable = workspace(world).hands[0].bearable;
  BodyPairState& pair = world.body_pairs[0];
  REQUIRE(force > 0.01);
  pair.touching = 1;
  pair.least_gap = 0.5 * scene.body_pairs[0].thickness;
  limit_hand(scene, 0, kDt, world);
  CHECK(std::isinf(bearable));
  // half of the reserve is left, of which F falls by 100/s
  pair.least_gap = -0.1 * scene.body_pairs[0].thickness;
  limit_hand(scene, 0, kDt, world);
  CHECK(bearable == doctest::Approx(0.95 * force));
  // none is left, nor less than none
  pair.least_gap = -2.0 * scene.body_pairs[0].thickness;
  limit_hand(scene, 0, kDt, world);
  CHECK(bearable == doctest::Approx(0.9 * 0.95 * force));
  // what does not touch holds nobody back, and a hand that has eased may push again
  pair.touching = 0;
  for (int i = 0; i < 2000; ++i) limit_hand(scene, 0, kDt, world);
  CHECK(bearable > 0.95 * force);
}

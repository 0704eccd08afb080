// SPDX-License-Identifier: BSD-3-Clause
// Worlds of bodies that rub on each other.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "calls.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/private/packed_checkpoint.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/safeguard.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "scenes/layers.h"
#include "scenes/thrown.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::scenes;

namespace {

constexpr double kDt = 1e-3;

/// Nothing but what it touches holds the thrown body.
Scene make_free(double gap, double friction) {
  Scene scene = make_thrown(gap, friction);
  scene.gravity = Vec3::Zero();
  return scene;
}

void throw_body(const Scene& scene, const Vec3& velocity, World& world) {
  world.bodies[0].asleep = false;
  set_velocity(scene, 0, velocity, world);
}

HapticSample away() {
  HapticSample sample;
  sample.position = {0.0, 0.0, 0.5};
  return sample;
}

Vec3 mean_velocity(const Scene& scene, const World& world, std::size_t b) {
  Vec3 sum = Vec3::Zero();
  double mass = 0.0;
  const State& tissue = world.bodies[b].tissue;
  for (std::size_t i = 0; i < tissue.velocity.size(); ++i) {
    sum += scene.bodies[b].tissue.mass[i] * tissue.velocity[i];
    mass += scene.bodies[b].tissue.mass[i];
  }
  return sum / mass;
}

/// The bristles of a pair that hold, point by point, each with where it is drawn to.
struct Holding {
  std::size_t place;
  Vec3 stretch, offset;
  bool operator==(const Holding& other) const = default;
};
std::vector<Holding> list_holding(World& world) {
  std::vector<Holding> holding;
  for (const SurfaceContacts& side : workspace(world).contacts[0].sides) {
    const PointBristles& bristles = side.bristles;
    for (std::size_t p = 0; p < bristles.points.size(); ++p) {
      const PointBristle& bristle = bristles.points[p];
      if (bristle.substep != bristles.substep) continue;
      holding.push_back({p, bristle.stretch, bristle.offset});
    }
  }
  return holding;
}

/// The upper of two layers is drawn sideways by a tip that is pressed into it.
HapticSample drag(int i) {
  HapticSample sample;
  const double pressed = 3e-5 * std::min(i, 150), along = 3e-5 * std::max(0, i - 150);
  sample.position = {0.001 + along, 0.002, 0.0165 - pressed};
  return sample;
}
Scene make_dragged(double friction) {
  Scene scene = make_layers({.side = 0.04, .cells = {8, 8, 2}}, 0.008, {.friction = friction});
  scene.instruments[0].tool.friction = 0.8;
  return build_scene(std::move(scene));
}

}  // namespace

TEST_CASE("what is thrown along another body is braked by mu times the impulse that presses") {
  // down at 0.1 m/s it comes back up: the impulse along is mu of the one across
  for (const int substeps : {0, 24}) {
    CAPTURE(substeps);
    Scene made = make_free(7e-4, 0.2);
    made.bodies[0].substeps = substeps;  // a finer body meets a coarser one
    const Scene scene = build_scene(std::move(made));
    World world(scene);
    throw_body(scene, {1.0, 0.0, -0.1}, world);
    double energy = world.bodies[0].guard.start_energy;
    for (int i = 0; i < 60; ++i) {
      tick(scene, away(), kDt, world);
      REQUIRE_FALSE(world.alarm);
      double now = 0.0;
      for (const SoftState& body : world.bodies) now += body.guard.last_energy;
      REQUIRE(now <= 1.001 * energy);
      if (mean_velocity(scene, world, 0).z() > 0.01 && world.body_pairs[0].touching == 0) break;
    }
    const Vec3 left = mean_velocity(scene, world, 0);
    REQUIRE(left.z() > 0.01);
    CHECK(1.0 - left.x() == doctest::Approx(0.2 * (0.1 + left.z())).epsilon(0.05));
    CHECK(std::abs(left.y()) < 0.1 * (1.0 - left.x()));
  }
}

TEST_CASE("bodies that rub tick alike again, from a copy, and with tissues that lag, to the bit") {
  const Scene scene = make_dragged(0.3), smooth = make_dragged(0.0);
  World one(scene), other(scene), copy(scene), sliding(smooth);
  other.follows_all = false;
  for (int i = 0; i < 300; ++i) {
    const Vec3 force = tick(scene, drag(i), kDt, one).force;
    REQUIRE(force == tick(scene, drag(i), kDt, other).force);
    tick(smooth, drag(i), kDt, sliding);
    if (i == 180) copy = one;
    if (i > 180) REQUIRE(force == tick(scene, drag(i), kDt, copy).force);
  }
  CHECK_FALSE(one.alarm);
  CHECK(one.body_pairs[0].touching > 10);
  catch_up(scene, other);
  CHECK(compute_hash(one) == compute_hash(other));
  CHECK(compute_hash(one) == compute_hash(copy));
  CHECK(compute_hash(one) != compute_hash(sliding));
  // and otherwise than where they slide
  const Vec3 &rubs = one.body_pairs[0].force, &slides = sliding.body_pairs[0].force;
  CHECK((rubs - slides).head<2>().norm() > 0.1 * rubs.z());
}

TEST_CASE("a tick that is taken back takes back where bodies stick") {
  const Scene scene = make_dragged(0.3);
  World world(scene);
  for (int i = 0; i < 200; ++i) tick(scene, drag(i), kDt, world);
  const std::vector<Holding> before = list_holding(world);
  REQUIRE(before.size() > 10);
  const World as_it_was = world;
  tick(scene, drag(200), kDt, world);
  CHECK(list_holding(world) != before);
  rewind(scene, world);
  CHECK(list_holding(world) == before);
}

TEST_CASE("what flies along another body farther than bodies are looked at is braked alike again") {
  for (const double speed : {1.0, 4.0}) {
    CAPTURE(speed);
    const Scene scene = build_scene(make_free(7e-4, 0.5));
    World world(scene), again(scene);
    for (int i = 0; i < 3; ++i) tick(scene, away(), kDt, world);
    throw_body(scene, {1.0, 0.1, -speed}, world);
    again = world;
    for (int i = 0; i < 30; ++i) {
      tick(scene, away(), kDt, world);
      REQUIRE_FALSE(world.alarm);
      tick(scene, away(), kDt, again);
    }
    CHECK(mean_velocity(scene, world, 0).x() < 0.8);
    CHECK(compute_hash(again) == compute_hash(world));
  }
}

TEST_CASE("a body that another stops within a step gives it the energy that it had") {
  for (const double friction : {0.0, 0.3}) {
    const Scene scene = build_scene(make_free(7e-4, friction));
    for (const double speed : {0.5, 1.0, 2.0, 4.0}) {
      for (const double aside : {0.0, 0.5, 1.0, 2.0}) {
        CAPTURE(friction);
        CAPTURE(speed);
        CAPTURE(aside);
        World world(scene);
        for (int i = 0; i < 3; ++i) tick(scene, away(), kDt, world);
        throw_body(scene, {aside, 0.1, -speed}, world);
        for (int i = 0; i < 40 && !world.alarm; ++i) tick(scene, away(), kDt, world);
        CHECK_FALSE(world.alarm);
        CHECK(world.bodies[0].safeguard == Safeguard::none);
      }
    }
  }
}

TEST_CASE("a pair whose friction is 0 ticks as one of which nothing was said, to the bit") {
  const Scene said = make_dragged(0.0);
  const Scene scene = build_scene([] {
    Scene made = make_layers({.side = 0.04, .cells = {8, 8, 2}}, 0.008);
    made.instruments[0].tool.friction = 0.8;
    return made;
  }());
  World one(said), other(scene);
  for (int i = 0; i < 200; ++i) {
    REQUIRE(tick(said, drag(i), kDt, one).force == tick(scene, drag(i), kDt, other).force);
  }
  CHECK(compute_hash(one) == compute_hash(other));
}

TEST_CASE("organs under a skin rub by their skins, and ticks are the same bits again") {
  Scene scene;
  scene.bodies.resize(2);
  for (std::size_t b = 0; b < 2; ++b) {
    TissueModel& tissue = scene.bodies[b].tissue;
    tissue = make_covered_organ(5, 0.9);
    scene.bodies[b].kernel = kernel_under_test();
    if (b == 1) tissue.fixed.clear();
    for (Vec3& x : tissue.rest_position) x.z() += b * 0.0545;
  }
  scene.instruments[0].tool.friction = 0.8;
  const auto run = [&](double friction, bool follows_all) {
    Scene made = scene;
    made.body_pairs = {{.friction = friction}};
    const Scene built = build_scene(std::move(made));
    World world(built);
    world.follows_all = follows_all;
    for (int i = 0; i < 300; ++i) {
      HapticSample sample;
      sample.position = {2e-5 * std::max(0, i - 200), 0.0, 0.0855 - 5e-5 * std::min(i, 200)};
      tick(built, sample, kDt, world);
    }
    CHECK_FALSE(world.alarm);
    CHECK(world.body_pairs[0].touching > 3);
    CHECK(world.body_pairs[0].least_gap > 0.0);
    catch_up(built, world);
    return std::pair(compute_hash(world), world.body_pairs[0].force);
  };
  const auto rubs = run(0.3, true), slides = run(0.0, true);
  CHECK(rubs.first == run(0.3, false).first);
  CHECK(rubs.first != slides.first);
  CHECK(rubs.second.x() < slides.second.x());
}

TEST_CASE("ticks in which bodies rub neither allocate nor lock") {
  SKIP_UNLESS(testing::calls_are_counted(), "calls cannot be counted under a sanitizer");
  const Scene scene = make_dragged(0.3);
  World world(scene);
  const testing::Calls before = testing::count_calls_of_this_thread();
  for (int i = 0; i < 200; ++i) tick(scene, drag(i), kDt, world);
  const testing::Calls after = testing::count_calls_of_this_thread();
  CHECK(world.body_pairs[0].touching > 0);
  CHECK(after.allocations == before.allocations);
  CHECK(after.locks == before.locks);
}

// SPDX-License-Identifier: BSD-3-Clause
// A soft block on a soft layer that is tilted.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "palpate/sim/tick/tick.h"
#include "scenes/layers.h"

using namespace palpate;
using namespace palpate::scenes;

namespace {

constexpr double kDt = 1e-3, kFriction = 0.2;

/// A block of 20 x 20 x 8 mm, 10 kPa, half a millimetre above a layer of 70 x 40 x 5 mm, 20 kPa,
/// whose foot is held. Gravity is that on a slope of the layer, along x.
Scene make_slope(double slope, double friction) {
  Scene scene;
  scene.bodies.resize(2);
  for (SoftBody& body : scene.bodies) body.kernel = kernel_under_test();
  scene.bodies[0].tissue =
      make_soft_block({0.07, 0.04, 0.005}, {24, 14, 2}, 2e4, Vec3::Zero(), false);
  for (int i = 0; i < particle_count(scene.bodies[0].tissue); ++i) {
    const Vec3& x = scene.bodies[0].tissue.rest_position[static_cast<std::size_t>(i)];
    if (x.z() < -0.0024) scene.bodies[0].tissue.fixed.push_back(i);
  }
  scene.bodies[1].tissue = make_soft_block({0.02, 0.02, 0.008}, {7, 7, 3}, 1e4,
                                           {-0.0203, 0.0007, 0.0065 + 4.5e-4}, false);
  scene.bodies[1].tissue.drag = 0.0;
  scene.gravity = 9.81 * Vec3(slope, 0.0, -1.0).normalized();
  scene.body_pairs = {{.friction = friction}};
  return scene;
}

/// [m] Where the block is along the slope.
double find_place(const World& world) {
  double sum = 0.0;
  const Vec3Array& x = world.bodies[1].tissue.position;
  for (const Vec3& each : x) sum += each.x();
  return sum / static_cast<double>(x.size());
}

/// Ticks for so long [s]; false where there was an alarm.
bool run(const Scene& scene, double seconds, World& world) {
  HapticSample sample;
  sample.position = {0.0, 0.0, 0.5};
  const int ticks = static_cast<int>(std::lround(seconds / kDt));
  for (int i = 0; i < ticks && !world.alarm; ++i) tick(scene, sample, kDt, world);
  return !world.alarm;
}

/// [m] By which a block that has come to rest goes on in so long [s].
double measure_creep(double slope, double seconds) {
  const Scene scene = build_scene(make_slope(slope, kFriction));
  World world(scene);
  REQUIRE(run(scene, 1.0, world));
  const double before = find_place(world);
  REQUIRE(run(scene, seconds, world));
  CHECK(world.body_pairs[0].touching > 50);
  return find_place(world) - before;
}

}  // namespace

TEST_CASE("a block rests on a slope of 0.9 mu, and does not creep") {
  const double creep = measure_creep(0.9 * kFriction, 0.5);
  MESSAGE("creep [m]: ", creep);
  CHECK(std::abs(creep) < 1e-6);
}

TEST_CASE("a block that rests on a slope creeps by less than a micrometre in 10 s" *
          doctest::test_suite("verify")) {
  const double creep = measure_creep(0.9 * kFriction, 10.0);
  MESSAGE("creep [m]: ", creep);
  CHECK(std::abs(creep) < 1e-6);
}

TEST_CASE(
    "a block slides down a slope of 1.1 mu as a rigid one would, under mu times what presses") {
  const double slope = 1.1 * kFriction;
  const Scene scene = build_scene(make_slope(slope, kFriction));
  World world(scene);
  REQUIRE(run(scene, 0.2, world));
  const double start = find_place(world);
  REQUIRE(run(scene, 0.1, world));
  const double middle = find_place(world);
  double along = 0.0, across = 0.0, worst = 0.0;
  for (int i = 0; i < 100; ++i) {
    REQUIRE(run(scene, kDt, world));
    const Vec3& force = world.body_pairs[0].force;
    along -= force.x();
    across += force.z();
    worst = std::max(worst, std::abs(-force.x() / force.z() - kFriction));
  }
  const double end = find_place(world);
  CHECK(along / across == doctest::Approx(kFriction).epsilon(0.02));
  CHECK(worst < 0.1 * kFriction);
  // s'' = g (sin - mu cos), of which two spans of 0.1 s tell
  const double expected = 9.81 * (slope - kFriction) / std::hypot(1.0, slope);
  const double found = ((end - middle) - (middle - start)) / 0.01;
  MESSAGE("acceleration [m/s2]: ", found, " expected ", expected, "; force ", along / across);
  CHECK(found == doctest::Approx(expected).epsilon(0.2));
}

TEST_CASE("without friction a block slides down every slope") {
  const Scene scene = build_scene(make_slope(0.02, 0.0));
  World world(scene);
  REQUIRE(run(scene, 0.2, world));
  const double start = find_place(world);
  REQUIRE(run(scene, 0.1, world));
  const double middle = find_place(world);
  REQUIRE(run(scene, 0.1, world));
  CHECK((find_place(world) - middle) - (middle - start) ==
        doctest::Approx(9.81 * 0.02 * 0.01).epsilon(0.1));
}

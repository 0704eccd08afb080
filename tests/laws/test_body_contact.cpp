// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/tick/tick.h"
#include "scenes/layers.h"

using namespace palpate;
using namespace palpate::scenes;

namespace {

constexpr double kDt = 1e-3;

/// Two layers of 5 mm, 60 mm wide.
constexpr Layers kLayers{.side = 0.06, .cells = {14, 14, 2}};

Pushed push(const Layers& layers, double radius, double depth, const BodyPair& pair = {},
            double rest = 0.2) {
  const Scene scene = build_scene(make_layers(layers, radius, pair));
  World world(scene);
  Pushed pushed = push_layers(scene, layers, depth, 0.04, rest, world);
  pushed.inside = count_inside(scene, world, 0, 1) + count_inside(scene, world, 1, 0);
  return pushed;
}

}  // namespace

TEST_CASE("S1: two layers that a ball pushes down keep apart, whatever the ball's size") {
  for (const double radius : {0.003, 0.008}) {
    CAPTURE(radius);
    const Pushed pushed = push(kLayers, radius, 0.012);
    CHECK_FALSE(pushed.alarm);
    CHECK(pushed.most_touching > 20);
    CHECK(pushed.least_gap > 0.0);
    CHECK(pushed.inside == 0);
    CHECK(pushed.force > 0.05);
  }
}

TEST_CASE("S1: layers of which one is ten times as stiff keep apart, whichever it is" *
          doctest::test_suite("landing")) {
  for (const double lower : {5e3, 5e4}) {
    CAPTURE(lower);
    Layers layers = kLayers;
    layers.lower_modulus = lower;
    layers.upper_modulus = 5.5e4 - lower;
    const Pushed pushed = push(layers, 0.003, 0.010);
    CHECK_FALSE(pushed.alarm);
    CHECK(pushed.least_gap > 0.0);
    CHECK(pushed.inside == 0);
  }
}

TEST_CASE("a barrier that is too soft is pushed through, as is foretold") {
  // it holds 9 k_A tau at the floor and 19 k_A tau on the surface: 0.2 mm of 4e4 N/m³ hold 72 Pa
  // and 152, a thirtieth of what the ball presses with
  const Pushed pushed = push(kLayers, 0.003, 0.012, {.thickness = 2e-4, .stiffness = 4e4});
  CHECK(pushed.least_gap < 0.0);
  CHECK(pushed.inside > 0);
}

TEST_CASE("S5: a body that is flicked against another at 1 m/s does not come through") {
  Scene cubes;
  cubes.bodies.resize(2);
  for (std::size_t b = 0; b < 2; ++b) {
    cubes.bodies[b].kernel = kernel_under_test();
    cubes.bodies[b].tissue = make_soft_block({0.02, 0.02, 0.02}, {5, 5, 5}, 5e3,
                                             {b * 0.023, b * 0.001, b * 0.0015}, b == 1);
  }
  cubes.instruments[0].tool.radius = 0.004;
  cubes.body_pairs.resize(1);
  const Scene scene = build_scene(std::move(cubes));
  World world(scene);
  HapticSample sample;
  int most = 0;
  for (int i = 0; i < 60; ++i) {
    sample.position = {-0.0145 + std::min(0.012, 1e-3 * i), 0.001, 0.002};
    tick(scene, sample, kDt, world);
    REQUIRE_FALSE(world.alarm);
    most = std::max(most, world.body_pairs[0].touching);
    REQUIRE(world.body_pairs[0].least_gap > -1e-4);
  }
  CHECK(most > 10);
  CHECK(count_inside(scene, world, 0, 1) == 0);
  CHECK(count_inside(scene, world, 1, 0) == 0);
}

TEST_CASE("bodies of every law touch, under every kernel that they have" *
          doctest::test_suite("landing")) {
  for (const Integrator integrator :
       {Integrator::symplectic_euler, Integrator::implicit_euler, Integrator::xpbd}) {
    CAPTURE(integrator);
    Layers layers{.side = 0.04, .cells = {8, 8, 2}};
    Scene scene = make_layers(layers, 0.008);
    scene.bodies[0].integrator = integrator;
    if (integrator != Integrator::symplectic_euler) scene.bodies[0].kernel = Kernel::reference;
    scene = build_scene(std::move(scene));
    World world(scene);
    const Pushed pushed = push_layers(scene, layers, 0.004, 0.04, 0.05, world);
    CHECK_FALSE(pushed.alarm);
    CHECK(pushed.most_touching > 5);
    CHECK(pushed.least_gap > 0.0);
  }
}

namespace {

/// Where a hand is that turns the end of a strip over onto its other half, from below its end.
Vec3 fold_over(double t, double radius) {
  constexpr double kArm = 0.028, kHinge = 0.008;  // [m]
  const double below = 0.0015 + radius;
  const double angle = std::numbers::pi * std::clamp(t - 0.2, 0.0, 1.0);
  const double height = t < 0.2 ? -below + 0.002 * (t / 0.1 - 1.0) : -below + 0.001;
  const double arm = std::hypot(kArm, height), start = std::atan2(height, kArm);
  const double down = 0.006 * std::clamp((t - 1.2) / 0.3, 0.0, 1.0);
  return {kHinge + arm * std::cos(start + angle), 0.0005,
          arm * std::sin(start + angle) - down + 0.006 * std::sin(0.5 * angle)};
}

}  // namespace

TEST_CASE("S6: a strip that is folded over comes to lie on itself, and not in itself") {
  constexpr double kRadius = 0.003;
  double friction = 0.0;
  SUBCASE("and slides") {}
  SUBCASE("and rubs") { friction = 0.5; }
  Scene strip;
  SoftBody& body = strip.bodies[0];
  body.kernel = kernel_under_test();
  body.tissue = make_soft_block({0.08, 0.016, 0.003}, {32, 6, 1}, 5e3, Vec3::Zero(), false);
  for (int i = 0; i < particle_count(body.tissue); ++i) {
    if (body.tissue.rest_position[static_cast<std::size_t>(i)].x() < 0.0) {
      body.tissue.fixed.push_back(i);
    }
  }
  body.may_fold = true;
  if (friction > 0.0) strip.body_pairs = {{.first = 0, .second = 0, .friction = friction}};
  strip.instruments[0].tool.radius = kRadius;
  const Scene scene = build_scene(std::move(strip));
  World world(scene);
  HapticSample sample;
  double least = 1.0;
  int most = 0;
  bool held = false;
  for (int i = 0; i < 1700; ++i) {
    sample.time = i * kDt;
    sample.position = fold_over(sample.time, kRadius);
    held = held || world.instruments[0].tool.touching;
    sample.buttons = held ? kAttachButton : 0;
    tick(scene, sample, kDt, world);
    REQUIRE_FALSE(world.alarm);
    // nothing touches before it is turned over
    if (sample.time < 0.7) REQUIRE(world.body_pairs[0].touching == 0);
    least = std::min(least, world.body_pairs[0].least_gap);
    most = std::max(most, world.body_pairs[0].touching);
  }
  CHECK(world.instruments[0].tool.hold_count > 0);
  CHECK(most >= 2);
  CHECK(least > 0.0);
}

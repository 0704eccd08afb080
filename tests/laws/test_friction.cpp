// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/flicks.h"
#include "scenes/grasped.h"
#include "scenes/kernels.h"
#include "scenes/scenes.h"
#include "scenes/solids.h"
#include "scenes/tables.h"
#include "scenes/walls.h"

// T4, friction over time, through the tick the hand feels [contact: friction]: on a wall of springs
// by the hard law, and on a solid by its near field.

using namespace palpate;

namespace {

using scenes::hand_at;

constexpr double kTick = 1e-3;
constexpr double kRadius = 0.003;  ///< [m]

/// A flat wall of [contact: law] on home springs, 60 by 60 mm.
Scene make_flat_wall(double mu) {
  SurfaceOptions options;
  options.home_stiffness = 3e5;
  options.drag = 30.0;
  const Material wall{.density = 1000.0, .damping_ratio = 0.1, .wall_thickness = 0.002};
  Scene scene;
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.bodies[0].tissue =
      build_mass_spring(scenes::make_sheet(41, 41, 0.06), wall, 0.866 * 60.0, options);
  scene.instruments[0].tool = {.radius = kRadius, .stiffness = 3e7, .friction = mu};
  return build_scene(std::move(scene));
}

constexpr double kYoung = 5000.0, kPoisson = 0.45;
using Build = TissueModel (*)(const SolidMesh&, const Material&, const SolidOptions&);

/// A block of 5 kPa, 64 x 64 x 32 mm, cells of 8 mm, on a base that is held.
Scene make_solid_block(double mu, Build build = build_solid) {
  constexpr double kCell = 0.008;
  const SolidMesh solid = scenes::make_block({8 * kCell, 8 * kCell, 4 * kCell}, {8, 8, 4});
  SolidOptions options;
  options.nodal_share = 0.9;
  options.drag = 30.0;
  for (std::size_t i = 0; i < solid.vertices.size(); ++i) {
    if (solid.vertices[i].z() < -1.99 * kCell) options.fixed.push_back(static_cast<int>(i));
  }
  Material material = scenes::make_material({.damping_ratio = 0.3});
  material.young_modulus = kYoung;
  material.poisson_ratio = kPoisson;
  Scene scene;
  scene.bodies[0].tissue = build(solid, material, options);
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.bodies[0].contact_modulus = kYoung / (1.0 - kPoisson * kPoisson);
  scene.instruments[0].tool = {.radius = kRadius, .stiffness = 3e7, .friction = mu};
  return build_scene(std::move(scene));
}

constexpr double kPlate = 4e5;  ///< [Pa] Young's modulus

/// A clamped wall of prisms, 3 mm thick, 60 mm wide, edges of 5 mm.
Scene make_plate(double mu) {
  Scene scene;
  scene.bodies[0].tissue = scenes::make_round_plate(0.03, 0.005, 0.003, kPlate, kPoisson, 0.3);
  scene.bodies[0].tissue.drag = 30.0;
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.bodies[0].contact_modulus = kPlate / (1.0 - kPoisson * kPoisson);
  scene.instruments[0].tool = {.radius = kRadius, .stiffness = 3e7, .friction = mu};
  return build_scene(std::move(scene));
}

/// [m] The middle of the top of some points.
Vec3 find_top(std::span<const Vec3> points) {
  Vec3 low = Vec3::Constant(1.0), high = -low;
  for (const Vec3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return {0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), high.z()};
}

/// A hand over the middle of the top that goes down within 0.2 s, and then aside.
class Press {
 public:
  Press(const Scene& scene, double depth, double from = 0.0)
      : Press(scene, depth, from, find_top(scene.bodies[0].tissue.rest_position)) {}

  /// Over another place than the middle of the first body [m].
  Press(const Scene& scene, double depth, double from, const Vec3& top)
      : scene_(scene), world_(scene), depth_(depth), top_(top) {
    for (int i = 0; i < 400; ++i) {
      const double down = std::min(1.0, i / 200.0) * (depth_ + 0.001);
      put({from, 0.0, kRadius + 0.001 - down});
    }
  }

  /// [N] with the hand so far from the middle [m], along x and y.
  Vec3 slide(double x, double y = 0.0) { return put({x, y, kRadius - depth_}); }
  const World& world() const { return world_; }

 private:
  Vec3 put(const Vec3& hand) {
    const Vec3 force = tick(scene_, hand_at(top_ + hand), kTick, world_).force;
    if (world_.alarm) FAIL("alarm");
    return force;
  }

  const Scene& scene_;
  World world_;
  double depth_;
  Vec3 top_;
};

struct Slide {
  double ratio = 0.0;  ///< [-] mean of the pull along the patch over that along its normal
  double worst = 0.0;  ///< [-] how far one tick is from mu
  double plane = 0.0;  ///< [-] mean force along x over that along z
};

/// [-] Of the hand's pull at the end of a tick.
double measure_ratio(const Press& press) {
  const InstrumentState& instrument = press.world().instruments[0];
  const Vec3 pull = instrument.hand - instrument.tool.position;
  const double normal = instrument.tool.patch_normal.dot(pull);
  return (pull - normal * instrument.tool.patch_normal).norm() / std::abs(normal);
}

constexpr double kBefore = 0.006;  ///< [m] a tool slides before it is measured

/// At 20 mm/s over `path` [m] of what has the coefficient mu, from `from` [m] on: along the plane
/// what triangles do to either is gone from the means.
Slide measure_slide(Press& press, double mu, double from, double path) {
  constexpr double kSpeed = 0.02;
  Slide slide;
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (double x = 0.0; x < kBefore + path; x += kSpeed * kTick) {
    const Vec3 force = press.slide(from + x);
    if (x < kBefore) continue;
    const double ratio = mu > 0.0 ? measure_ratio(press) : 0.0;
    slide.ratio += ratio;
    slide.worst = std::max(slide.worst, std::abs(ratio - mu));
    sum += force;
    ++count;
  }
  slide.ratio /= count;
  slide.plane = -sum.x() / sum.z();
  return slide;
}

Slide measure_slide(const Scene& scene, double depth, double path) {
  const double from = -0.5 * (path + kBefore);
  Press press(scene, depth, from);
  return measure_slide(press, scene.instruments[0].tool.friction, from, path);
}

/// `tilted` is how far the plane's ratio may be from mu [-].
void check_slide(const Scene& scene, double depth, double path, double tilted = 0.04) {
  const double mu = scene.instruments[0].tool.friction;
  CAPTURE(mu);
  const Slide slide = measure_slide(scene, depth, path);
  CHECK(std::abs(slide.ratio - mu) < 0.01 * mu);
  CHECK(slide.worst < 0.05 * mu);
  // tissue that is dragged along is dented aslant
  CHECK(std::abs(slide.plane - mu) < tilted * mu);
}

/// [m] How far a tool creeps in `seconds` that a hand pulls it aside by nine tenths of mu N.
double measure_creep(const Scene& scene, double depth, double seconds) {
  Press press(scene, depth);
  const double K = scene.instruments[0].coupling.stiffness, mu = scene.instruments[0].tool.friction;
  double hand = 0.0;
  // the tissue comes along, so that the hand has to go farther than its spring is long
  for (int i = 0; i < 3000; ++i) {
    const Vec3 force = press.slide(hand);
    const double lacks = 0.9 * mu * force.z() + force.x();
    hand += std::clamp(0.01 * lacks / K, -2e-6, 2e-6);
  }
  const Vec3 begin = press.world().instruments[0].tool.position;
  for (int i = 0; i < std::lround(seconds / kTick); ++i) press.slide(hand);
  return (press.world().instruments[0].tool.position - begin).norm();
}

/// [J] by which a hand works that goes round a circle of 4 mm `laps` times, and what mu N times the
/// path of the tool is.
struct Work {
  double done = 0.0, friction = 0.0;
};

Work circle(const Scene& scene, double depth, int laps) {
  constexpr double kCircle = 0.004;
  constexpr int kTicks = 1000;
  Press press(scene, depth);
  for (int i = 0; i < 400; ++i) press.slide(kCircle * i / 400.0);
  Work work;
  Vec3 last(kCircle, 0.0, 0.0), tool = press.world().instruments[0].tool.position;
  for (int i = 1; i <= (laps + 1) * kTicks; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kTicks;
    const Vec3 at(kCircle * std::cos(angle), kCircle * std::sin(angle), 0.0);
    const Vec3 force = press.slide(at.x(), at.y());
    const Vec3 now = press.world().instruments[0].tool.position;
    if (i > kTicks) {  // the first lap takes up the slack of springs
      work.done -= force.dot(at - last);
      work.friction += scene.instruments[0].tool.friction * force.z() * (now - tool).norm();
    }
    last = at;
    tool = now;
  }
  return work;
}

/// Two flat walls side by side, both of which lie where y is within 10 mm, and a table far away.
Scene make_pair_of_walls(std::vector<double> pair_friction) {
  Scene scene = make_flat_wall(0.3);
  scene.bodies.push_back(scene.bodies[0]);
  for (std::size_t b = 0; b < 2; ++b) {
    for (Vec3& x : scene.bodies[b].tissue.rest_position) x.y() += b == 0 ? -0.05 : -0.01;
  }
  scene.scenery = {{scenes::make_table(0.06, 24, {0.2, 0.0, 0.0}), {}, 0.0}};
  scene.instruments[0].pair_friction = std::move(pair_friction);
  return build_scene(std::move(scene));
}

/// [-] Of a tool that slides along x over a place [m] at which it touches what has mu.
double measure_pair_ratio(const Scene& scene, const Vec3& at, double depth, double mu) {
  const double path = 0.012, from = -0.5 * (path + kBefore);
  Press press(scene, depth, from, at);
  return measure_slide(press, mu, from, path).ratio;
}

}  // namespace

TEST_CASE("T4: each pair of surfaces has a coefficient of its own") {
  const Scene scene = make_pair_of_walls({0.1, 0.5, 0.4});
  const auto check = [&](const Vec3& at, double depth, double mu, double within) {
    CAPTURE(mu);
    CHECK(std::abs(measure_pair_ratio(scene, at, depth, mu) - mu) < within * mu);
  };
  check({0.03, -0.025, 0.0}, 0.003, 0.1, 0.01);
  check({0.03, 0.025, 0.0}, 0.003, 0.5, 0.01);
  check({0.2, 0.0, 0.0}, 0.002, 0.4, 0.01);   // the table
  check({0.03, 0.0, 0.0}, 0.003, 0.3, 0.05);  // on both walls alike: the mean
}

TEST_CASE("coefficients of pairs that are the tool's own change no bit, and none of 0 rubs") {
  const auto drag = [](const Scene& scene) {
    Press press(scene, 0.003, 0.0, {0.03, 0.0, 0.0});
    for (int i = 0; i < 200; ++i) press.slide(2e-5 * i);
    return compute_hash(press.world());
  };
  CHECK(drag(make_pair_of_walls({0.3, 0.3, 0.3})) == drag(make_pair_of_walls({})));
  const Scene slippery = make_pair_of_walls({0.0, 0.0, 0.0});
  CHECK(measure_pair_ratio(slippery, {0.03, 0.025, 0.0}, 0.003, 0.0) == 0.0);
  Press press(slippery, 0.003, 0.0, {0.03, 0.025, 0.0});
  for (int i = 0; i < 100; ++i) press.slide(2e-5 * i);
  CHECK(press.world().instruments[0].tool.friction.norm() == 0.0);
}

// What sticks to jaws carries mu N of its own pair, and is let go of from there.
TEST_CASE("G1: jaws slip by the coefficient of what they hold") {
  constexpr double kOwn = 0.5, kPair = 0.25;
  Scene scene = scenes::make_grasped_slab(scenes::make_grasper(kOwn, 1.0), 1000.0, 3e7, 1000.0, 4);
  scene.instruments[0].pair_friction = {kPair};
  scene = build_scene(std::move(scene));
  scenes::GraspingHand hand(scene);
  hand.close();
  hand.wait(0.2);
  hand.go(0.004, 0.2);
  double most = 0.0;
  hand.after_tick = [&] {
    const ToolState& tool = hand.tool();
    double pressed = 0.0;
    for (int k = 0; k < tool.anchor_count; ++k) {
      pressed += tool.anchors[static_cast<std::size_t>(k)].pressed;
    }
    if (pressed > 0.0) most = std::max(most, tool.held_load / pressed);
  };
  hand.go(0.004, 0.2);
  CHECK(most < kPair * (1.0 + 1e-9));
  CHECK(most > 0.97 * kPair);
  double step = 0.0;
  const double held = hand.force().norm();
  Vec3 last = hand.force();
  hand.after_tick = [&] {
    step = std::max(step, (hand.force() - last).norm());
    last = hand.force();
  };
  hand.open();
  hand.wait(0.15);
  CHECK(step < 0.2 * held);
  CHECK(hand.tool().anchor_count == 0);
  CHECK_FALSE(hand.world().alarm);
}

TEST_CASE("T4: on a wall a sliding tool pulls with mu times what it presses with" *
          doctest::test_suite("landing")) {
  CHECK(std::abs(measure_slide(make_flat_wall(0.0), 0.003, 0.024).plane) < 0.002);
  for (const double mu : {0.1, 0.3, 0.6}) check_slide(make_flat_wall(mu), 0.003, 0.024);
}

TEST_CASE("T4: on a solid a sliding tool pulls with mu times what it presses with") {
  CHECK(std::abs(measure_slide(make_solid_block(0.0), 0.002, 0.016).plane) < 0.01);
  for (const double mu : {0.1, 0.3, 0.6}) check_slide(make_solid_block(mu), 0.002, 0.016);
}

TEST_CASE("T4: and so on a wall of prisms, and on a solid that is always in balance") {
  for (const double mu : {0.1, 0.6}) {
    check_slide(make_plate(mu), 0.003, 0.008, 0.1);  // and the plate sags towards its middle
    check_slide(make_solid_block(mu, build_linear_solid), 0.002, 0.016);
  }
}

TEST_CASE("T4: nine tenths of mu N hold a tool still for a second" *
          doctest::test_suite("landing")) {
  CHECK(measure_creep(make_flat_wall(0.3), 0.003, 1.0) < 1e-6);
  CHECK(measure_creep(make_solid_block(0.3), 0.002, 1.0) < 1e-6);
  CHECK(measure_creep(make_plate(0.3), 0.003, 1.0) < 1e-6);
  CHECK(measure_creep(make_solid_block(0.3, build_linear_solid), 0.002, 1.0) < 1e-6);
}

TEST_CASE("T4: and for ten" * doctest::test_suite("landing")) {
  for (const double mu : {0.1, 0.6}) {
    CAPTURE(mu);
    CHECK(measure_creep(make_flat_wall(mu), 0.003, 10.0) < 1e-6);
    CHECK(measure_creep(make_solid_block(mu), 0.002, 10.0) < 1e-6);
  }
}

TEST_CASE("a hand that rubs in circles gives what friction takes, and no lap gives any back") {
  for (const Scene& scene : {make_flat_wall(0.3), make_solid_block(0.3)}) {
    const Work work = circle(scene, 0.002, 2);
    CHECK(work.done > 0.0);
    CHECK(std::abs(work.done - work.friction) < 0.05 * work.friction);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/tick/tick.h"
#include "palpate/sim/tree/queries.h"
#include "scenes/flicks.h"
#include "scenes/held_block.h"
#include "scenes/kernels.h"

// What is felt of a solid under a ball, through the tick [contact: near field].

using namespace palpate;

namespace {

using scenes::hand_at;

constexpr double kYoung = scenes::kBlockYoung, kPoisson = scenes::kBlockPoisson;
constexpr double kModulus = scenes::kBlockModulus;  ///< [Pa]
constexpr double kTick = 1e-3;
constexpr double kThickness = scenes::kBlockThickness;  ///< [m]

enum class Kind { springs, linear, corotated, neo_hookean };

struct Press {
  double force = 0.0;  ///< [N] along the normal
  double depth = 0.0;  ///< [m] of the tool below where it touched
  double aside = 0.0;  ///< [N]
  double noise = 0.0;  ///< [N] of second differences, root mean square
};

/// A block of 100 x 100 x 50 mm, held below, of 24 n³ tetrahedra.
Scene make_block_scene(Kind kind, int n, double radius, double modulus) {
  auto [solid, material, options] = scenes::make_held_block(n);
  Scene scene;
  if (kind == Kind::springs) {
    options.drag = 60.0;
    scene.bodies[0].tissue = build_solid(solid, material, options);
    scene.bodies[0].kernel = scenes::kernel_under_test();
  } else if (kind == Kind::linear) {
    scene.bodies[0].tissue = build_linear_solid(solid, material, options);
  } else {
    options.drag = 60.0;
    scene.bodies[0].tissue = kind == Kind::corotated
                                 ? build_corotated_solid(solid, material, options)
                                 : build_neo_hookean_solid(solid, material, options);
  }
  scene.bodies[0].contact_modulus = modulus;
  scene.instruments[0].tool.radius = radius;
  scene.instruments[0].coupling.stiffness = 1000.0;
  return build_scene(std::move(scene));
}

/// Presses the top of a block until the tool is `depth` deep, and waits there.
Press press(const Scene& scene, const Vec3& at, double depth, int ticks) {
  World world(scene);
  const double top = 0.5 * kThickness, radius = scene.instruments[0].tool.radius;
  Press found;
  double last = 0.0, before = 0.0, lower = 0.0;
  for (int i = 0; i < ticks; ++i) {
    const double down = std::min(1.0, 3.0 * i / ticks) * (depth + 0.001);
    const double aim = top + radius + 0.001 - down;
    // the spring of the hand gives way: the hand follows until the tool is where it is meant to be
    if (2 * i > ticks) lower += 0.03 * (world.instruments[0].tool.position.z() - aim);
    const Vec3 hand(at.x(), at.y(), aim - lower);
    const Vec3 force = tick(scene, hand_at(hand), kTick, world).force;
    found.force = force.z();
    found.aside = force.head<2>().norm();
    if (i >= ticks - 100) {
      found.noise += (force.z() - 2.0 * last + before) * (force.z() - 2.0 * last + before) / 100.0;
    }
    before = last;
    last = force.z();
  }
  REQUIRE_FALSE(world.alarm);
  found.depth = top + radius - world.instruments[0].tool.position.z();
  found.noise = std::sqrt(found.noise);
  return found;
}

/// [N] Of a layer on a rigid base to which it is bonded: the half space at the depth that is left
/// when the layer's own compliance is taken off, alpha_0 of [Dimitriadis02].
double compute_layer(double radius, double depth) {
  const double alpha =
      -(1.2876 - 1.4678 * kPoisson + 1.3442 * kPoisson * kPoisson) / (1.0 - kPoisson);
  const double far = alpha / (std::numbers::pi * kModulus * kThickness);
  const LocalPress half{kModulus, radius, 0.0, 0.0};
  double s = depth;
  for (int i = 0; i < 50; ++i) s = depth - far * half.compute_force(s);
  return half.compute_force(s);
}

const std::array<Vec3, 3> kPlaces = {Vec3(0.001, 0.002, 0.0), Vec3(-0.0121, 0.0047, 0.0),
                                     Vec3(0.0083, -0.0061, 0.0)};

}  // namespace

/** A ball pressed into a block of n layers of cubes, beside theory. */
void check_layer(Kind kind, int n, double radius, double depth) {
  const Scene scene = make_block_scene(kind, n, radius, kModulus);
  // at rest by then
  const int ticks = kind == Kind::linear ? 500 : kind == Kind::springs ? 2000 : 900;
  const Press found = press(scene, kPlaces[static_cast<std::size_t>(n) % 3], depth, ticks);
  CAPTURE(static_cast<int>(kind));
  CAPTURE(n);
  CAPTURE(radius);
  CHECK(found.depth == doctest::Approx(depth).epsilon(0.05));
  CHECK(found.force == doctest::Approx(compute_layer(radius, found.depth)).epsilon(0.07));
  CHECK(found.noise < 1e-3);
}

TEST_CASE("a ball in a thick layer is felt within 7 % of theory") {
  check_layer(Kind::springs, 3, 0.003, 0.001);
  check_layer(Kind::linear, 3, 0.008, 0.002);
}

TEST_CASE("a ball in a thick layer is felt within 7 % of theory on any mesh, springs or linear" *
          doctest::test_suite("landing")) {
  for (const Kind kind : {Kind::springs, Kind::linear}) {
    for (const auto& [radius, depth] :
         {std::pair(0.002, 0.001), std::pair(0.003, 0.001), std::pair(0.005, 0.002),
          std::pair(0.008, 0.002), std::pair(0.020, 0.001)}) {
      check_layer(kind, 3, radius, depth);
      if (radius == 0.003 || radius == 0.020) check_layer(kind, 5, radius, depth);
    }
  }
}

TEST_CASE("a far field that is given is felt: the half space's force at the depth it leaves") {
  constexpr double kRadius = 0.003, kDepth = 0.001;
  for (const double far : {0.0, 0.02, 0.05}) {  // [m/N], beside 0.046 of the ball
    Scene scene = make_block_scene(Kind::linear, 3, kRadius, kModulus);
    scene.bodies[0].far_compliance.assign(scene.bodies[0].tissue.rest_position.size(),
                                          {0.1, 0.2, far, 0.0, 0.0, 0.0});
    scene = build_scene(std::move(scene));

    const Press found = press(scene, kPlaces[0], kDepth, 500);

    const LocalPress half{kModulus, kRadius, 0.0, 0.0};
    double low = 0.0, high = found.depth;
    for (int i = 0; i < 60; ++i) {
      const double s = 0.5 * (low + high);
      (s + far * half.compute_force(s) > found.depth ? high : low) = s;
    }
    CAPTURE(far);
    CHECK(found.force == doctest::Approx(half.compute_force(low)).epsilon(0.05));
    CHECK(found.noise < 1e-3);
  }
}

TEST_CASE("and so is a ball in tetrahedra at finite strain, corotated or neo-Hookean" *
          doctest::test_suite("landing")) {
  check_layer(Kind::corotated, 3, 0.003, 0.001);
  check_layer(Kind::neo_hookean, 3, 0.008, 0.002);
}

TEST_CASE("and so is a ball in tetrahedra at finite strain of either law on any mesh" *
          doctest::test_suite("landing")) {
  for (const Kind kind : {Kind::corotated, Kind::neo_hookean}) {
    for (const int n : {3, 5}) {
      check_layer(kind, n, 0.003, 0.001);
      check_layer(kind, n, 0.008, 0.002);
    }
  }
}

TEST_CASE("by the hard law alone the same press is that of the mesh, three times too strong") {
  const Press felt = press(make_block_scene(Kind::springs, 3, 0.003, 0.0), kPlaces[0], 0.001, 2000);
  CHECK(felt.force > 3.0 * compute_layer(0.003, felt.depth));
}

struct Drag {
  double pressed = 0.0;  ///< [N] at most
  double aside = 0.0;    ///< [-] of that
  double change = 0.0;   ///< [-] of the force along the normal on the way
  double work = 0.0;     ///< [-] done on the hand, of pressed times depth
};

/// Down into the top of a block, 30 mm across, back again and up: a closed path.
Drag drag(const Scene& scene, double depth) {
  World world(scene);
  const double radius = scene.instruments[0].tool.radius;
  const double low = 0.5 * kThickness + radius - depth, sag = 0.00006;
  double work = 0.0, aside = 0.0, pressed = 0.0, least = 1e9, most = 0.0;
  Vec3 last(-0.015, 0.0013, low + 0.004), force = Vec3::Zero();
  constexpr int kDown = 150, kAcross = 500;
  for (int i = 0; i < 2 * kDown + 2 * kAcross; ++i) {
    Vec3 hand(-0.015, 0.0013, low - sag);
    const int back = i - kDown - kAcross;
    if (i < kDown) hand.z() += 0.004 * (1.0 - double(i) / kDown);
    if (i >= kDown && back < 0) hand.x() += 0.03 * double(i - kDown) / kAcross;
    if (back >= 0 && back < kAcross) hand.x() += 0.03 * (1.0 - double(back) / kAcross);
    if (back >= kAcross) hand.z() += 0.004 * double(back - kAcross) / kDown;
    const Vec3 now = tick(scene, hand_at(hand), kTick, world).force;
    work += 0.5 * (force + now).dot(hand - last);
    if (i > kDown + 50 && back < kAcross) {
      aside = std::max(aside, now.head<2>().norm());
      pressed = std::max(pressed, now.z());
      least = std::min(least, now.z());
      most = std::max(most, now.z());
    }
    force = now;
    last = hand;
  }
  REQUIRE_FALSE(world.alarm);
  return {pressed, aside / pressed, most / least - 1.0, work / (pressed * depth)};
}

void check_drag(int n, double radius, double depth) {
  const Drag found = drag(make_block_scene(Kind::linear, n, radius, kModulus), depth);
  CAPTURE(n);
  CAPTURE(radius);
  CHECK(found.pressed > 0.005);
  CHECK(found.aside < 0.03);
  CHECK(found.change < 0.03);
  // of the force on the hand: a closed path gives the hand nothing
  CHECK(found.work < 0.01);
}

TEST_CASE("dragged over three elements a ball is pulled aside by less than a thirtieth") {
  check_drag(5, 0.003, 0.0015);
}

TEST_CASE("dragged over elements of any size a ball is pulled aside by less than a thirtieth" *
          doctest::test_suite("landing")) {
  for (const int n : {3, 5}) {
    for (const double radius : {0.002, 0.003, 0.005, 0.008}) {
      check_drag(n, radius, 0.5 * radius);
    }
  }
}

TEST_CASE("to one and a half radii a ball is felt within a tenth of a neo-Hookean half space") {
  // on a mesh that hardly sinks the dent is all the near field's: a barrier would add to it
  for (const double radius : {0.002, 0.003}) {
    const Scene scene = make_block_scene(Kind::linear, 3, radius, kModulus);
    const Press found = press(scene, kPlaces[0], 1.5 * radius, 500);
    CAPTURE(radius);
    CHECK(found.depth == doctest::Approx(1.5 * radius).epsilon(0.02));
    CHECK(found.force == doctest::Approx(compute_layer(radius, found.depth)).epsilon(0.10));
    CHECK(found.aside < 0.05 * found.force);
    CHECK(found.noise < 1e-3);
  }
}

TEST_CASE("a ball pushed beyond two radii meets the barrier, and comes out again") {
  const Scene scene = make_block_scene(Kind::linear, 3, 0.003, kModulus);
  const Press deep = press(scene, kPlaces[0], 0.0075, 700);
  CHECK(deep.force > 1.2 * compute_layer(0.003, deep.depth));
  World world(scene);
  for (int i = 0; i < 600; ++i) {
    const double down = 0.012 * (i < 300 ? i / 300.0 : 2.0 - i / 300.0);
    const Vec3 hand(0.001, 0.002, 0.5 * kThickness + 0.0032 - down);
    const Vec3 force = tick(scene, hand_at(hand), kTick, world).force;
    REQUIRE(force.z() >= 0.0);
  }
  const Vec3 above(0.001, 0.002, 0.5 * kThickness + 0.0032);
  CHECK(tick(scene, hand_at(above), kTick, world).force == Vec3::Zero());
  CHECK(world.pairs[0].candidates.near.lift == Vec3::Zero());
}

TEST_CASE("a tool that hovers over a near field feels exactly nothing") {
  const Scene scene = make_block_scene(Kind::springs, 3, 0.003, kModulus);
  World world(scene);
  for (int i = 0; i < 50; ++i) {
    const Vec3 hand(0.001 * i / 50.0, 0.002, 0.5 * kThickness + 0.0031);
    REQUIRE(tick(scene, hand_at(hand), kTick, world).force == Vec3::Zero());
  }
}

TEST_CASE("what a ball does to a near field is what is done to the ball") {
  const Scene scene = make_block_scene(Kind::springs, 3, 0.003, kModulus);
  World world(scene);
  for (int i = 0; i < 300; ++i) {
    const double depth = std::min(0.002, 1e-5 * i);
    tick(scene, hand_at({0.004, 0.002, 0.5 * kThickness + 0.003 - depth}), kTick, world);
  }
  const InstrumentState& instrument = world.instruments[0];
  Vec3 pushed = Vec3::Zero();
  for (const Push& push : world.pairs[0].load.pushes()) pushed += push.force;
  const Vec3 pull =
      scene.instruments[0].coupling.stiffness * (instrument.tool.position - instrument.hand);
  REQUIRE(pushed.norm() > 0.005);
  CHECK((pushed + pull + instrument.tool.residual).norm() < 1e-9);
}

TEST_CASE("a near field gives the same bits where the tick follows only what is touched") {
  const Scene scene = make_block_scene(Kind::springs, 3, 0.003, kModulus);
  World all(scene), part(scene);
  part.follows_all = false;
  for (int i = 0; i < 600; ++i) {
    const double down = std::min(0.004, 2e-5 * i);
    const Vec3 hand(0.004 + 1e-5 * i, 0.002, 0.5 * kThickness + 0.005 - down);
    REQUIRE(tick(scene, hand_at(hand), kTick, all).force ==
            tick(scene, hand_at(hand), kTick, part).force);
  }
  CHECK(all.instruments[0].tool.touching);
}

TEST_CASE("T3: no flick at 1 or 3 m/s passes through a soft solid under its near field") {
  Scene scene;
  scene.bodies[0].tissue = scenes::make_covered_organ(4, 0.9, {.damping_ratio = 0.05});
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.bodies[0].contact_modulus = kModulus;
  scene.instruments[0].tool = {.radius = 0.003, .stiffness = 3e7};
  const Scene built = build_scene(std::move(scene));
  const TissueModel& tissue = built.bodies[0].tissue;
  const Vec3Array x = compute_surface(tissue, tissue.rest_position);
  const Vec3Array normals = compute_vertex_normals(x, tissue.triangles);
  for (const double speed : {1.0, 3.0}) {
    int crossed = 0, touched = 0, alarms = 0;
    for (int place = 0; place < 20; ++place) {
      const auto v = static_cast<std::size_t>((place * 7919L) % static_cast<long>(x.size()));
      World world(built);
      const Vec3 start = x[v] + 0.008 * normals[v];
      const int ticks = static_cast<int>(std::ceil(0.020 / speed / kTick)) + 20;
      bool inside = false, felt = false;
      for (int i = 0; i <= ticks; ++i) {
        const Vec3 hand = start - std::min(0.020, speed * kTick * i) * normals[v];
        felt = tick(built, hand_at(hand), kTick, world).force.norm() > 0.0 || felt;
        const Vec3 centre =
            world.instruments[0].tool.position + world.pairs[0].candidates.near.lift;
        inside =
            inside || compute_winding_number(tissue.triangles, world.bodies[0].skin, centre) > 0.5;
      }
      crossed += inside;
      touched += felt;
      alarms += static_cast<bool>(world.alarm);
    }
    CAPTURE(speed);
    CHECK(crossed == 0);
    CHECK(touched == 20);
    CHECK(alarms == 0);
  }
}

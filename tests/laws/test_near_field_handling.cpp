// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/tick/tick.h"
#include "palpate/sim/tree/queries.h"
#include "scenes/flicks.h"
#include "scenes/kernels.h"
#include "scenes/solids.h"

// What hands do to a solid under its near field, on tetrahedra of 2 to 20 mm [contact: near field].

using namespace palpate;

namespace {

using scenes::hand_at;

constexpr double kYoung = 5000.0, kPoisson = 0.45;                 // of scenes::make_material
constexpr double kModulus = kYoung / (1.0 - kPoisson * kPoisson);  ///< [Pa]
constexpr double kTick = 1e-3;
constexpr int kLayers = 4;
constexpr std::array<double, 4> kEdges = {0.002, 0.005, 0.010, 0.020};  ///< [m]

Scene make_scene(const SolidMesh& solid, double radius) {
  double low = 0.0;
  for (const Vec3& x : solid.vertices) low = std::min(low, x.z());
  SolidOptions options;
  options.nodal_share = 0.9;
  options.drag = 30.0;
  for (std::size_t i = 0; i < solid.vertices.size(); ++i) {
    if (solid.vertices[i].z() < 0.999 * low) options.fixed.push_back(static_cast<int>(i));
  }
  Material material = scenes::make_material({.damping_ratio = 0.3});
  material.young_modulus = kYoung;
  material.poisson_ratio = kPoisson;
  Scene scene;
  scene.bodies[0].tissue = build_solid(solid, material, options);
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.bodies[0].contact_modulus = kModulus;
  scene.instruments[0].tool = {.radius = radius, .stiffness = 3e7};
  return build_scene(std::move(scene));
}

/// Twice as wide as thick, four layers of cells.
Scene make_block_scene(double edge, double radius) {
  constexpr int kWide = 2 * kLayers;
  return make_scene(scenes::make_block(edge * Vec3(kWide, kWide, kLayers), {kWide, kWide, kLayers}),
                    radius);
}

double find_top(double edge) { return 0.5 * kLayers * edge; }

/// Of the ball lifted off the triangles by what they lack of the dent.
bool is_inside(const Scene& scene, const World& world) {
  const Vec3 centre = world.instruments[0].tool.position + world.pairs[0].candidates.near.lift;
  return compute_winding_number(scene.bodies[0].tissue.triangles, world.bodies[0].tissue.position,
                                centre) > 0.5;
}

/// Straight down into the top at places all over it, to two fifths of the thickness or 20 mm deep.
scenes::Flicks flick(const Scene& scene, double edge, double speed, int places) {
  std::vector<Vec3> starts;
  const double radius = scene.instruments[0].tool.radius, side = (2 * kLayers - 2) * edge;
  const double reach = 1.5 * radius + std::min(0.020, 0.4 * kLayers * edge);
  for (int place = 0; place < places; ++place) {
    const double u = std::fmod(0.618034 * place, 1.0) - 0.5;
    const double v = (place + 0.5) / places - 0.5;
    starts.emplace_back(side * u, side * v, find_top(edge) + 1.5 * radius);
  }
  return scenes::flick_down(scene, starts, reach, speed, is_inside);
}

void check_flicks(double edge, double radius, int places) {
  const Scene scene = make_block_scene(edge, radius);
  for (const double speed : {1.0, 3.0}) {
    CAPTURE(edge);
    CAPTURE(radius);
    CAPTURE(speed);
    const scenes::Flicks found = flick(scene, edge, speed, places);
    CHECK(found.crossed == 0);
    CHECK(found.touched == places);
    CHECK(found.alarms == 0);
  }
}

struct Held {
  double force = 0.0;   ///< [N] along the normal
  double noise = 0.0;   ///< [N] the largest second difference
  double moment = 0.0;  ///< [-] of what is pushed about the ball's centre, of force times radius
  double unbalanced = 0.0;  ///< [N]
};

Held hold(double edge, double radius) {
  const Scene scene = make_block_scene(edge, radius);
  World world(scene);
  const double depth = std::min(0.5 * radius, 0.5 * edge * kLayers * 0.25);
  Held held;
  double last = 0.0, before = 0.0;
  constexpr int kDown = 300, kAll = 1500, kMeasured = 200;
  for (int i = 0; i < kAll; ++i) {
    const double down = std::min(1.0, double(i) / kDown) * (depth + 0.001);
    const Vec3 hand(0.13 * edge, 0.21 * edge, find_top(edge) + radius + 0.001 - down);
    held.force = tick(scene, hand_at(hand), kTick, world).force.z();
    if (i >= kAll - kMeasured) {
      held.noise = std::max(held.noise, std::abs(held.force - 2.0 * last + before));
    }
    before = last;
    last = held.force;
  }
  REQUIRE_FALSE(world.alarm);
  const InstrumentState& instrument = world.instruments[0];
  const Vec3 centre = instrument.tool.position;
  Vec3 pushed = Vec3::Zero(), moment = Vec3::Zero();
  for (const Push& push : world.pairs[0].load.pushes()) {
    const auto& corners = scene.bodies[0].tissue.triangles[static_cast<std::size_t>(push.triangle)];
    Vec3 at = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      at += push.weights[static_cast<int>(k)] *
            world.bodies[0].tissue.position[static_cast<std::size_t>(corners[k])];
    }
    pushed += push.force;
    moment += (at - centre).cross(push.force);
  }
  const Vec3 pull = scene.instruments[0].coupling.stiffness * (centre - instrument.hand);
  held.moment = moment.norm() / (pushed.norm() * radius);
  held.unbalanced = (pushed + pull + instrument.tool.residual).norm();
  return held;
}

void check_hold(double edge, double radius) {
  CAPTURE(edge);
  CAPTURE(radius);
  const Held held = hold(edge, radius);
  CHECK(held.force > 1e-3);
  CHECK(held.noise < 1e-3);
  CHECK(held.unbalanced < 1e-9);
  CHECK(held.moment < 0.02);
}

/// A block of cells of 2 mm with a slit in its top, one cell wide, two deep and four long.
SolidMesh make_slit_block() {
  constexpr double kEdge = 0.002;
  SolidMesh solid = scenes::make_block(kEdge * Vec3(7, 8, 5), {7, 8, 5});
  std::erase_if(solid.tetrahedra, [&](const auto& corners) {
    Vec3 middle = Vec3::Zero();
    for (const int v : corners) middle += 0.25 * solid.vertices[static_cast<std::size_t>(v)];
    return std::abs(middle.x()) < 0.5 * kEdge && std::abs(middle.y()) < 2.0 * kEdge &&
           middle.z() > 0.5 * kEdge;
  });
  return solid;
}

}  // namespace

TEST_CASE("T1, T9: under its near field a held press is quiet and its forces balance") {
  check_hold(0.002, 0.003);
  check_hold(0.020, 0.003);
}

TEST_CASE("T1, T9: under its near field a held press is quiet on tetrahedra of 2 to 20 mm" *
          doctest::test_suite("landing")) {
  for (const double edge : kEdges) {
    for (const double radius : {0.002, 0.005, 0.008}) check_hold(edge, radius);
  }
}

TEST_CASE("T3: no flick passes through a near field on tetrahedra of 2 and of 20 mm") {
  check_flicks(0.002, 0.003, 5);
  check_flicks(0.020, 0.003, 5);
}

TEST_CASE("T3: none of 100 flicks at 1 and at 3 m/s passes through a near field on any mesh" *
          doctest::test_suite("verify")) {
  for (const double edge : kEdges) check_flicks(edge, 0.003, 100);
}

TEST_CASE("T5: a tenth of a millimetre above a near field a tool feels exactly nothing") {
  for (const double edge : kEdges) {
    CAPTURE(edge);
    const Scene scene = make_block_scene(edge, 0.003);
    World world(scene);
    for (int i = 0; i < 50; ++i) {
      const Vec3 hand(edge * i / 50.0, 0.3 * edge, find_top(edge) + 0.0031);
      REQUIRE(tick(scene, hand_at(hand), kTick, world).force == Vec3::Zero());
    }
  }
}

TEST_CASE("T6: a slit four radii deep in a near field keeps the tool finite and outside") {
  const Scene scene = make_scene(make_slit_block(), 0.001);
  World world(scene);
  const double top = 0.005;
  double felt = 0.0;
  for (int i = 0; i < 1200; ++i) {
    const double height = 0.0015 - 0.0065 * std::min(1.0, i / 600.0);
    const Vec3 force = tick(scene, hand_at({1e-4, 5e-5, top + height}), kTick, world).force;
    REQUIRE(force.allFinite());
    REQUIRE(world.instruments[0].tool.position.allFinite());
    felt = force.z();
  }
  CHECK_FALSE(world.alarm);
  CHECK(felt > 0.0);
  CHECK_FALSE(is_inside(scene, world));
}

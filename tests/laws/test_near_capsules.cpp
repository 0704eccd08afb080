// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/flicks.h"
#include "scenes/held_block.h"
#include "scenes/kernels.h"

// What is felt of a solid under a capsule, through the tick [contact: capsules].

using namespace palpate;

namespace {

using scenes::hand_at;

constexpr double kModulus = scenes::kBlockModulus;      ///< [Pa]
constexpr double kThickness = scenes::kBlockThickness;  ///< [m]
constexpr double kPoisson = scenes::kBlockPoisson;
constexpr double kTick = 1e-3, kTop = 0.5 * kThickness;

/// A block of 100 x 100 x 50 mm, held below, of 24 n³ tetrahedra, under a capsule across its top.
Scene make_scene(int n, bool linear, double radius, double length, double friction = 0.0) {
  auto [solid, material, options] = scenes::make_held_block(n);
  Scene scene;
  if (linear) {
    scene.bodies[0].tissue = build_linear_solid(solid, material, options);
  } else {
    options.drag = 60.0;
    scene.bodies[0].tissue = build_solid(solid, material, options);
    scene.bodies[0].kernel = scenes::kernel_under_test();
  }
  scene.bodies[0].contact_modulus = kModulus;
  scene.instruments[0].tool = {.radius = radius,
                               .friction = friction,
                               .capsules = {{{-0.5 * length, 0.0, 0.0}, {0.5 * length, 0.0, 0.0}}}};
  scene.instruments[0].coupling.stiffness = 1000.0;
  return build_scene(std::move(scene));
}

struct Held {
  double force = 0.0;       ///< [N]
  double depth = 0.0;       ///< [m] of the tool below where it touched
  double noise = 0.0;       ///< [N] second differences, root mean square
  double unbalanced = 0.0;  ///< [N]
  double torque = 0.0;      ///< [N m] on tissue and tool together
};

void measure_balance(const Scene& scene, const World& world, Held& held) {
  const InstrumentState& instrument = world.instruments[0];
  Vec3 pushed = Vec3::Zero(), moment = Vec3::Zero();
  for (const Push& push : world.pairs[0].load.pushes()) {
    const auto& corners = scene.bodies[0].tissue.triangles[static_cast<std::size_t>(push.triangle)];
    Vec3 at = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      at += push.weights[static_cast<int>(k)] *
            world.bodies[0].tissue.position[static_cast<std::size_t>(corners[k])];
    }
    pushed += push.force;
    moment += (at - instrument.tool.position).cross(push.force);
  }
  const Vec3 pull =
      scene.instruments[0].coupling.stiffness * (instrument.tool.position - instrument.hand);
  held.unbalanced = (pushed + pull + instrument.tool.residual).norm();
  held.torque = (moment + instrument.tool.torque).norm();
}

/// Presses until the tool is `depth` deep, turned about the normal, and waits there.
Held press(const Scene& scene, const Vec3& at, double angle, double depth, int ticks) {
  World world(scene);
  const double radius = scene.instruments[0].tool.radius;
  Held held;
  double last = 0.0, before = 0.0, lower = 0.0;
  for (int i = 0; i < ticks; ++i) {
    const double down = std::min(1.0, 3.0 * i / ticks) * (depth + 0.001);
    const double aim = kTop + radius + 0.001 - down;
    // the spring of the hand gives way: the hand follows until the tool is where it is meant to be
    if (2 * i > ticks) lower += 0.03 * (world.instruments[0].tool.position.z() - aim);
    HapticSample sample = hand_at({at.x(), at.y(), aim - lower});
    sample.orientation = Quaternion(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    held.force = tick(scene, sample, kTick, world).force.z();
    if (i >= ticks - 100) held.noise += std::pow(held.force - 2.0 * last + before, 2) / 100.0;
    before = last;
    last = held.force;
  }
  REQUIRE_FALSE(world.alarm);
  held.depth = kTop + radius - world.instruments[0].tool.position.z();
  held.noise = std::sqrt(held.noise);
  measure_balance(scene, world, held);
  return held;
}

/// [N] On a half space, by boundary elements (tests/core/contact/test_capsule_footprint.cpp):
/// F/(E* R²) of a capsule of L = 5 R and of 8 R at the depths of kDepths radii.
constexpr std::array<double, 6> kDepths = {0.0, 0.05, 0.1, 0.25, 0.5, 0.8};
constexpr std::array<double, 6> kFive = {0.0, 0.0941, 0.2089, 0.6108, 1.3918, 2.4448};
constexpr std::array<double, 6> kEight = {0.0, 0.1328, 0.2907, 0.8303, 1.8589, 3.2204};

double find_half_space(const std::array<double, 6>& forces, double radius, double s) {
  const double x = s / radius;
  std::size_t k = 1;
  while (k + 1 < kDepths.size() && kDepths[k] < x) ++k;
  const double part = (x - kDepths[k - 1]) / (kDepths[k] - kDepths[k - 1]);
  return kModulus * radius * radius * (forces[k - 1] + part * (forces[k] - forces[k - 1]));
}

/// [N] Of a layer on a rigid base to which it is bonded, whose own compliance is that under a ball
/// [Dimitriadis02]: a capsule of 20 mm is short beside its thickness.
double compute_layer(const std::array<double, 6>& forces, double radius, double depth) {
  const double alpha =
      -(1.2876 - 1.4678 * kPoisson + 1.3442 * kPoisson * kPoisson) / (1.0 - kPoisson);
  const double far = alpha / (std::numbers::pi * kModulus * kThickness);
  double s = depth;
  for (int i = 0; i < 50; ++i) s = depth - far * find_half_space(forces, radius, s);
  return find_half_space(forces, radius, s);
}

void check_layer(int n, bool linear, bool eight, double radius, double depth, double angle) {
  const std::array<double, 6>& forces = eight ? kEight : kFive;
  const Scene scene = make_scene(n, linear, radius, (eight ? 8.0 : 5.0) * radius);
  const Held held = press(scene, {0.001, 0.002, 0.0}, angle, depth, linear ? 500 : 2000);
  const double truth = compute_layer(forces, radius, held.depth);
  CAPTURE(n);
  CAPTURE(linear);
  CAPTURE(eight);
  CAPTURE(radius);
  CAPTURE(depth);
  CAPTURE(angle);
  MESSAGE("capsule of ", 1e3 * radius, " mm, L/R ", eight ? 8 : 5, ", ", 1e3 * depth, " mm, ",
          24 * n * n * n, " tetrahedra, angle ", angle, ": ", held.force / truth, " of the truth");
  CHECK(held.depth == doctest::Approx(depth).epsilon(0.05));
  CHECK(held.force == doctest::Approx(truth).epsilon(0.12));
  CHECK(held.noise < 1e-3);
  CHECK(held.unbalanced < 1e-9);
  CHECK(held.torque < 1e-9);
}

/// Of the capsule lifted off the triangles by what they lack of the dent.
bool is_inside(const Scene& scene, const World& world) {
  const ToolState& tool = world.instruments[0].tool;
  const Vec3 lift = world.pairs[0].candidates.near.lift;
  const Capsule& capsule = scene.instruments[0].tool.capsules[0];
  return std::ranges::any_of(std::array{0.0, 0.5, 1.0}, [&](double part) {
    const Vec3 at = capsule.from + part * (capsule.to - capsule.from);
    return compute_winding_number(scene.bodies[0].tissue.triangles, world.bodies[0].tissue.position,
                                  tool.position + tool.orientation * at + lift) > 0.5;
  });
}

void check_flicks(int n, int places) {
  const Scene scene = make_scene(n, false, 0.002, 0.010);
  std::vector<Vec3> starts;
  for (int place = 0; place < places; ++place) {
    const double u = std::fmod(0.618034 * place, 1.0) - 0.5;
    starts.emplace_back(0.07 * u, 0.07 * ((place + 0.5) / places - 0.5), kTop + 0.003);
  }
  for (const double speed : {1.0, 3.0}) {
    CAPTURE(n);
    CAPTURE(speed);
    const scenes::Flicks found = scenes::flick_down(scene, starts, 0.023, speed, is_inside);
    CHECK(found.crossed == 0);
    CHECK(found.touched == places);
    CHECK(found.alarms == 0);
  }
}

}  // namespace

TEST_CASE("a capsule in a thick layer is felt within 12 % of theory, quietly and in balance") {
  check_layer(3, true, false, 0.002, 0.001, 0.0);
  check_layer(3, false, false, 0.002, 0.001, 0.5);
}

TEST_CASE("a capsule in a thick layer is felt within 12 % of theory on any mesh" *
          doctest::test_suite("landing")) {
  for (const bool linear : {true, false}) {
    for (const int n : {3, 5}) {
      check_layer(n, linear, false, 0.002, 0.001, 1.2);
      check_layer(n, linear, true, 0.0025, 0.001, 0.5);
    }
  }
}

TEST_CASE("T3: no flick of a capsule into a solid passes, by its near field") {
  check_flicks(3, 4);
}

TEST_CASE("T3: none of 100 flicks of a capsule into a solid passes, by its near field" *
          doctest::test_suite("landing")) {
  check_flicks(3, 100);
  check_flicks(5, 100);
}

TEST_CASE("T5: a capsule a tenth of a millimetre over a solid feels exactly nothing") {
  const Scene scene = make_scene(3, false, 0.002, 0.010);
  World world(scene);
  for (int i = 0; i < 100; ++i) {
    const Vec3 hand(1e-4 * i, 0.0, kTop + 0.0021);
    REQUIRE(tick(scene, hand_at(hand), kTick, world).force == Vec3::Zero());
  }
}

TEST_CASE("T4: a capsule slides on a solid at mu times what presses it") {
  const Scene scene = make_scene(3, true, 0.002, 0.010, 0.3);
  World world(scene);
  double ratio = 0.0;
  for (int i = 0; i < 900; ++i) {
    const double down = std::min(1.0, i / 200.0) * 0.003;
    const double aside = i < 300 ? 0.0 : 2e-5 * (i - 300);
    tick(scene, hand_at({-0.01 + aside, 0.0, kTop + 0.003 - down}), kTick, world);
    const ToolState& tool = world.instruments[0].tool;
    if (i < 700) continue;
    const Vec3 pull =
        scene.instruments[0].coupling.stiffness * (world.instruments[0].hand - tool.position);
    const double normal = -pull.dot(tool.patch_normal);
    ratio += (pull + normal * tool.patch_normal).norm() / normal / 200.0;
  }
  REQUIRE_FALSE(world.alarm);
  CHECK(ratio == doctest::Approx(0.3).epsilon(0.01));
}

TEST_CASE("what the near field does not know of capsules is refused with a sentence") {
  const auto refuse = [](auto change, const char* words) {
    auto [solid, material, options] = scenes::make_held_block(3);
    Scene scene;
    scene.bodies[0].tissue = build_solid(solid, material, options);
    scene.bodies[0].contact_modulus = kModulus;
    scene.instruments[0].tool.capsules = {{{0, 0, 0}, {0, 0, 0.01}}};
    change(scene);
    CHECK_THROWS_WITH(build_scene(scene), doctest::Contains(words));
  };
  refuse(
      [](Scene& s) {
        s.instruments[0].tool.capsules.push_back({{0, 0, 0.01}, {0, 0.01, 0.01}});
      },
      "the near field is of one");
  refuse([](Scene& s) { s.bodies[0].contact_facets = true; }, "how curved facets are");
  refuse([](Scene& s) { s.bodies[0].tied_holds = true; }, "tied_holds");
  refuse([](Scene& s) { s.exchange_rate = 100.0; }, "exchange_rate");
  refuse([](Scene& s) { s.bodies[0].force_error = 0.01; }, "force_error");
  refuse([](Scene& s) { s.instruments[0].tool.capsules[0].to.z() = 0.7; }, "within 0.5 m");
  refuse(
      [](Scene& s) {
        s.instruments[0].tool.capsules.clear();
        s.instruments[0].trocar = Vec3(0, 0, 0.1);
      },
      "it has no shaft");
}

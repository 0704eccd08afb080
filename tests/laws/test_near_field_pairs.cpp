// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <numbers>

#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/held_block.h"

// Two balls on one solid: what one sinks, the other has less of a dent in [contact: near field].

using namespace palpate;

namespace {

constexpr double kPoisson = scenes::kBlockPoisson;
constexpr double kModulus = scenes::kBlockModulus;  ///< [Pa]
constexpr double kTick = 1e-3, kThickness = scenes::kBlockThickness, kRadius = 0.003;

/// A block of 100 x 100 x 50 mm, held below, of 24 n³ tetrahedra, and two balls.
Scene make_pair_scene(int n) {
  const auto [solid, material, options] = scenes::make_held_block(n);
  Scene scene;
  scene.bodies[0].tissue = build_linear_solid(solid, material, options);
  scene.bodies[0].contact_modulus = kModulus;
  scene.instruments.resize(2);
  for (Instrument& instrument : scene.instruments) {
    instrument.tool.radius = kRadius;
    instrument.coupling.stiffness = 1000.0;
  }
  return build_scene(std::move(scene));
}

struct Pair {
  std::array<double, 2> force, depth;  ///< [N], [m]
};

/// Both balls go down on the top of the block, `distance` [m] apart about a place, and rest there.
Pair press_pair(const Scene& scene, const Vec3& about, double distance, double depth) {
  World world(scene);
  const double top = 0.5 * kThickness;
  Pair found;
  for (int i = 0; i < 700; ++i) {
    const double down = std::min(1.0, i / 200.0) * (depth + 0.001);
    std::array<HapticSample, 2> hands;
    for (std::size_t k = 0; k < 2; ++k) {
      hands[k].position =
          about + Vec3((k == 0 ? -0.5 : 0.5) * distance, 0.0, top + kRadius + 0.001 - down);
    }
    std::array<HapticCommand, 2> commands;
    tick(scene, hands, kTick, world, commands);
    for (std::size_t k = 0; k < 2; ++k) {
      found.force[k] = commands[k].force.z();
      found.depth[k] = top + kRadius - world.instruments[k].tool.position.z();
    }
  }
  REQUIRE_FALSE(world.alarm);
  return found;
}

/// [N] On each of two balls in a layer, both `depth` deep: of that the layer's own compliance and
/// what the other sinks [Boussinesq85] are taken off, alpha_0 of [Dimitriadis02] for both.
double compute_pair(double depth, double distance) {
  const double alpha =
      -(1.2876 - 1.4678 * kPoisson + 1.3442 * kPoisson * kPoisson) / (1.0 - kPoisson);
  const double layer = alpha / (std::numbers::pi * kModulus * kThickness);
  const double other = std::numbers::inv_pi / (kModulus * distance) + layer;
  const LocalPress half{kModulus, kRadius, 0.0, 0.0};
  double s = depth;
  for (int i = 0; i < 200; ++i) s += 0.5 * (depth - (layer + other) * half.compute_force(s) - s);
  return half.compute_force(s);
}

void check_pair(const Scene& scene, const Vec3& about, double distance, double depth) {
  const Pair found = press_pair(scene, about, distance, depth);
  CAPTURE(distance);
  CAPTURE(depth);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(found.depth[k] == doctest::Approx(depth).epsilon(0.1));
    CHECK(found.force[k] == doctest::Approx(compute_pair(found.depth[k], distance)).epsilon(0.04));
  }
}

}  // namespace

TEST_CASE("of two balls 10 mm apart each is felt as with the other's dent beside its own") {
  check_pair(make_pair_scene(5), {0.001, 0.002, 0.0}, 0.010, 0.001);
}

TEST_CASE("two balls 7 to 20 mm apart see each other on any mesh" *
          doctest::test_suite("landing")) {
  for (const int n : {3, 5}) {
    const Scene scene = make_pair_scene(n);
    for (const double distance : {0.007, 0.010, 0.014, 0.020}) {
      for (const Vec3& about : {Vec3(0.001, 0.002, 0.0), Vec3(-0.0121, 0.0047, 0.0)}) {
        check_pair(scene, about, distance, 0.001);
        check_pair(scene, about, distance, 0.002);
      }
    }
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "core/tree/soups.h"
#include "palpate/sim/contact/contact_law.h"
#include "tool_bench.h"

using namespace palpate;

namespace {

constexpr double kMu = 0.3;
constexpr double kRadius = 0.003;

/// Of a hand over the middle of a plane of 24 mm that is z [m] above it, and (x, y) aside.
Vec3 over_plane(double z, double x = 0.0, double y = 0.0) { return {0.012 + x, 0.012 + y, z}; }

constexpr double kPressed = kRadius - 0.002;  ///< [m] above the plane

/// A ball pressed into a plane that holds still.
Bench press_plane(double mu) {
  Bench bench(scenes::make_sheet(33, 33, 0.024),
              {.radius = kRadius, .stiffness = 2e7, .friction = mu});
  bench.move_hand(over_plane(2.0 * kRadius));
  bench.move_hand(over_plane(kPressed), 50);
  return bench;
}

/// Two planes that meet in a groove along y.
SurfaceMesh make_groove() {
  SurfaceMesh mesh;
  mesh.vertices = {{-0.02, -0.02, 0.02}, {0.0, -0.02, 0.0}, {0.02, -0.02, 0.02},
                   {-0.02, 0.02, 0.02},  {0.0, 0.02, 0.0},  {0.02, 0.02, 0.02}};
  mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  return mesh;
}

}  // namespace

TEST_CASE("a pull of less than mu N along the surface moves the tool by nothing") {
  Bench bench = press_plane(kMu);
  const Vec3 before = bench.state.position, n = bench.state.patch_normal;
  const double normal = n.dot(bench.balance(over_plane(kPressed)));
  const Vec3 along = (Vec3::UnitX() - n * n.x()).normalized();
  const double aside = 0.9 * kMu * normal / bench.coupling.stiffness;

  const Vec3 felt =
      bench.move_hand(before + normal / bench.coupling.stiffness * -n + aside * along, 100);

  CHECK((bench.state.position - before).norm() < 1e-9);
  CHECK(along.dot(felt) == doctest::Approx(-0.9 * kMu * normal).epsilon(1e-6));
  CHECK((bench.state.friction - along * along.dot(felt)).norm() < 1e-6);
}

TEST_CASE("a pull of more slides it until mu N is left, whatever the way it came") {
  for (const double mu : {0.05, 0.1, 0.3, 0.6, 1.0}) {
    for (const Vec3& way : {Vec3(1.0, 0.0, 0.0), Vec3(-0.6, 0.8, 0.0)}) {
      CAPTURE(mu);
      Bench bench = press_plane(mu);

      const Vec3 felt = bench.move_hand(over_plane(kPressed) + 0.003 * way, 200);

      const Vec3& n = bench.state.patch_normal;
      const Vec3 aside = felt - n * n.dot(felt);
      CHECK(aside.norm() == doctest::Approx(mu * n.dot(felt)).epsilon(1e-6));
      CHECK(aside.normalized().dot(way) == doctest::Approx(-1.0).epsilon(1e-3));
    }
  }
}

TEST_CASE("without friction a tool has no patch and is drawn aside by any pull") {
  Bench bench = press_plane(0.0);

  const Vec3 felt = bench.move_hand(over_plane(kPressed, 0.001), 100);

  CHECK(bench.state.patch_count == 0);
  CHECK(std::abs(felt.x()) < 1e-3 * felt.z());
}

TEST_CASE("a tool that sticks goes with the tissue, and so does its force with the hand") {
  Bench bench = press_plane(kMu);
  const Vec3 hand = over_plane(kPressed, 2e-5);
  const Vec3 felt = bench.move_hand(hand, 50);
  const Vec3 before = bench.state.position;
  const Vec3 shift(1e-4, -2e-4, 0.0);

  for (Vec3& x : bench.mesh.vertices) x += shift;
  const Vec3 after = bench.balance(hand + shift);

  // along a mean normal that is not quite that of the plane
  CHECK((bench.state.position - before - shift).norm() < 1e-8);
  CHECK((after - felt).norm() < 1e-5);
}

TEST_CASE("with friction too the forces on the particles balance the hand's spring") {  // T9
  Dice dice(71);
  for (const double mu : {0.1, 0.5}) {
    Bench bench(make_ball(), {.radius = kRadius, .friction = mu});
    for (int i = 0; i < 20; ++i) {
      const Vec3 out = dice.vector(1.0).normalized();
      bench.state.placed = false;
      bench.move_hand(0.032 * out);
      for (int k = 0; k < 40; ++k) {
        const Vec3 aside = dice.vector(0.002);
        const Vec3 felt = bench.move_hand(0.0265 * out + aside);
        REQUIRE((bench.force_on_particles() + felt + bench.state.residual).norm() < 1e-12);
        const double normal = bench.state.patch_normal.dot(bench.state.friction);
        REQUIRE(std::abs(normal) < 1e-12);
      }
    }
  }
}

TEST_CASE("a tool that leaves the tissue forgets it") {
  Bench bench = press_plane(kMu);
  REQUIRE(bench.state.patch_count > 0);

  const Vec3 felt = bench.move_hand(over_plane(2.0 * kRadius), 5);

  CHECK(felt == Vec3::Zero());
  CHECK(bench.state.patch_count == 0);
  CHECK(bench.state.friction == Vec3::Zero());
  CHECK(bench.state.position == over_plane(2.0 * kRadius));
}

TEST_CASE("in a groove friction acts along it, with the cone of both walls together") {
  Bench bench(make_groove(), {.radius = kRadius, .stiffness = 2e7, .friction = kMu});
  bench.move_hand({0.0, 0.0, 0.008});
  const double height = kRadius * std::sqrt(2.0) - 0.001;
  bench.move_hand({0.0, 0.0, height}, 50);

  const Vec3 felt = bench.move_hand({0.0, 0.004, height}, 400);

  CHECK(felt.z() > 0.1);
  CHECK(std::abs(felt.x()) < 1e-6);
  CHECK(-felt.y() == doctest::Approx(kMu * felt.z()).epsilon(1e-3));
}

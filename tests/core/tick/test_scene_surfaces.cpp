// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <numbers>

#include "core/tick/press_scene.h"
#include "palpate/sim/tick/surface_pointer.h"
#include "scenes/stones.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// An organ whose pole is at z = 20 mm, a stone of 9 x 7.4 x 6.5 mm over it, and a roof.
Scene stacked_scene() {
  Scene scene = press_scene();
  scene.rigid.push_back(scenes::make_stone(0.009));
  scene.rigid[0].position = {0.0, 0.0, 0.030};
  Scenery roof;
  roof.mesh.vertices = {{-0.1, -0.1, 0.1}, {0.1, -0.1, 0.1}, {0.1, 0.1, 0.1}, {-0.1, 0.1, 0.1}};
  roof.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.scenery.push_back(std::move(roof));
  return build_scene(std::move(scene));
}

const Vec3 kDown(0.0, 0.0, -1.0);
constexpr double kHalf = 0.009 * 8.0 / 22.0;  // [m] height of the stone over its middle

}  // namespace

TEST_CASE("a ray finds what it meets first: scenery, a stone, or the organ behind") {
  SceneSurfaces surfaces(stacked_scene());

  const auto roof = surfaces.find_ray_hit({0.0, 0.0, 0.2}, kDown);
  const auto stone = surfaces.find_ray_hit({0.0, 0.0, 0.09}, kDown);
  surfaces.place_rigid(0, {0.05, 0.0, 0.030}, Quaternion::Identity());
  const auto organ = surfaces.find_ray_hit({0.0, 0.0, 0.09}, 7.0 * kDown);

  REQUIRE(roof);
  REQUIRE(stone);
  REQUIRE(organ);
  CHECK(roof->part == ScenePart::scenery);
  CHECK(stone->part == ScenePart::rigid);
  CHECK((stone->point - Vec3(0.0, 0.0, 0.030 + kHalf)).norm() < 1e-9);
  CHECK(stone->distance == doctest::Approx(0.060 - kHalf));
  CHECK(stone->normal.dot(kDown) == doctest::Approx(-1.0));
  CHECK(organ->part == ScenePart::body);
  CHECK(organ->distance == doctest::Approx(0.070));
}

TEST_CASE("a stone is met as it is turned, its normal with it") {
  SceneSurfaces surfaces(stacked_scene());
  const Quaternion upright(Eigen::AngleAxisd(std::numbers::pi / 2.0, Vec3::UnitY()));
  surfaces.place_rigid(0, {0.0, 0.0, 0.040}, upright);

  const auto hit = surfaces.find_ray_hit({0.0, 0.0, 0.09}, kDown);

  REQUIRE(hit);
  CHECK(hit->point.z() == doctest::Approx(0.0445));
  CHECK(hit->normal.z() == doctest::Approx(1.0));
}

TEST_CASE("nothing behind the inner side of a surface is found") {
  const SceneSurfaces surfaces(stacked_scene());

  CHECK_FALSE(surfaces.find_ray_hit({0.0, 0.0, 0.0}, -kDown));    // from within the organ
  CHECK_FALSE(surfaces.find_ray_hit({0.05, 0.0, 0.05}, -kDown));  // the roof from below
  CHECK_FALSE(surfaces.find_ray_hit({0.5, 0.0, 0.2}, kDown));     // beside all
}

TEST_CASE("the nearest point is that of bodies and scenery, and of the rigid body that is named") {
  const SceneSurfaces surfaces(stacked_scene());
  const Vec3 between(0.0, 0.0, 0.025);

  const auto without = surfaces.find_closest_point(between);
  const auto with = surfaces.find_closest_point(between, 0);

  REQUIRE(without);
  REQUIRE(with);
  CHECK(without->part == ScenePart::body);
  CHECK(without->distance == doctest::Approx(0.005));
  CHECK(with->part == ScenePart::rigid);
  CHECK(with->distance == doctest::Approx(0.005 - kHalf));
  CHECK(surfaces.find_closest_point({0.0, 0.0, 0.09})->part == ScenePart::scenery);
}

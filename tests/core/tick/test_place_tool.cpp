// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/tick/press_scene.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/scenes.h"

using namespace palpate;

TEST_CASE("a closed surface goes once round every point inside and not round one outside") {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.03, 0.02, 0.01}, 2);
  const auto winding = [&](const Vec3& p) {
    return compute_winding_number(mesh.triangles, mesh.vertices, p);
  };

  CHECK(winding({0, 0, 0}) == doctest::Approx(1.0));
  CHECK(winding({0.025, 0.005, -0.001}) == doctest::Approx(1.0));
  CHECK(std::abs(winding({0, 0, 0.0101})) < 1e-9);
  CHECK(std::abs(winding({1, 2, 3})) < 1e-9);
}

TEST_CASE("an open surface covers a share of the directions") {
  const SurfaceMesh sheet = scenes::make_sheet(9, 9, 0.1);
  const auto winding = [&](double z) {
    return compute_winding_number(sheet.triangles, sheet.vertices, {0.05, 0.05, z});
  };

  CHECK(winding(0.0001) == doctest::Approx(-0.5).epsilon(0.01));
  CHECK(winding(-0.0001) == doctest::Approx(0.5).epsilon(0.01));
  // a square seen from half its side away is one face of a cube
  CHECK(winding(0.05) == doctest::Approx(-1.0 / 6.0));
}

TEST_CASE("a tool appears where the hand is, unless that is inside") {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.03, 0.02, 0.01}, 2);
  const AabbTree tree(mesh.vertices, mesh.triangles);
  ToolState tool(8);

  CHECK_FALSE(place_tool(tree, mesh.vertices, {0, 0, 0.005}, 1e-3, tool));
  CHECK(tool.position == Vec3(0, 0, 0.005));
  // in the box around the organ, yet beside it
  CHECK(place_tool(tree, mesh.vertices, {0.025, 0.015, 0.009}, 1e-3, tool));
  CHECK(tool.position == Vec3(0.025, 0.015, 0.009));
}

TEST_CASE("a tool that is somewhere is left there") {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.03, 0.02, 0.01}, 2);
  const AabbTree tree(mesh.vertices, mesh.triangles);
  ToolState tool(8);
  REQUIRE(place_tool(tree, mesh.vertices, {0, 0, 0.02}, 1e-3, tool));

  CHECK(place_tool(tree, mesh.vertices, {0, 0, 0}, 1e-3, tool));

  CHECK(tool.position == Vec3(0, 0, 0.02));
}

TEST_CASE("a tool that would be deep in the surface is not there before the hand is clear of it") {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.03, 0.02, 0.01}, 2);
  const AabbTree tree(mesh.vertices, mesh.triangles);
  ToolState tool(8);

  CHECK_FALSE(place_tool(tree, mesh.vertices, {0, 0, 0.0101}, 3e-3, tool));
  CHECK_FALSE(place_tool(tree, mesh.vertices, {0, 0, 0.0111}, 3e-3, tool));
  CHECK(place_tool(tree, mesh.vertices, {0, 0, 0.0113}, 3e-3, tool));
}

TEST_CASE("a hand that leaves the organ it began in, at a metre a second, tears nothing") {
  const Scene scene = testing::press_scene();
  World world(scene);
  double strongest = 0.0;
  for (int k = 0; k < 60; ++k) {
    HapticSample sample;
    sample.position = Vec3(0.001, 0.002, 1e-3 * k);
    strongest = std::max(strongest, tick(scene, sample, 1e-3, world).force.norm());
  }

  CHECK_FALSE(world.alarm);
  CHECK(world.instruments[0].tool.placed);
  CHECK(strongest < 0.5);  // [N] of a tool that begins by touching
}

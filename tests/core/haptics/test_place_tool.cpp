// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/haptics/place_tool.h"
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

  CHECK_FALSE(place_tool(tree, mesh.vertices, {0, 0, 0.005}, tool));
  CHECK(tool.position == Vec3(0, 0, 0.005));
  // in the box around the organ, yet beside it
  CHECK(place_tool(tree, mesh.vertices, {0.025, 0.015, 0.009}, tool));
  CHECK(tool.position == Vec3(0.025, 0.015, 0.009));
}

TEST_CASE("a tool that is somewhere is left there") {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.03, 0.02, 0.01}, 2);
  const AabbTree tree(mesh.vertices, mesh.triangles);
  ToolState tool(8);
  REQUIRE(place_tool(tree, mesh.vertices, {0, 0, 0.02}, tool));

  CHECK(place_tool(tree, mesh.vertices, {0, 0, 0}, tool));

  CHECK(tool.position == Vec3(0, 0, 0.02));
}

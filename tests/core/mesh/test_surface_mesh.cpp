// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <limits>

#include "palpate/sim/mesh/mesh.h"
#include "scenes/scenes.h"

using namespace palpate;

namespace {

/// Two triangles that share the edge 0-2.
SurfaceMesh make_square() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

}  // namespace

TEST_CASE("closed, hollow and flat surfaces are all valid") {
  CHECK_NOTHROW(validate(scenes::make_ellipsoid({0.05, 0.03, 0.02}, 2)));
  CHECK_NOTHROW(validate(scenes::make_tube(0.02, 0.08, 12, 7)));
  CHECK_NOTHROW(validate(scenes::make_sheet(6, 5, 0.1)));
  CHECK_NOTHROW(validate(make_square()));
}

TEST_CASE("two surfaces that touch in one vertex are valid") {
  const SurfaceMesh bow_tie = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                               {{0, 1, 2}, {0, 3, 4}}};

  CHECK_NOTHROW(validate(bow_tie));
}

TEST_CASE("a mesh without triangles is refused") {
  CHECK_THROWS_WITH_AS(validate(SurfaceMesh{}), "mesh: triangles: got none, expected at least one",
                       std::invalid_argument);
}

TEST_CASE("a vertex that is not finite is refused by its number") {
  SurfaceMesh mesh = make_square();
  mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();

  CHECK_THROWS_WITH_AS(validate(mesh), "mesh: vertex 3: got (0, nan, 0) m, expected finite numbers",
                       std::invalid_argument);
}

TEST_CASE("a vertex no triangle uses is refused by its number") {
  SurfaceMesh mesh = make_square();
  mesh.vertices.emplace_back(2, 2, 2);

  CHECK_THROWS_WITH_AS(validate(mesh),
                       "mesh: vertex 4: got no triangle that uses it, expected at least one",
                       std::invalid_argument);
}

TEST_CASE("an index out of range is refused, below as above") {
  for (const int index : {-1, 4}) {
    SurfaceMesh mesh = make_square();
    mesh.triangles[1][2] = index;

    const std::string message =
        "mesh: triangle 1: got vertex " + std::to_string(index) + ", expected 0 to 3";
    CHECK_THROWS_WITH_AS(validate(mesh), message.c_str(), std::invalid_argument);
  }
}

TEST_CASE("a triangle that uses a vertex twice is refused") {
  SurfaceMesh mesh = make_square();
  mesh.triangles.push_back({1, 2, 1});

  CHECK_THROWS_WITH_AS(validate(mesh),
                       "mesh: triangle 2: got vertices 1, 2, 1, expected three different ones",
                       std::invalid_argument);
}

TEST_CASE("a triangle whose corners lie on a line or in a point is refused") {
  SurfaceMesh mesh = make_square();
  mesh.vertices[3] = {0.5, 0.5, 0.0};
  CHECK_THROWS_AS(validate(mesh), std::invalid_argument);

  mesh.vertices[3] = mesh.vertices[2] = mesh.vertices[0];
  CHECK_THROWS_WITH_AS(
      validate(mesh),
      "mesh: triangle 0: got height 0 m over a side of 1 m, expected a triangle with an area",
      std::invalid_argument);
}

TEST_CASE("a needle is judged by its shape, not by its size") {
  SurfaceMesh mesh = make_square();
  for (Vec3& x : mesh.vertices) x = x.cwiseProduct(Vec3(1.0, 1e-6, 1.0)) * 1e-5;

  CHECK_NOTHROW(validate(mesh));
}

TEST_CASE("an edge of three triangles is refused") {
  SurfaceMesh mesh = make_square();
  mesh.vertices.emplace_back(0, 0, 1);
  mesh.triangles.push_back({0, 2, 4});

  CHECK_THROWS_WITH_AS(validate(mesh),
                       "mesh: triangle 2: got edge 0-2 already between triangles 0 and 1, "
                       "expected at most two triangles at an edge",
                       std::invalid_argument);
}

TEST_CASE("neighbours that disagree on which side is outside are refused") {
  SurfaceMesh mesh = make_square();
  mesh.triangles[1] = {0, 3, 2};

  CHECK_THROWS_WITH_AS(validate(mesh),
                       "mesh: triangle 1: got edge 2-0 run in the same direction as in triangle "
                       "0, expected neighbours that agree on which side is outside, and two to an "
                       "edge at most",
                       std::invalid_argument);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <numbers>
#include <numeric>

#include "palpate/sim/mesh/mesh.h"
#include "scenes/scenes.h"

using namespace palpate;
using doctest::Approx;

namespace {

constexpr double kPi = std::numbers::pi;

/// A box from the origin to (2, 3, 4), outside outside.
SurfaceMesh make_box() {
  return {{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {2, 3, 0}, {0, 0, 4}, {2, 0, 4}, {0, 3, 4}, {2, 3, 4}},
          {{0, 2, 1},
           {1, 2, 3},
           {4, 5, 6},
           {5, 7, 6},
           {0, 1, 4},
           {1, 5, 4},
           {2, 6, 3},
           {3, 6, 7},
           {0, 4, 2},
           {2, 4, 6},
           {1, 3, 5},
           {3, 7, 5}}};
}

}  // namespace

TEST_CASE("a box of 2 by 3 by 4 has 52 of area and 24 of volume") {
  CHECK(compute_area(make_box()) == Approx(52.0));
  CHECK(compute_volume(make_box()) == Approx(24.0));
}

TEST_CASE("a surface turned inside out has the same area and the negative volume") {
  SurfaceMesh mesh = make_box();
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);

  CHECK(compute_area(mesh) == Approx(52.0));
  CHECK(compute_volume(mesh) == Approx(-24.0));
}

TEST_CASE("far from the origin the volume keeps its digits") {
  SurfaceMesh mesh = make_box();
  for (Vec3& x : mesh.vertices) x = 1e-2 * x + Vec3(1e4, -2e4, 3e4);

  CHECK(compute_volume(mesh) == Approx(24e-6).epsilon(1e-8));
}

TEST_CASE("an ellipsoid's volume converges to 4/3 pi a b c with the square of the edge length") {
  const Vec3 radii(0.05, 0.035, 0.03);
  const double exact = 4.0 / 3.0 * kPi * radii.prod();
  const double coarse = 1.0 - compute_volume(scenes::make_ellipsoid(radii, 2)) / exact;
  const double fine = 1.0 - compute_volume(scenes::make_ellipsoid(radii, 3)) / exact;

  CHECK(fine > 0.0);
  CHECK(fine < 0.02);
  CHECK(coarse / fine == Approx(4.0).epsilon(0.05));
}

TEST_CASE("vertex areas add up to the area, open or closed") {
  for (const SurfaceMesh& mesh : {make_box(), scenes::make_sheet(6, 5, 0.1)}) {
    const std::vector<double> areas = compute_vertex_areas(mesh);

    CHECK(areas.size() == mesh.vertices.size());
    CHECK(std::accumulate(areas.begin(), areas.end(), 0.0) == Approx(compute_area(mesh)));
  }
}

TEST_CASE("a vertex gets a third of the triangles around it") {
  const SurfaceMesh mesh = {{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {-6, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}};

  CHECK(compute_vertex_areas(mesh) == std::vector<double>{3.0, 1.0, 3.0, 2.0});
}

TEST_CASE("normals are of unit length and point outward") {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.05, 0.05, 0.05}, 2);
  const Vec3Array normals = compute_vertex_normals(mesh.vertices, mesh.triangles);

  for (std::size_t i = 0; i < normals.size(); ++i) {
    CHECK(normals[i].norm() == Approx(1.0));
    CHECK(normals[i].dot(mesh.vertices[i].normalized()) > 0.999);
  }
}

TEST_CASE("where triangles cancel out there is no normal, and nothing that is not finite") {
  const Vec3Array x = {{0, 0, 0}, {1, 0.3, 0}, {0.1, 1, 0.7}, {5, 5, 5}};
  const std::vector<Triangle> folded = {{0, 1, 2}, {1, 0, 2}};

  for (const Vec3& normal : compute_vertex_normals(x, folded)) CHECK(normal == Vec3::Zero());
}

TEST_CASE("the smallest angle of a 30-60-90 triangle is 30 degrees") {
  const SurfaceMesh mesh = {{{0, 0, 0}, {std::sqrt(3.0), 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

  CHECK(compute_smallest_angle(mesh) == Approx(kPi / 6.0));
}

TEST_CASE("a triangle without area has a smallest angle of 0, and so has no triangle at all") {
  CHECK(compute_smallest_angle({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}) == 0.0);
  CHECK(compute_smallest_angle({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}}) == 0.0);
  CHECK(compute_smallest_angle({}) == 0.0);
}

TEST_CASE("the box around a surface and its diagonal") {
  const SurfaceMesh mesh = make_box();

  const auto [low, high] = compute_bounds(mesh.vertices);

  CHECK(low == Vec3(0, 0, 0));
  CHECK(high == Vec3(2, 3, 4));
  CHECK(compute_diagonal(mesh.vertices) == Approx(std::sqrt(29.0)));
  CHECK(compute_diagonal({}) == 0.0);
}

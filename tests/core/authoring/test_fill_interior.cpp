// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <numbers>

#include "core/model/refusal.h"
#include "palpate/authoring/fill_interior.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/model/build_solid.h"
#include "scenes/scenes.h"

using namespace palpate;
using authoring::fill_interior;

namespace {

SurfaceMesh organ() { return scenes::make_ellipsoid({0.05, 0.035, 0.03}, 3); }

}  // namespace

TEST_CASE("a filled surface keeps its volume, and its tetrahedra have no slivers") {
  const SurfaceMesh surface = organ();

  const SolidMesh solid = fill_interior(surface, 0.010);

  CHECK(solid.tetrahedra.size() > 500);
  CHECK(solid.tetrahedra.size() < 4000);
  CHECK(compute_volume(solid) == doctest::Approx(compute_volume(surface)).epsilon(0.05));
  // perturbed and exuded: 12 and more on the shipped organs [laws: filling]
  CHECK(compute_smallest_dihedral(solid) > 8.0 * std::numbers::pi / 180.0);
  CHECK(is_closed(find_boundary(solid)));
}

TEST_CASE("the same surface and cell size give the same tetrahedra") {
  const SolidMesh once = fill_interior(organ(), 0.012), again = fill_interior(organ(), 0.012);

  CHECK(once.vertices == again.vertices);
  CHECK(once.tetrahedra == again.tetrahedra);
}

TEST_CASE("the surface rides on what fills it, where it was, to a nanometre") {
  const SurfaceMesh surface = organ();

  const TissueModel model =
      cover_with_skin(build_solid(fill_interior(surface, 0.012), {}), surface);

  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    Vec3 at = Vec3::Zero();
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      at += model.skin.weights[v][k] * model.rest_position[model.skin.corners[v][k]];
      sum += model.skin.weights[v][k];
    }
    CHECK((at - surface.vertices[v]).norm() < 1e-9);
    CHECK(std::abs(sum - 1.0) < 1e-12);
  }
}

TEST_CASE("about as many tetrahedra come as a cell size was chosen for") {
  const SurfaceMesh surface = organ();
  for (const int wanted : {1000, 4000}) {
    const double size = authoring::choose_cell_size(surface, wanted);
    const auto found = static_cast<double>(fill_interior(surface, size).tetrahedra.size());
    CAPTURE(wanted);
    CAPTURE(found);

    CHECK(found > wanted / 1.5);
    CHECK(found < wanted * 1.5);
  }
}

TEST_CASE("as many tetrahedra come as were asked for, to a tenth") {
  for (const double flat : {1.0, 0.25}) {
    SurfaceMesh surface = organ();
    for (Vec3& x : surface.vertices) x.z() *= flat;
    for (const int wanted : {100, 700, 3000}) {
      const SolidMesh solid = authoring::fill_to_count(surface, wanted);
      const auto found = static_cast<double>(solid.tetrahedra.size());
      CAPTURE(flat);
      CAPTURE(wanted);

      CHECK(found == doctest::Approx(wanted).epsilon(authoring::kCountError));
      CHECK(compute_smallest_dihedral(solid) > 8.0 * std::numbers::pi / 180.0);
    }
  }
}

TEST_CASE("a filling is finer at its fine triangles and as many tetrahedra as asked for") {
  const SurfaceMesh surface = organ();
  std::vector<int> fine;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const Vec3 middle = (surface.vertices[a] + surface.vertices[b] + surface.vertices[c]) / 3.0;
    if (middle.x() > 0.04) fine.push_back(t);
  }

  const SolidMesh solid = authoring::fill_to_count(surface, 3000, {fine, 0.3});

  double at_tip = 0.0, opposite = 0.0;
  int near = 0, far = 0;
  for (const auto& corners : solid.tetrahedra) {
    const Vec3 &a = solid.vertices[corners[0]], &b = solid.vertices[corners[1]];
    if (a.x() > 0.045) at_tip += (a - b).norm(), ++near;
    if (a.x() < -0.02) opposite += (a - b).norm(), ++far;
  }
  CHECK(static_cast<double>(solid.tetrahedra.size()) ==
        doctest::Approx(3000.0).epsilon(authoring::kCountError));
  REQUIRE((near > 20 && far > 20));
  CHECK(at_tip / near < 0.5 * opposite / far);
  CHECK(find_refusal([&] {
          authoring::fill_to_count(surface, 3000, {fine, 0.0});
        }) == "fill: fine ratio: got 0, expected above 0 to 1");
  CHECK(find_refusal([&] {
          authoring::fill_to_count(surface, 3000, {{99999}, 0.5});
        }).find("fill: fine triangles: got 99999, expected 0 to ") == 0);
  CHECK(find_refusal([&] { authoring::fill_to_count(surface, 0); }) ==
        "fill: tetrahedron_count: got 0, expected 1 to 40000");
}

TEST_CASE("no more tetrahedra come than there may be") {
  const SolidMesh solid = authoring::fill_to_count(organ(), authoring::kMostTetrahedra);

  CHECK(solid.tetrahedra.size() <= static_cast<std::size_t>(authoring::kMostTetrahedra));
  CHECK(static_cast<double>(solid.tetrahedra.size()) > 0.9 * authoring::kMostTetrahedra);
}

TEST_CASE("the cell size chosen for the most tetrahedra there may be is not refused") {
  // of some of these bodies as many again come of the size, but for rounding, as were asked for
  for (const double scale : {0.07, 0.3, 0.5, 0.9, 1.0, 1.3, 2.1}) {
    SurfaceMesh surface = organ();
    for (Vec3& x : surface.vertices) x *= scale;
    const double size = authoring::choose_cell_size(surface, authoring::kMostTetrahedra);
    CAPTURE(scale);

    CHECK_NOTHROW(authoring::check_cell_size(surface, size));
    CHECK_THROWS_AS(authoring::check_cell_size(surface, 0.999 * size), std::invalid_argument);
  }
}

TEST_CASE("surfaces and sizes that cannot be filled are refused with a sentence") {
  const auto refusal = [](const SurfaceMesh& surface, double size) {
    return find_refusal([&] { fill_interior(surface, size); });
  };
  SurfaceMesh inward = organ(), crossing = organ();
  for (Triangle& t : inward.triangles) std::swap(t[1], t[2]);
  const auto count = static_cast<int>(crossing.vertices.size());
  const SurfaceMesh other = organ();
  for (const Vec3& x : other.vertices) crossing.vertices.push_back(x + Vec3(0.04, 0.0, 0.0));
  for (const auto& [a, b, c] : other.triangles) {
    crossing.triangles.push_back({a + count, b + count, c + count});
  }

  CHECK(refusal(scenes::make_tube(0.015, 0.06, 20, 16), 0.01) ==
        "fill: surface: got an open one, with 2 holes, expected a closed one: nothing says how "
        "far the inside of an open one goes");
  CHECK(refusal(inward, 0.01).find("fill: surface: got a volume of -") == 0);
  CHECK(refusal(crossing, 0.01).find(" triangles that cross others") != std::string::npos);
  CHECK(refusal(organ(), 0.0) == "fill: cell_size: got 0 m, expected a positive number");
  CHECK(refusal(organ(), 1e-4).find("fill: cell_size: got 0.1 mm, which gives about ") == 0);
  CHECK(refusal(organ(), std::nan("")).find("fill: cell_size: got nan m") == 0);
}

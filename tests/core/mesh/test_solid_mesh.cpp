// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <numbers>

#include "core/model/refusal.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"
#include "scenes/solids.h"

using namespace palpate;
using doctest::Approx;

namespace {

SolidMesh one_corner() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}}; }

}  // namespace

TEST_CASE("the corner of a cube has a sixth of its volume and faces that stand upright or lean") {
  const SolidMesh solid = one_corner();

  validate(solid);

  CHECK(compute_volume(solid) == Approx(1.0 / 6.0));
  // the slanted face stands at 54.7 degrees on the three others, which stand at 90
  CHECK(compute_smallest_dihedral(solid) == Approx(std::acos(1.0 / std::sqrt(3.0))));
  CHECK(find_edges(solid).size() == 6);
}

TEST_CASE("the boundary of a block is closed, faces outwards and holds its volume") {
  const SolidMesh solid = scenes::make_block({0.03, 0.02, 0.01}, {4, 3, 2});

  validate(solid);
  const SurfaceMesh boundary{solid.vertices, find_boundary(solid)};

  CHECK(boundary.triangles.size() == 2 * 2 * (4 * 3 + 3 * 2 + 2 * 4));
  CHECK(is_closed(boundary.triangles));
  CHECK(compute_volume(boundary) == Approx(0.03 * 0.02 * 0.01));
  CHECK(compute_volume(solid) == Approx(0.03 * 0.02 * 0.01));
}

TEST_CASE("a solid that is none is refused, naming the first offender") {
  const auto refusal = [](SolidMesh solid) { return find_refusal([&] { validate(solid); }); };
  SolidMesh inverted = one_corner(), loose = one_corner(), crowded = one_corner();
  std::swap(inverted.tetrahedra[0][2], inverted.tetrahedra[0][3]);
  loose.vertices.emplace_back(2, 2, 2);
  for (const double z : {-1.0, -2.0}) {
    crowded.vertices.emplace_back(0.2, 0.2, z);
    crowded.tetrahedra.push_back({0, 2, 1, static_cast<int>(crowded.vertices.size()) - 1});
  }

  CHECK(refusal({{{0, 0, 0}}, {}}) == "solid: tetrahedra: got none, expected at least one");
  CHECK(refusal({one_corner().vertices, {{0, 1, 2, 4}}}) ==
        "solid: tetrahedra: row 0: got vertex 4, expected 0 to 3");
  CHECK(refusal(inverted) ==
        "solid: tetrahedra: row 0: got a volume of -0.166667 m³, expected a positive one");
  CHECK(refusal(loose) ==
        "solid: vertices: row 4: got in no tetrahedron, expected every vertex in one");
  CHECK(refusal(crowded) ==
        "solid: tetrahedra: row 2: got a face that two others have, expected at most one other");
}

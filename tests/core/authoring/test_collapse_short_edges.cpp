// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "palpate/authoring/collapse_short_edges.h"
#include "palpate/authoring/fill_interior.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"
#include "scenes/scenes.h"

using namespace palpate;
using authoring::collapse_short_edges;

namespace {

constexpr double kNear = 0.02;

SolidMesh body() {
  static const SolidMesh solid =
      authoring::fill_interior(scenes::make_ellipsoid({0.05, 0.035, 0.03}, 3), 0.012);
  return solid;
}

bool has(const std::array<int, 4>& t, int v) { return std::find(t.begin(), t.end(), v) != t.end(); }

/// `solid` with a vertex on the edge a b, near a: each tetrahedron there becomes two.
void split_edge(int a, int b, SolidMesh& solid) {
  const int p = static_cast<int>(solid.vertices.size());
  solid.vertices.push_back((1.0 - kNear) * solid.vertices[a] + kNear * solid.vertices[b]);
  const std::size_t count = solid.tetrahedra.size();
  for (std::size_t t = 0; t < count; ++t) {
    if (!has(solid.tetrahedra[t], a) || !has(solid.tetrahedra[t], b)) continue;
    std::array<int, 4> other = solid.tetrahedra[t];
    std::replace(other.begin(), other.end(), b, p);
    std::replace(solid.tetrahedra[t].begin(), solid.tetrahedra[t].end(), a, p);
    solid.tetrahedra.push_back(other);
  }
}

std::vector<std::array<int, 4>> sorted(const SolidMesh& solid) {
  auto all = solid.tetrahedra;
  for (auto& t : all) std::sort(t.begin(), t.end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

TEST_CASE("a solid without short edges stays as it is, to the bit") {
  SolidMesh solid = body();

  collapse_short_edges(1.0, solid);

  CHECK(solid.vertices == body().vertices);
  CHECK(solid.tetrahedra == body().tetrahedra);
}

TEST_CASE("vertices put beside others, inside and outside, are merged with them again") {
  SolidMesh solid = body();
  const auto outside = find_boundary(solid);
  const std::vector<std::array<int, 2>> edges = {
      {outside[0][0], outside[0][1]},
      {outside[90][1], outside[90][2]},
      {solid.tetrahedra[40][0], solid.tetrahedra[40][1]},
      {solid.tetrahedra[99][2], solid.tetrahedra[99][3]}};
  for (const auto& [a, b] : edges) split_edge(a, b, solid);
  validate(solid);
  REQUIRE(solid.vertices.size() == body().vertices.size() + edges.size());

  collapse_short_edges(1.0, solid);

  validate(solid);
  CHECK(solid.vertices.size() == body().vertices.size());
  CHECK(solid.tetrahedra.size() == body().tetrahedra.size());
  CHECK(is_closed(find_boundary(solid)));
  CHECK(compute_volume(solid) == doctest::Approx(compute_volume(body())).epsilon(1e-3));
}

TEST_CASE("a merged vertex is the one that was there, of the same tetrahedra") {
  SolidMesh solid = body();
  split_edge(solid.tetrahedra[40][0], solid.tetrahedra[40][1], solid);

  collapse_short_edges(1.0, solid);

  CHECK(solid.vertices == body().vertices);
  CHECK(sorted(solid) == sorted(body()));
}

TEST_CASE("edges that are meant to be so short stay") {
  SolidMesh solid = body();
  split_edge(solid.tetrahedra[40][0], solid.tetrahedra[40][1], solid);
  const SolidMesh before = solid;

  collapse_short_edges(0.1, solid);

  CHECK(solid.vertices == before.vertices);
  CHECK(solid.tetrahedra == before.tetrahedra);
}

TEST_CASE("no solid at all stays none") {
  SolidMesh solid;

  collapse_short_edges(1.0, solid);

  CHECK(solid.tetrahedra.empty());
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "palpate/sim/mesh/topology.h"
#include "scenes/scenes.h"

using namespace palpate;

namespace {

const std::vector<Triangle> kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

/// The directed sides that only one triangle has.
std::set<std::array<int, 2>> find_single_sides(const std::vector<Triangle>& triangles) {
  std::set<std::array<int, 2>> all, single;
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) all.insert({t[c], t[(c + 1) % 3]});
  }
  for (const auto& side : all) {
    if (!all.count({side[1], side[0]})) single.insert(side);
  }
  return single;
}

}  // namespace

TEST_CASE("two triangles have five sorted edges, one of them shared") {
  const std::vector<Triangle> square = {{0, 1, 2}, {0, 2, 3}};

  const Topology topology = build_topology(square);

  CHECK(topology.edges == std::vector<std::array<int, 2>>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}});
  CHECK(topology.edge_triangles ==
        std::vector<std::array<int, 2>>{{0, -1}, {0, 1}, {1, -1}, {0, -1}, {1, -1}});
  CHECK(topology.triangle_edges == std::vector<std::array<int, 3>>{{3, 1, 0}, {4, 2, 1}});
}

TEST_CASE("the edge filed under a corner is the one opposite it") {
  const SurfaceMesh mesh = scenes::make_tube(0.02, 0.08, 9, 5);

  const Topology topology = build_topology(mesh.triangles);

  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      std::array<int, 2> opposite = {mesh.triangles[t][(c + 1) % 3],
                                     mesh.triangles[t][(c + 2) % 3]};
      std::sort(opposite.begin(), opposite.end());
      CHECK(topology.edges[topology.triangle_edges[t][c]] == opposite);
    }
  }
}

TEST_CASE("a closed surface has three edges to every two triangles, an open one more") {
  const SurfaceMesh closed = scenes::make_ellipsoid({1, 1, 1}, 2);
  const SurfaceMesh open = scenes::make_sheet(6, 5, 1.0);

  CHECK(2 * build_topology(closed.triangles).edges.size() == 3 * closed.triangles.size());
  CHECK(2 * build_topology(open.triangles).edges.size() == 3 * open.triangles.size() + 18);
}

TEST_CASE("a third triangle at an edge is not kept, but counted") {
  const std::vector<Triangle> fan = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};

  CHECK(build_topology(fan).edge_triangles[0] == std::array{0, 1});
  CHECK(count_non_manifold_edges(fan) == 1);
}

TEST_CASE("two triangles that run along an edge in the same direction make it non-manifold") {
  CHECK(count_non_manifold_edges(std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}) == 0);
  CHECK(count_non_manifold_edges(std::vector<Triangle>{{0, 1, 2}, {0, 3, 2}}) == 1);
  CHECK(count_non_manifold_edges(kTetrahedron) == 0);
}

TEST_CASE("a closed surface has no border and an open one is not closed") {
  CHECK(find_border_loops(kTetrahedron).empty());
  CHECK(is_closed(kTetrahedron));
  CHECK_FALSE(is_closed(std::vector<Triangle>{{0, 1, 2}}));
  CHECK_FALSE(is_closed({}));
}

TEST_CASE("the border of a triangle is the triangle, the surface to its left") {
  CHECK(find_border_loops(std::vector<Triangle>{{4, 7, 2}}) ==
        std::vector<std::vector<int>>{{2, 4, 7}});
}

TEST_CASE("border loops take up every single side once and in its own direction") {
  const std::vector<Triangle> bow_tie = {{0, 1, 2}, {0, 4, 3}};
  for (const std::vector<Triangle>& triangles :
       {scenes::make_sheet(6, 5, 1.0).triangles, scenes::make_tube(0.02, 0.08, 9, 5).triangles,
        bow_tie}) {
    std::set<std::array<int, 2>> walked;
    for (const std::vector<int>& loop : find_border_loops(triangles)) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        CHECK(walked.insert({loop[i], loop[(i + 1) % loop.size()]}).second);
      }
    }
    CHECK(walked == find_single_sides(triangles));
  }
}

TEST_CASE("a sheet has one border and a tube two") {
  const auto of_sheet = find_border_loops(scenes::make_sheet(6, 5, 1.0).triangles);
  const auto of_tube = find_border_loops(scenes::make_tube(0.02, 0.08, 9, 5).triangles);

  REQUIRE(of_sheet.size() == 1);
  CHECK(of_sheet[0].size() == 18);
  REQUIRE(of_tube.size() == 2);
  CHECK(of_tube[0].size() == 9);
  CHECK(of_tube[1].size() == 9);
}

TEST_CASE("a vertex where two borders touch ends up in both loops") {
  const std::vector<Triangle> bow_tie = {{0, 1, 2}, {0, 3, 4}};

  const auto loops = find_border_loops(bow_tie);

  REQUIRE(loops.size() == 2);
  for (const std::vector<int>& loop : loops) {
    CHECK(loop.size() == 3);
    CHECK(std::count(loop.begin(), loop.end(), 0) == 1);
  }
}

TEST_CASE("two holes that touch in a vertex are two loops beside the outer one") {
  // a 4 x 4 sheet without the cells (1, 1) and (2, 2), which meet in vertex 2 * 5 + 2
  std::vector<Triangle> triangles;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      if (i == j && (i == 1 || i == 2)) continue;
      const int a = j * 5 + i;
      triangles.insert(triangles.end(), {{a, a + 1, a + 6}, {a, a + 6, a + 5}});
    }
  }

  auto loops = find_border_loops(triangles);

  REQUIRE(loops.size() == 3);
  std::sort(loops.begin(), loops.end(),
            [](const auto& one, const auto& other) { return one.size() < other.size(); });
  CHECK(loops[0].size() == 4);
  CHECK(loops[1].size() == 4);
  CHECK(loops[2].size() == 16);
  CHECK(std::count(loops[0].begin(), loops[0].end(), 12) == 1);
  CHECK(std::count(loops[1].begin(), loops[1].end(), 12) == 1);
}

TEST_CASE("triangles that disagree on their outside still have one border") {
  const auto loops = find_border_loops(std::vector<Triangle>{{0, 1, 2}, {0, 3, 2}});

  REQUIRE(loops.size() == 1);
  CHECK(std::set<int>(loops[0].begin(), loops[0].end()) == std::set<int>{0, 1, 2, 3});
}

TEST_CASE("shells are numbered in order of their first vertex, and loose vertices are in none") {
  const std::vector<Triangle> triangles = {{5, 6, 7}, {1, 3, 0}, {3, 4, 0}};

  CHECK(find_shells(9, triangles) == std::vector<int>{0, 0, -1, 0, 0, 1, 1, 1, -1});
}

TEST_CASE("the Euler number tells a sphere, a disc, a tube and two spheres apart") {
  std::vector<Triangle> two = kTetrahedron;
  for (const auto& [i, j, k] : kTetrahedron) two.push_back({i + 9, j + 9, k + 9});

  CHECK(compute_euler_number(scenes::make_ellipsoid({1, 2, 3}, 1).triangles) == 2);
  CHECK(compute_euler_number(scenes::make_sheet(6, 5, 1.0).triangles) == 1);
  CHECK(compute_euler_number(scenes::make_tube(0.02, 0.08, 9, 5).triangles) == 0);
  CHECK(compute_euler_number(two) == 4);
}

TEST_CASE("what is damaged is answered, not crashed on") {
  const std::vector<Triangle> damaged = {{0, 0, 1}, {0, 1, 2}, {2, 1, 0}, {0, 1, 3}};

  CHECK(count_non_manifold_edges(damaged) == 1);
  CHECK_FALSE(is_closed(damaged));
  CHECK(find_shells(4, damaged) == std::vector<int>{0, 0, 0, 0});
  CHECK(build_topology(damaged).triangle_edges.size() == 4);
  CHECK_FALSE(find_border_loops(damaged).empty());
}

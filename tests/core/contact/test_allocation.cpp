// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "calls.h"
#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/tree/queries.h"
#include "scenes/scenes.h"

using namespace palpate;
using namespace palpate::testing;

TEST_CASE("refit, queries, candidates, balance and attaching never allocate") {
  SurfaceMesh mesh = scenes::make_ellipsoid(Vec3::Constant(0.025), 3);
  AabbTree tree(mesh.vertices, mesh.triangles);
  const int count = static_cast<int>(mesh.triangles.size());
  const std::vector<double> areas(mesh.triangles.size(), 6e-6), mass(mesh.vertices.size(), 1e-5);
  std::vector<double> scratch(mesh.vertices.size());
  std::vector<int> out(mesh.triangles.size()), few(3);
  Candidates candidates(count);
  ToolState state(count);
  Load load(2 * count);
  const Tool tool;
  const Coupling coupling;
  int answers = 0, touched = 0;

  const Calls before = count_calls_of_this_thread();
  for (int i = 0; i < 300; ++i) {
    const double depth = 1e-5 * i;
    for (Vec3& x : mesh.vertices) x.z() += 1e-6;
    tree.refit(mesh.vertices);
    const Vec3 hand(0.001, 0.002, 0.029 - depth), up(0, 0, 0.05), down(0.0, 0.0, -0.05);
    answers += find_segment_hit(tree, mesh.vertices, up, down).has_value();
    answers += find_ray_hit(tree, mesh.vertices, up, down).has_value();
    answers += find_closest_point(tree, mesh.vertices, hand).has_value();
    answers += find_in_sphere(tree, mesh.vertices, hand, 0.005, out) > 0;
    answers += find_near_segment(tree, mesh.vertices, hand, hand, 0.005, few) > 3;
    find_candidates(tree, mesh.vertices, tool, state.placed ? state.position : hand, hand, areas,
                    candidates);
    balance_tool(tool, coupling, hand, candidates, mesh.triangles, mesh.vertices, state, load);
    if (i == 200) attach_tool(load, mesh.triangles, mesh.vertices, 400.0, state);
    if (i == 250) release_tool(state);
    touched += bound_contact_stiffness(tool, candidates, mesh.triangles, mesh.vertices, mass, state,
                                       scratch) > 0.0;
  }
  const Calls after = count_calls_of_this_thread();

  CHECK(after.allocations == before.allocations);
  CHECK(answers == 5 * 300);
  CHECK(touched > 100);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "core/tree/soups.h"
#include "palpate/sim/tree/aabb_tree.h"
#include "scenes/scenes.h"

using namespace palpate;

namespace {

/// Eight right triangles of 1 m in two heaps of four, `gap` [m] apart along x: two leaves.
Soup make_two_heaps(double gap) {
  Soup soup{"two heaps", {}, {}};
  for (int heap = 0; heap < 2; ++heap) {
    const double x = heap * (1.0 + gap);
    for (int t = 0; t < 4; ++t) soup.add({x, 0, 0}, {x + 1, 0, 0}, {x, 1, 1});
  }
  return soup;
}

void follow_for_a_round(const AabbTree& tree, TreeCost& cost) {
  for (int i = 0; i < TreeCost::kRound; ++i) cost.follow(tree);
}

}  // namespace

TEST_CASE("the cost of a tree is one and its boxes' share of the area of the whole") {
  // two cubes of 1 m, half an area of 3 m² each, in a box of 10 x 1 x 1 m with 21 m²
  const Soup soup = make_two_heaps(8.0);

  const AabbTree tree(soup.x, soup.triangles);

  CHECK(compute_query_cost(tree) == doctest::Approx(1.0 + 6.0 / 21.0));
  CHECK(compute_query_cost(AabbTree()) == 0.0);
}

TEST_CASE("what has no extent costs one visit") {
  const AabbTree tree(Vec3Array(3, Vec3(1, 2, 3)), std::vector<Triangle>{{0, 1, 2}});

  CHECK(compute_query_cost(tree) == 1.0);
  TreeCost cost(tree);
  follow_for_a_round(tree, cost);
  CHECK(cost.growth() == 1.0);
}

TEST_CASE("a round of small measurements finds the growth that one of everything finds") {
  const Soup soup = make_plain_soup(5000);
  AabbTree tree(soup.x, soup.triangles);
  const double before = compute_query_cost(tree);
  TreeCost cost(tree);
  Vec3Array twisted = soup.x;
  for (Vec3& x : twisted) {
    const double angle = 20.0 * x.z();
    x = Eigen::AngleAxisd(angle, Vec3::UnitZ()) * x;
  }
  tree.refit(twisted);

  int calls = 0;
  for (; cost.growth() == 1.0 && calls < 1000; ++calls) cost.follow(tree);

  CHECK(calls > TreeCost::kRound / 2);
  CHECK(calls <= TreeCost::kRound);
  CHECK(compute_query_cost(tree) > 1.1 * before);
  CHECK(cost.growth() == doctest::Approx(compute_query_cost(tree) / before));
}

TEST_CASE("moving, growing and shrinking as a whole make no tree costlier") {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.03, 0.02, 0.01}, 3);
  AabbTree tree(mesh.vertices, mesh.triangles);
  TreeCost cost(tree);
  Vec3Array moved = mesh.vertices;
  for (Vec3& x : moved) x = 4.0 * x + Vec3(1, 2, 3);

  tree.refit(moved);
  follow_for_a_round(tree, cost);

  CHECK(cost.growth() == doctest::Approx(1.0).epsilon(1e-3));
}

TEST_CASE(
    "a surface bent to a ring makes its tree cost half as much again, and a new one is cheap") {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.01, 0.01, 0.06}, 4);
  AabbTree tree(mesh.vertices, mesh.triangles);
  TreeCost cost(tree);
  Vec3Array bent = mesh.vertices;
  for (Vec3& x : bent) {
    const double angle = x.z() / 0.012;
    x = Vec3((0.03 + x.x()) * std::cos(angle), x.y(), (0.03 + x.x()) * std::sin(angle));
  }

  tree.refit(bent);
  follow_for_a_round(tree, cost);
  const AabbTree rebuilt(bent, mesh.triangles);

  CHECK(cost.growth() >= TreeCost::kWorthRebuilding);
  CHECK(compute_query_cost(rebuilt) < 0.7 * compute_query_cost(tree));
}

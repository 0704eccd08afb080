// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>

#include "core/tree/soups.h"
#include "palpate/sim/tree/aabb_tree.h"
#include "palpate/sim/tree/private/box.h"

using namespace palpate;

namespace {

int measure_depth(const AabbTree& tree, int node = 0) {
  const AabbTree::Node& n = tree.nodes()[static_cast<std::size_t>(node)];
  int deepest = 0;
  for (std::size_t k = 0; k < AabbTree::kWidth; ++k) {
    if (n.count[k] == 0) deepest = std::max(deepest, measure_depth(tree, n.first[k]));
    if (n.count[k] > 0) deepest = std::max(deepest, 1);
  }
  return 1 + deepest;
}

/// Low and high over the triangles of a leaf, straight from the positions.
Box bound_leaf(const AabbTree& tree, const Vec3Array& x, int first, int count) {
  REQUIRE(count <= AabbTree::kLeafSize);
  Box box;
  for (int k = first; k < first + count; ++k) {
    const int t = tree.order()[static_cast<std::size_t>(k)];
    for (const int corner : tree.triangles()[static_cast<std::size_t>(t)]) {
      box.add(x[static_cast<std::size_t>(corner)]);
    }
  }
  return box;
}

/// Not above, and no farther below than two roundings of a float, or what float can hold at all.
void check_rounded_down(double rounded, double exact) {
  REQUIRE(rounded <= exact);
  const double held = std::clamp(exact, -double(std::numeric_limits<float>::max()),
                                 double(std::numeric_limits<float>::max()));
  if (exact == held) REQUIRE(rounded >= exact - 2e-7 * std::abs(exact) - 2e-44);
}

/// The box of a node, once those of its children and their children are found right.
Box check_boxes(const AabbTree& tree, const Vec3Array& x, int node) {
  const AabbTree::Node& n = tree.nodes()[static_cast<std::size_t>(node)];
  Box box;
  for (std::size_t k = 0; k < AabbTree::kWidth; ++k) {
    Box child;
    if (n.count[k] > 0) child = bound_leaf(tree, x, n.first[k], n.count[k]);
    if (n.count[k] == 0) {
      REQUIRE(n.first[k] > node);
      child = check_boxes(tree, x, n.first[k]);
    }
    for (std::size_t axis = 0; n.count[k] >= 0 && axis < 3; ++axis) {
      check_rounded_down(n.low[axis][k], child.low[static_cast<Eigen::Index>(axis)]);
      check_rounded_down(-n.high[axis][k], -child.high[static_cast<Eigen::Index>(axis)]);
    }
    box.add(child);
  }
  return box;
}

void check_boxes(const AabbTree& tree, const Vec3Array& x) {
  const Box box = check_boxes(tree, x, 0);
  CHECK(tree.low() == box.low);
  CHECK(tree.high() == box.high);
}

std::string message_of(const Vec3Array& x, const std::vector<Triangle>& triangles) {
  try {
    AabbTree(x, triangles);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("every triangle stands in one leaf, every box is the tightest in float, refitted too") {
  for (const Soup& soup : make_soups()) {
    CAPTURE(soup.name);
    AabbTree tree(soup.x, soup.triangles);
    std::vector<int> order(tree.order().begin(), tree.order().end());
    std::sort(order.begin(), order.end());
    std::vector<int> all(soup.triangles.size());
    std::iota(all.begin(), all.end(), 0);

    CHECK(order == all);
    check_boxes(tree, soup.x);

    const Vec3Array bent = deform(soup.x, 7);
    tree.refit(bent);
    check_boxes(tree, bent);
  }
}

TEST_CASE("a refit in parts is a refit, and boxes of parts are those of their moment") {
  for (const Soup& soup : make_soups()) {
    CAPTURE(soup.name);
    AabbTree whole(soup.x, soup.triangles), parts = whole;
    const Vec3Array bent = deform(soup.x, 7);
    whole.refit(bent);

    const std::size_t steps = parts.refit_step_count();
    for (std::size_t begin = 0; begin < steps; begin += 3) {
      parts.refit_steps(bent, begin, std::min(begin + 3, steps));
    }

    check_boxes(parts, bent);
    CHECK(std::memcmp(whole.nodes().data(), parts.nodes().data(), whole.nodes().size_bytes()) == 0);
    AabbTree half = AabbTree(soup.x, soup.triangles);
    half.refit_steps(bent, 0, steps - 1);
    CHECK(half.low() == AabbTree(soup.x, soup.triangles).low());
  }
}

TEST_CASE("no tree is deeper than the stack of a query") {
  // 2^-k over the whole range of double is the worst for planes between equal bins
  for (const int count : {5, 100, 1000}) {
    const Soup soup = make_geometric_soup(count);
    CHECK(measure_depth(AabbTree(soup.x, soup.triangles)) <= AabbTree::kMaxDepth);
  }
  const Soup stacked = make_stacked_soup(4096);
  CHECK(measure_depth(AabbTree(stacked.x, stacked.triangles)) == 5);
}

TEST_CASE("a tree over a plain soup is nearly balanced") {
  const Soup soup = make_plain_soup(5000);

  const AabbTree tree(soup.x, soup.triangles);

  CHECK(measure_depth(tree) <= 8);
  CHECK(tree.nodes().size() < 800);
}

TEST_CASE("a tree without triangles, or with indices or positions that are none, is refused") {
  const Vec3Array x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Vec3Array bad = x;
  bad[1].y() = std::numeric_limits<double>::quiet_NaN();

  CHECK(message_of(x, {}) == "AabbTree: triangles: got none");
  CHECK(message_of(x, {{0, 1, 3}}) ==
        "AabbTree: triangle 0: particle index must lie in [0, 3), got 3");
  CHECK(message_of(x, {{0, 1, 2}, {0, -1, 2}}) ==
        "AabbTree: triangle 1: particle index must lie in [0, 3), got -1");
  CHECK(message_of(bad, {{0, 1, 2}}) ==
        "AabbTree: triangle 0: the position of particle 1 must be finite");
}

TEST_CASE("two trees over the same surface are the same") {
  const Soup soup = make_plain_soup(500);

  const AabbTree a(soup.x, soup.triangles), b(soup.x, soup.triangles);

  CHECK(std::equal(a.order().begin(), a.order().end(), b.order().begin(), b.order().end()));
}

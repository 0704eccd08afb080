// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cstring>

#include "core/tree/soups.h"
#include "palpate/sim/tree/private/build_tree.h"
#include "palpate/sim/tree/private/tree_kernels.h"

using namespace palpate;

namespace {

/// Which bits: unlike ==, this tells 0 from -0.
bool same_bits(const void* a, const void* b, std::size_t size) {
  return std::memcmp(a, b, size) == 0;
}

bool same(const std::optional<SurfacePoint>& a, const std::optional<SurfacePoint>& b) {
  if (a.has_value() != b.has_value()) return false;
  return !a || (a->triangle == b->triangle && same_bits(&a->distance, &b->distance, 8) &&
                same_bits(a->weights.data(), b->weights.data(), 24));
}

struct Boxes {
  CacheAligned<AabbTree::Node> nodes;
  TreeRefit refit;
};

Boxes plan(const Soup& soup) {
  TreeShape shape = build_tree(soup.x, soup.triangles);
  Boxes boxes;
  boxes.refit = plan_refit(shape, soup.triangles, soup.x.size());
  boxes.nodes = std::move(shape.nodes);
  return boxes;
}

bool same(const Boxes& a, const Boxes& b) {
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    if (!same_bits(&a.nodes[n].low, &b.nodes[n].low, sizeof a.nodes[n].low)) return false;
    if (!same_bits(&a.nodes[n].high, &b.nodes[n].high, sizeof a.nodes[n].high)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("plain code, which machines without AVX2 run, is always there, and the last choice") {
  REQUIRE_FALSE(tree_kernels::available().empty());
  CHECK(tree_kernels::available().back() == &tree_kernels::plain());
  CHECK(tree_kernels::available().front() == &tree_kernels::best());
}

TEST_CASE("boxes are the same bits on every target, followed whole or where they move") {
  for (const Soup& soup : make_soups()) {
    CAPTURE(soup.name);
    const Vec3Array x = deform(soup.x, 7);
    Boxes expected = plan(soup);
    tree_kernels::plain().refit(x, 0, expected.refit.step_count(), expected.refit, expected.nodes);
    for (const tree_kernels::Kernels* kernels : tree_kernels::available()) {
      CAPTURE(kernels->target);
      Boxes whole = plan(soup), part = plan(soup);
      kernels->refit(x, 0, whole.refit.step_count(), whole.refit, whole.nodes);
      CHECK(same(whole, expected));

      // of every third particle moved back, the boxes around it, and no others
      Vec3Array y = x;
      kernels->refit(x, 0, part.refit.step_count(), part.refit, part.nodes);
      for (std::size_t i = 0; i < y.size(); i += 3) {
        y[i] = soup.x[i];
        for (int n = part.refit.first_row[i]; n < part.refit.first_row[i + 1]; ++n) {
          const int row = part.refit.leaf_rows[static_cast<std::size_t>(n)];
          ++part.refit.moving[static_cast<std::size_t>(row)];
        }
      }
      list_moving(part.nodes.size(), part.refit);
      kernels->refit_moving(y, part.refit, part.nodes);
      kernels->refit(y, 0, whole.refit.step_count(), whole.refit, whole.nodes);
      CHECK(same(part, whole));
    }
  }
}

TEST_CASE("answers of the tree are the same bits on every target") {
  const tree_kernels::Kernels& plain = tree_kernels::plain();
  for (const Soup& soup : make_soups()) {
    CAPTURE(soup.name);
    AabbTree tree(soup.x, soup.triangles);
    const Vec3Array x = deform(soup.x, 11);
    tree.refit(x);
    Dice dice(5);
    for (int q = 0; q < 200; ++q) {
      const Vec3 p = pick_point(soup, x, dice), to = pick_point(soup, x, dice);
      const double radius = dice.number(0.0, 0.1);
      const double length = (to - p).norm();
      const Segment segment{p, to - p, 1.0, 1e-12};
      std::vector<int> expected(soup.triangles.size()), found(expected.size());
      Collector in_sphere(expected);
      plain.collect_in_sphere(tree, x, p, radius, in_sphere);
      const int count = in_sphere.finish();
      for (const tree_kernels::Kernels* kernels : tree_kernels::available()) {
        CAPTURE(kernels->target);
        CHECK(kernels->find_closest(tree, x, p, 10.0) == plain.find_closest(tree, x, p, 10.0));
        if (length > 0.0) {
          CHECK(same(kernels->find_first_hit(tree, x, segment, length),
                     plain.find_first_hit(tree, x, segment, length)));
        }
        Collector collector(found);
        kernels->collect_in_sphere(tree, x, p, radius, collector);
        REQUIRE(collector.finish() == count);
        CHECK(std::equal(found.begin(), found.begin() + count, expected.begin()));
      }
    }
  }
}

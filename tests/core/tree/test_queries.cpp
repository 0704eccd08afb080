// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/tree/soups.h"
#include "palpate/sim/tree/queries.h"

using namespace palpate;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kQuestions = 300;

struct Corners {
  Vec3 a, b, c;
};

Corners find_corners(const Soup& soup, const Vec3Array& x, int triangle) {
  const Triangle& t = soup.triangles[static_cast<std::size_t>(triangle)];
  return {x[static_cast<std::size_t>(t[0])], x[static_cast<std::size_t>(t[1])],
          x[static_cast<std::size_t>(t[2])]};
}

/// Runs `ask(soup, tree, x)` on every soup at rest, and again bent with the tree refitted.
template <class Ask>
void for_each_soup(Ask ask) {
  for (const Soup& soup : make_soups()) {
    CAPTURE(soup.name);
    AabbTree tree(soup.x, soup.triangles);
    ask(soup, tree, soup.x);
    for (const unsigned seed : {11u, 12u}) {
      const Vec3Array bent = deform(soup.x, seed);
      tree.refit(bent);
      ask(soup, tree, bent);
    }
    tree.refit(soup.x);
    ask(soup, tree, soup.x);
  }
}

/// The best of all triangles, each asked in a tree of its own: no traversal, no pruning.
template <class Ask>
std::optional<SurfacePoint> ask_each_alone(const Soup& soup, const Vec3Array& x, Ask ask) {
  std::optional<SurfacePoint> best;
  for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
    const std::array<Triangle, 1> alone = {soup.triangles[static_cast<std::size_t>(t)]};
    const AabbTree tree(x, alone);
    std::optional<SurfacePoint> found = ask(tree);
    if (!found || (best && best->distance <= found->distance)) continue;
    found->triangle = t;
    best = found;
  }
  return best;
}

void check_same(const std::optional<SurfacePoint>& got, const std::optional<SurfacePoint>& want) {
  REQUIRE(got.has_value() == want.has_value());
  if (!got) return;
  REQUIRE(got->triangle == want->triangle);
  REQUIRE(got->distance == want->distance);
  REQUIRE(got->weights == want->weights);
  REQUIRE(got->point == want->point);
}

void check_is_on_triangle(const SurfacePoint& s, const Corners& k) {
  const double size = k.a.norm() + k.b.norm() + k.c.norm();
  REQUIRE(s.weights.minCoeff() >= 0.0);
  REQUIRE(std::abs(s.weights.sum() - 1.0) <= 1e-14);
  const Vec3 point = s.weights[0] * k.a + s.weights[1] * k.b + s.weights[2] * k.c;
  REQUIRE((s.point - point).norm() <= 1e-14 * size);
}

/// Seen from the far side of p's foot no corner lies nearer: for a convex set this, and only
/// this, is what being closest means.
void check_is_closest(const Vec3& p, const SurfacePoint& s, const Corners& k) {
  const double reach = std::max({(k.a - p).norm(), (k.b - p).norm(), (k.c - p).norm()});
  const double rounding = 1e-12 * reach + 1e-15 * (p.norm() + k.a.norm());
  for (const Vec3& corner : {k.a, k.b, k.c}) {
    REQUIRE((p - s.point).dot(corner - s.point) <= rounding * reach);
  }
  REQUIRE(std::abs(s.distance - (p - s.point).norm()) <= rounding);
}

/// A long-double crossing of a segment with a triangle [MollerTrumbore97]: -1 where it misses, the
/// parameter where it hits, NaN where it is too close to an edge or an end to say.
long double cross_in_long_double(const Vec3& from, const Vec3& to, const Corners& k) {
  using Long = Eigen::Matrix<long double, 3, 1>;
  const Long d = (to - from).cast<long double>(), o = from.cast<long double>();
  const Long a = k.a.cast<long double>(), ab = k.b.cast<long double>() - a,
             ac = k.c.cast<long double>() - a;
  const long double det = ab.dot(d.cross(ac)), size = ab.norm() * ac.norm() * d.norm();
  if (std::abs(det) <= 1e-9L * size) return std::numeric_limits<long double>::quiet_NaN();
  const long double u = (o - a).dot(d.cross(ac)) / det, v = d.dot((o - a).cross(ab)) / det;
  const long double t = ac.dot((o - a).cross(ab)) / det;
  const std::array<long double, 5> margins = {u, v, 1 - u - v, t, 1 - t};
  const long double least = *std::min_element(margins.begin(), margins.end());
  const long double height = ab.cross(ac).norm() / std::max(ab.norm(), ac.norm());
  const long double reach = o.norm() + d.norm() + a.norm();
  if (std::abs(least) <= 1e-6L || std::abs(least) * height <= 1e-12L * reach) {
    return std::numeric_limits<long double>::quiet_NaN();
  }
  return least > 0 ? t : -1.0L;
}

}  // namespace

TEST_CASE("the closest point of a triangle is found in its face, on its edges and at its corners") {
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);

  const SurfacePoint face = find_closest_on_triangle({1, 1, 2}, a, b, c);
  const SurfacePoint edge = find_closest_on_triangle({3, 3, 0}, a, b, c);
  const SurfacePoint corner = find_closest_on_triangle({-3, -4, 0}, a, b, c);

  CHECK(face.point == Vec3(1, 1, 0));
  CHECK(face.distance == 2.0);
  CHECK(face.weights == Vec3(0.5, 0.25, 0.25));
  CHECK(edge.point == Vec3(2, 2, 0));
  CHECK(edge.distance == doctest::Approx(std::sqrt(2.0)));
  CHECK(corner.point == a);
  CHECK(corner.distance == 5.0);
}

TEST_CASE("a degenerate triangle is the segment or the point that is left of it") {
  const Vec3 a(0, 0, 0), b(2, 0, 0), middle(1, 0, 0);

  CHECK(find_closest_on_triangle({1.5, 1, 0}, a, b, middle).point == Vec3(1.5, 0, 0));
  CHECK(find_closest_on_triangle({1.5, 1, 0}, a, b, b).point == Vec3(1.5, 0, 0));
  CHECK(find_closest_on_triangle({1.5, 1, 0}, a, a, b).point == Vec3(1.5, 0, 0));
  CHECK(find_closest_on_triangle({0, 3, 4}, a, a, a).distance == 5.0);
}

TEST_CASE("no point of a triangle lies nearer than the closest one, on any soup") {
  for_each_soup([](const Soup& soup, const AabbTree&, const Vec3Array& x) {
    Dice dice(21);
    for (int q = 0; q < 4 * kQuestions; ++q) {
      const Vec3 p = pick_point(soup, x, dice);
      const Corners k = find_corners(soup, x, dice.index(static_cast<int>(soup.triangles.size())));
      const SurfacePoint s = find_closest_on_triangle(p, k.a, k.b, k.c);
      check_is_on_triangle(s, k);
      check_is_closest(p, s, k);
    }
  });
}

TEST_CASE("the closest point equals brute force, the lower triangle where two are as near") {
  for_each_soup([](const Soup& soup, const AabbTree& tree, const Vec3Array& x) {
    Dice dice(22);
    for (int q = 0; q < kQuestions; ++q) {
      const Vec3 p = pick_point(soup, x, dice);
      std::optional<SurfacePoint> want;
      for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        const Corners k = find_corners(soup, x, t);
        SurfacePoint found = find_closest_on_triangle(p, k.a, k.b, k.c);
        found.triangle = t;
        if (!want || found.distance < want->distance) want = found;
      }

      check_same(find_closest_point(tree, x, p), want);
      check_same(find_closest_point(tree, x, p, want->distance), want);
      const double less = std::nextafter(want->distance, -1.0);
      CHECK_FALSE(find_closest_point(tree, x, p, less));
    }
  });
}

TEST_CASE("the triangles in a ball equal brute force") {
  for_each_soup([](const Soup& soup, const AabbTree& tree, const Vec3Array& x) {
    Dice dice(23);
    std::vector<int> out(soup.triangles.size());
    for (int q = 0; q < kQuestions; ++q) {
      const Vec3 p = pick_point(soup, x, dice);
      std::vector<double> distances;
      for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        const Corners k = find_corners(soup, x, t);
        distances.push_back(find_closest_on_triangle(p, k.a, k.b, k.c).distance);
      }
      // a radius that one triangle just reaches
      const double radius =
          distances[static_cast<std::size_t>(dice.index(static_cast<int>(distances.size())))];
      std::vector<int> want;
      for (std::size_t t = 0; t < distances.size(); ++t) {
        if (distances[t] <= radius) want.push_back(static_cast<int>(t));
      }

      const int count = find_in_sphere(tree, x, p, radius, out);

      REQUIRE(count == static_cast<int>(want.size()));
      REQUIRE(std::equal(want.begin(), want.end(), out.begin()));
    }
  });
}

TEST_CASE("the first triangle on a segment equals brute force") {
  int hits = 0, asked = 0;
  for_each_soup([&](const Soup& soup, const AabbTree& tree, const Vec3Array& x) {
    Dice dice(24);
    for (int q = 0; q < kQuestions / 3; ++q) {
      const Vec3 from = pick_point(soup, x, dice), to = pick_point(soup, x, dice);
      const auto got = find_segment_hit(tree, x, from, to);
      check_same(got, ask_each_alone(soup, x, [&](const AabbTree& alone) {
                   return find_segment_hit(alone, x, from, to);
                 }));
      const auto ray = find_ray_hit(tree, x, from, to - from);
      check_same(ray, ask_each_alone(soup, x, [&](const AabbTree& alone) {
                   return find_ray_hit(alone, x, from, to - from);
                 }));
      ++asked;
      hits += got.has_value();
      if (got) check_is_on_triangle(*got, find_corners(soup, x, got->triangle));
    }
  });
  CHECK(hits > asked / 10);
  CHECK(hits < 9 * asked / 10);
}

TEST_CASE("a segment hits what an independent crossing in long double says it hits") {
  int hits = 0, misses = 0;
  for_each_soup([&](const Soup& soup, const AabbTree& tree, const Vec3Array& x) {
    Dice dice(25);
    for (int q = 0; q < kQuestions; ++q) {
      const Vec3 from = pick_point(soup, x, dice), to = pick_point(soup, x, dice);
      long double first = 2.0L;
      bool certain = true;
      for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        const long double at = cross_in_long_double(from, to, find_corners(soup, x, t));
        if (std::isnan(at)) certain = false;
        if (at >= 0.0L) first = std::min(first, at);
      }
      const auto got = find_segment_hit(tree, x, from, to);
      const double length = (to - from).norm();
      if (first <= 1.0L) {
        REQUIRE(got);
        REQUIRE(got->distance <= static_cast<double>(first) * length + 1e-9 * length);
      }
      if (!certain) continue;
      REQUIRE(got.has_value() == (first <= 1.0L));
      if (got) {
        const double along = static_cast<double>(first) * length;
        REQUIRE(std::abs(got->distance - along) <= 1e-7 * length);
        REQUIRE((got->point - (from + static_cast<double>(first) * (to - from))).norm() <=
                1e-6 * length);
      }
      ++(got ? hits : misses);
    }
  });
  CHECK(hits > 100);
  CHECK(misses > 100);
}

TEST_CASE("a segment is stopped from both sides, at its ends too, and by nothing beyond them") {
  const Vec3Array x = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const AabbTree tree(x, triangles);

  CHECK(find_segment_hit(tree, x, {1, 1, 2}, {1, 1, -2})->distance == 2.0);
  CHECK(find_segment_hit(tree, x, {1, 1, -2}, {1, 1, 2})->distance == 2.0);
  CHECK(find_segment_hit(tree, x, {1, 1, -2}, {1, 1, 0})->distance == 2.0);
  CHECK(find_segment_hit(tree, x, {1, 1, 0}, {1, 1, 2})->distance == 0.0);
  CHECK_FALSE(find_segment_hit(tree, x, {1, 1, 2}, {1, 1, 0.001}));
  CHECK_FALSE(find_segment_hit(tree, x, {3, 3, 2}, {3, 3, -2}));
  CHECK_FALSE(find_segment_hit(tree, x, {1, 1, 0}, {1, 1, 0}));
  CHECK(find_ray_hit(tree, x, {1, 1, 2}, {0, 0, -7})->distance == 2.0);
  CHECK(find_ray_hit(tree, x, {1, 1, 2}, {0, 0, -7})->weights == Vec3(0.5, 0.25, 0.25));
  CHECK_FALSE(find_ray_hit(tree, x, {1, 1, 2}, {0, 0, 1}));
  CHECK_FALSE(find_ray_hit(tree, x, {1, 1, 2}, {0, 0, 0}));
}

TEST_CASE("no segment slips between triangles that share an edge or a corner") {
  // aimed at edges and corners of a closed fan of thin triangles, from every side
  const int spokes = 17;
  Soup soup{"fan", {Vec3(0.013, -0.007, 0.003)}, {}};
  for (int i = 0; i < spokes; ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * i / spokes;
    soup.x.push_back({std::cos(angle), std::sin(angle), 0.1 * std::sin(3.0 * angle)});
    soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % spokes});
  }
  const AabbTree tree(soup.x, soup.triangles);
  Dice dice(26);

  for (int q = 0; q < 20000; ++q) {
    const Vec3& rim = soup.x[static_cast<std::size_t>(1 + dice.index(spokes))];
    const double along = q % 10 == 0 ? 0.0 : dice.number(0.0, 0.999);
    const Vec3 target = soup.x[0] + along * (rim - soup.x[0]);
    const Vec3 above = target + Vec3(dice.number(-0.2, 0.2), dice.number(-0.2, 0.2), 1.0);
    REQUIRE(find_segment_hit(tree, soup.x, above, above + 2.0 * (target - above)));
  }
}

TEST_CASE("triangles near a segment equal brute force over their boxes and miss none in reach") {
  // a thousand poses
  for_each_soup([](const Soup& soup, const AabbTree& tree, const Vec3Array& x) {
    Dice dice(27);
    std::vector<int> out(soup.triangles.size());
    for (int q = 0; q < 60; ++q) {
      const Vec3 from = pick_point(soup, x, dice);
      const Vec3 to = q % 4 == 0 ? from : pick_point(soup, x, dice);
      const double radius = std::pow(10.0, dice.number(-4, -1));
      const int count = find_near_segment(tree, x, from, to, radius, out);
      std::vector<bool> listed(soup.triangles.size());
      for (int i = 0; i < count; ++i)
        listed[static_cast<std::size_t>(out[static_cast<std::size_t>(i)])] = true;
      REQUIRE(std::is_sorted(out.begin(), out.begin() + count));

      for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        const Corners k = find_corners(soup, x, t);
        // the segment in small pieces: one within the radius must be listed; and what is listed
        // has a box that is nowhere farther than the corner of a cube
        const Vec3 low = k.a.cwiseMin(k.b).cwiseMin(k.c), high = k.a.cwiseMax(k.b).cwiseMax(k.c);
        double nearest = kInfinity, cube = kInfinity;
        for (int i = 0; i <= 32; ++i) {
          const Vec3 p = from + (i / 32.0) * (to - from);
          nearest = std::min(nearest, find_closest_on_triangle(p, k.a, k.b, k.c).distance);
          cube = std::min(cube, (low - p).cwiseMax(p - high).cwiseMax(0.0).maxCoeff());
        }
        const double piece = (to - from).norm() / 64.0;
        if (nearest <= radius) REQUIRE(listed[static_cast<std::size_t>(t)]);
        if (cube > radius * (1.0 + 1e-9) + piece) REQUIRE(!listed[static_cast<std::size_t>(t)]);
      }
    }
  });
}

TEST_CASE("a list that is too short holds the lowest triangles and tells how many there are") {
  const Soup soup = make_coplanar_soup(10);
  const AabbTree tree(soup.x, soup.triangles);
  std::vector<int> all(soup.triangles.size()), few(5), none;
  const Vec3 centre(0.08, 0.08, 0.0);

  const int count = find_in_sphere(tree, soup.x, centre, 0.03, all);

  REQUIRE(count > 20);
  CHECK(find_in_sphere(tree, soup.x, centre, 0.03, few) == count);
  CHECK(std::equal(few.begin(), few.end(), all.begin()));
  CHECK(find_in_sphere(tree, soup.x, centre, 0.03, none) == count);
  CHECK(find_near_segment(tree, soup.x, centre, centre, 0.03, few) >= count);
}

TEST_CASE("questions without sense have no answer") {
  const Soup soup = make_plain_soup(50);
  const AabbTree tree(soup.x, soup.triangles), empty;
  const Vec3 nan = Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), p(0, 0, 0);
  std::vector<int> out(50);

  CHECK_FALSE(find_closest_point(empty, {}, p));
  CHECK_FALSE(find_segment_hit(empty, {}, p, {1, 0, 0}));
  CHECK(find_in_sphere(empty, {}, p, 1.0, out) == 0);
  CHECK_FALSE(find_closest_point(tree, soup.x, nan));
  CHECK_FALSE(find_segment_hit(tree, soup.x, p, nan));
  CHECK_FALSE(find_segment_hit(tree, soup.x, nan, p));
  CHECK_FALSE(find_ray_hit(tree, soup.x, p, nan));
  CHECK(find_in_sphere(tree, soup.x, nan, 1.0, out) == 0);
  CHECK(find_in_sphere(tree, soup.x, p, -1.0, out) == 0);
  CHECK(find_near_segment(tree, soup.x, nan, p, 1.0, out) == 0);
}

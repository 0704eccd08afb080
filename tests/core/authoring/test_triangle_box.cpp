// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "palpate/authoring/triangle_box.h"

namespace palpate::authoring {
namespace {

using Vector = TriangleBox::Vector;
using Corners = std::array<Vector, 3>;

constexpr Vector kLow{-1.0, -1.0, -1.0}, kHigh{1.0, 1.0, 1.0};

bool may_meet(const Corners& triangle) { return TriangleBox(triangle, kLow, kHigh).may_meet(); }

/// Cuts a triangle off at each side of a cube about 0: whether anything is left of it.
bool is_cut(const Corners& triangle, double half) {
  std::vector<Vector> left(triangle.begin(), triangle.end());
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double side : {-1.0, 1.0}) {
      std::vector<Vector> kept;
      for (std::size_t i = 0; i < left.size(); ++i) {
        const Vector &p = left[i], &q = left[(i + 1) % left.size()];
        const double a = half - side * p[k], b = half - side * q[k];
        if (a >= 0.0) kept.push_back(p);
        if ((a < 0.0) == (b < 0.0)) continue;
        Vector between{};
        for (std::size_t c = 0; c < 3; ++c) between[c] = p[c] + (q[c] - p[c]) * a / (a - b);
        kept.push_back(between);
      }
      left = kept;
    }
  }
  return !left.empty();
}

/// That bounds overlap is known to who asks.
bool overlaps(const Corners& x) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax({x[0][k], x[1][k], x[2][k]});
    if (low > kHigh[k] || high < kLow[k]) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a triangle within a box, through it or on its corner meets it") {
  CHECK(may_meet({{{0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}, {0.0, 0.0, 0.1}}}));
  CHECK(may_meet({{{-9.0, -9.0, 0.0}, {9.0, -9.0, 0.0}, {0.0, 9.0, 0.0}}}));
  // x + y + z = 3
  CHECK(may_meet({{{3.0, 0.0, 0.0}, {0.0, 3.0, 0.0}, {0.0, 0.0, 3.0}}}));
}

TEST_CASE("a triangle past a corner, or past an edge, of a box does not meet it") {
  // x + y + z = 3.1, and x + y = 2.1 beyond an edge
  CHECK(!may_meet({{{3.1, 0.0, 0.0}, {0.0, 3.1, 0.0}, {0.0, 0.0, 3.1}}}));
  CHECK(!may_meet({{{2.1, 0.0, 0.0}, {0.0, 2.1, 0.0}, {1.05, 1.05, 0.5}}}));
}

TEST_CASE("a triangle of no area meets a box as the line does that it is") {
  CHECK(may_meet({{{-2.0, -2.0, -2.0}, {0.0, 0.0, 0.0}, {2.0, 2.0, 2.0}}}));
  CHECK(!may_meet({{{2.2, -0.1, 0.0}, {1.05, 1.05, 0.0}, {-0.1, 2.2, 0.0}}}));
}

TEST_CASE("no triangle that a box cuts is missed, and nearly none that it does not is taken") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-3.0, 3.0);
  int met = 0, apart = 0;
  for (int i = 0; i < 20'000; ++i) {
    Corners x{};
    for (Vector& corner : x) corner = {number(random), number(random), number(random)};
    if (!overlaps(x)) continue;
    if (is_cut(x, 1.0)) {
      ++met;
      CHECK(may_meet(x));
    } else if (!is_cut(x, 1.0 + 1e-9)) {
      ++apart;
      CHECK(!may_meet(x));
    }
  }
  CHECK(met > 1000);
  CHECK(apart > 1000);
}

TEST_CASE("a triangle on the side of a box far from the origin meets it, whatever rounding does") {
  const double far = 1e3 + 1.0 / 3.0;
  const Corners x{{{far + 0.1, -5.0, -5.0}, {far + 0.1, 5.0, -5.0}, {far + 0.1, 0.0, 5.0}}};

  CHECK(TriangleBox(x, {far, 0.0, 0.0}, {far + 0.1, 0.1, 0.1}).may_meet());
}

}  // namespace palpate::authoring

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "palpate/sim/tree/aabb_tree.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {

/// Triangles without order, good and bad, for comparison with brute force.
struct Soup {
  std::string name;
  Vec3Array x;
  std::vector<Triangle> triangles;

  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const int i = static_cast<int>(x.size());
    x.insert(x.end(), {a, b, c});
    triangles.push_back({i, i + 1, i + 2});
  }
};

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double number(double low, double high) {
    // the engine's bits are the same everywhere, the library's distributions are not
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  Vec3 vector(double size) {
    const double a = number(-size, size), b = number(-size, size), c = number(-size, size);
    return {a, b, c};
  }
  int index(int count) { return static_cast<int>(number(0.0, count)); }

 private:
  std::mt19937 engine_;
};

inline Soup make_plain_soup(int count) {
  Dice dice(1);
  Soup soup{"plain", {}, {}};
  for (int t = 0; t < count; ++t) {
    const Vec3 centre = dice.vector(0.1);
    soup.add(centre + dice.vector(0.02), centre + dice.vector(0.02), centre + dice.vector(0.02));
  }
  return soup;
}

/// Slivers of every thinness, segments and points, some of them twice.
inline Soup make_degenerate_soup(int count) {
  Dice dice(2);
  Soup soup{"degenerate", {}, {}};
  for (int t = 0; t < count; ++t) {
    const Vec3 a = dice.vector(0.1), b = a + dice.vector(0.05);
    const Vec3 on_edge = a + dice.number(-0.5, 1.5) * (b - a);
    switch (t % 6) {
      case 0:
        soup.add(a, a, a);
        break;
      case 1:
        soup.add(a, b, b);
        break;
      case 2:
        soup.add(a, b, on_edge);
        break;
      case 3:
        soup.add(a, on_edge + dice.vector(1e-9), b);
        break;
      case 4:
        soup.add(a, b, on_edge + dice.vector(std::pow(10.0, dice.number(-14, -3))));
        break;
      default:
        soup.triangles.push_back(soup.triangles[static_cast<std::size_t>(t / 2)]);
    }
  }
  return soup;
}

/// One flat grid in the plane z = 0, all squares alike, and a copy of it on top: nothing but ties.
inline Soup make_coplanar_soup(int side) {
  Soup soup{"coplanar", {}, {}};
  for (int i = 0; i <= side; ++i) {
    for (int j = 0; j <= side; ++j) soup.x.push_back(Vec3(i, j, 0.0) / 64.0);
  }
  for (int copy = 0; copy < 2; ++copy) {
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const int a = i * (side + 1) + j, b = a + side + 1;
        soup.triangles.push_back({a, b, b + 1});
        soup.triangles.push_back({a, b + 1, a + 1});
      }
    }
  }
  return soup;
}

/// From nanometres to kilometres in one tree.
inline Soup make_far_apart_soup(int count) {
  Dice dice(3);
  Soup soup{"far apart", {}, {}};
  for (int t = 0; t < count; ++t) {
    const Vec3 centre = dice.vector(1.0).normalized() * std::pow(10.0, dice.number(-6, 3));
    const double size = std::pow(10.0, dice.number(-9, 2));
    soup.add(centre + dice.vector(size), centre + dice.vector(size), centre + dice.vector(size));
  }
  return soup;
}

/// Every triangle at one place: no plane parts them.
inline Soup make_stacked_soup(int count) {
  Soup soup{"stacked", {}, {}};
  for (int t = 0; t < count; ++t) soup.add({-1, -1, 0}, {1, -1, 0}, {0, 2, 0});
  return soup;
}

/// Centres at 2^-k: each plane between bins parts off only the largest few.
inline Soup make_geometric_soup(int count) {
  Soup soup{"geometric", {}, {}};
  for (int t = 0; t < count; ++t) {
    const double s = std::ldexp(1.0, -t);
    soup.add({s, 0, 0}, {s, s, 0}, {s, 0, s});
  }
  return soup;
}

/// Larger or smaller than any float, which the boxes are held in.
inline Soup make_scaled_soup(int count, double scale) {
  Soup soup = make_plain_soup(count);
  soup.name = "scaled";
  for (Vec3& x : soup.x) x *= scale;
  return soup;
}

inline std::vector<Soup> make_soups() {
  return {make_plain_soup(400),        make_degenerate_soup(300),   make_coplanar_soup(10),
          make_far_apart_soup(300),    make_stacked_soup(40),       make_geometric_soup(60),
          make_scaled_soup(100, 1e45), make_scaled_soup(100, 1e-45)};
}

/// Bends, twists and shakes positions, by as much as their own size.
inline Vec3Array deform(const Vec3Array& x, unsigned seed) {
  Dice dice(seed);
  Vec3Array y;
  for (const Vec3& p : x) {
    const double angle = 8.0 * p.z() + 3.0 * p.x();
    const Vec3 twisted(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                       std::sin(angle) * p.x() + std::cos(angle) * p.y(), p.z() + 2.0 * p.x());
    y.push_back(twisted + dice.vector(0.3 * p.norm()));
  }
  return y;
}

/// A point to ask from: near a corner, on the surface, on a corner, or anywhere about.
inline Vec3 pick_point(const Soup& soup, const Vec3Array& x, Dice& dice) {
  const Triangle& t =
      soup.triangles[static_cast<std::size_t>(dice.index(static_cast<int>(soup.triangles.size())))];
  const Vec3 &a = x[static_cast<std::size_t>(t[0])], &b = x[static_cast<std::size_t>(t[1])],
             &c = x[static_cast<std::size_t>(t[2])];
  const double size = (b - a).norm() + (c - a).norm() + 1e-6;
  switch (dice.index(5)) {
    case 0:
      return a;
    case 1:
      return 0.5 * a + 0.5 * b;
    case 2:
      return 0.25 * a + 0.5 * b + 0.25 * c;
    case 3:
      return a + dice.vector(size);
    default:
      return dice.vector(2.0 * (a.norm() + size));
  }
}

}  // namespace palpate

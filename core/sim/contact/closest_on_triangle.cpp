// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/contact/box.h"
#include "palpate/sim/contact/queries.h"

namespace palpate {
namespace {

/// Where along a -> b, from 0 to 1, the point closest to p lies; 0 for an edge of no length.
double find_on_edge(const Vec3& p, const Vec3& a, const Vec3& b) noexcept {
  const Vec3 edge = b - a;
  const double squared_length = square(edge);
  if (!(squared_length > 0.0)) return 0.0;
  return std::clamp(dot_in_order(p - a, edge) / squared_length, 0.0, 1.0);
}

/// Keeps the nearer of `best`, whose distance is still squared, and the point with these weights.
/// The point is held inside the box of the triangle, so that no rounding makes it nearer than its
/// boxes in the tree.
void keep_nearer(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, const Box& box,
                 const Vec3& weights, SurfacePoint& best) noexcept {
  Vec3 point = weights[0] * a + weights[1] * b + weights[2] * c;
  point = point.cwiseMax(box.low).cwiseMin(box.high);
  const double squared_distance = square(p - point);
  if (squared_distance < best.distance) {
    best.weights = weights;
    best.point = point;
    best.distance = squared_distance;
  }
}

/// The closest point, its distance squared.
SurfacePoint find_closest_squared(const Vec3& p, const Vec3& a, const Vec3& b,
                                  const Vec3& c) noexcept {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double aa = square(ab), cc = square(ac), bc = dot_in_order(ab, ac);
  const double determinant = aa * cc - bc * bc;
  const Box box = bound_triangle(a, b, c);
  SurfacePoint best;
  best.distance = std::numeric_limits<double>::infinity();

  if (determinant > 0.0) {
    const double d1 = dot_in_order(ab, ap), d2 = dot_in_order(ac, ap);
    const double v = (cc * d1 - bc * d2) / determinant, w = (aa * d2 - bc * d1) / determinant;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) {
      keep_nearer(p, a, b, c, box, {1.0 - (v + w), v, w}, best);
      if (determinant > kSliver * aa * cc) return best;
    }
  }
  const double on_ab = find_on_edge(p, a, b);
  const double on_bc = find_on_edge(p, b, c);
  const double on_ca = find_on_edge(p, c, a);
  keep_nearer(p, a, b, c, box, {1.0 - on_ab, on_ab, 0.0}, best);
  keep_nearer(p, a, b, c, box, {0.0, 1.0 - on_bc, on_bc}, best);
  keep_nearer(p, a, b, c, box, {on_ca, 0.0, 1.0 - on_ca}, best);
  return best;
}

}  // namespace

/// The closest point lies at the foot of the perpendicular where that falls inside, otherwise on
/// an edge [Ericson04]. Telling which edge from signs, as usual, fails on slivers whose signs are
/// rounding errors; here every candidate is a point of the triangle and the nearest one wins, so
/// a wrong sign costs no more than rounding.
///
/// tree_distances-inl.h does the same operations in the same order for four triangles at once.
SurfacePoint find_closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b,
                                      const Vec3& c) noexcept {
  SurfacePoint best = find_closest_squared(p, a, b, c);
  best.distance = std::sqrt(best.distance);
  return best;
}

}  // namespace palpate

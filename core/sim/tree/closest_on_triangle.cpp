// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/tree/private/box.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {
namespace {

/// Where along an edge the closest point lies, from 0 to 1; 0 for an edge of no length.
double find_on_edge(const Vec3& from_start, const Vec3& edge) noexcept {
  const double squared_length = square(edge);
  if (!(squared_length > 0.0)) return 0.0;
  return std::clamp(dot_in_order(from_start, edge) / squared_length, 0.0, 1.0);
}

/// Weights of a point, and the square of its distance.
struct Found {
  double square;
  Vec3 weights;
};

void keep_nearer(const Vec3& offset, const Vec3& weights, Found& best) noexcept {
  const double found = square(offset);
  if (found < best.square) best = {found, weights};
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
  const Vec3 ab = b - a, ac = c - a, bc = c - b, ap = p - a, bp = p - b;
  const double on_ab = find_on_edge(ap, ab), on_ac = find_on_edge(ap, ac),
               on_bc = find_on_edge(bp, bc);
  Found best = {square(ap - on_ab * ab), {1.0 - on_ab, on_ab, 0.0}};
  keep_nearer(ap - on_ac * ac, {1.0 - on_ac, 0.0, on_ac}, best);
  keep_nearer(bp - on_bc * bc, {0.0, 1.0 - on_bc, on_bc}, best);

  const double aa = square(ab), cc = square(ac), ac_on_ab = dot_in_order(ab, ac);
  const double determinant = aa * cc - ac_on_ab * ac_on_ab, inverse = 1.0 / determinant;
  const double d1 = dot_in_order(ap, ab), d2 = dot_in_order(ap, ac);
  const double v = (cc * d1 - ac_on_ab * d2) * inverse, w = (aa * d2 - ac_on_ab * d1) * inverse;
  if (determinant > 0.0 && v >= 0.0 && w >= 0.0 && v + w <= 1.0) {
    const double found = square(ap - (v * ab + w * ac));
    if (kSliver * aa * cc < determinant || found < best.square) {
      best = {found, {1.0 - (v + w), v, w}};
    }
  }
  // held inside the box of the triangle, so that no rounding makes it nearer than its boxes in
  // the tree
  const Vec3 weighted = best.weights[0] * a + best.weights[1] * b + best.weights[2] * c;
  const Box box = bound_triangle(a, b, c);
  SurfacePoint found;
  found.weights = best.weights;
  found.point = weighted.cwiseMax(box.low).cwiseMin(box.high);
  found.distance = std::sqrt(square(p - found.point));
  return found;
}

}  // namespace palpate

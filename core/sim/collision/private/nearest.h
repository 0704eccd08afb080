// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/tree/private/box.h"
#include "palpate/sim/tree/private/tree_kernels.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {

/// The point of a triangle that is nearest to p.
struct NearPoint {
  Vec3 weights = Vec3::Zero();  ///< barycentric
  Vec3 offset = Vec3::Zero();   ///< [m] from it to p
  double square = 0.0;          ///< [m²] of the offset
  double height = 0.0;          ///< [m] of p over the plane
  Vec3 normal = Vec3::Zero();   ///< unit, of the plane
};

/// Of a triangle at a, b = a + ab and c = a + ac: the nearest point of its three sides to a + ap.
inline void find_on_sides(const Vec3& ap, const Vec3& ab, const Vec3& ac,
                          NearPoint& near) noexcept {
  const auto along = [](const Vec3& from, const Vec3& side) noexcept {
    return std::clamp(dot_in_order(from, side) / square(side), 0.0, 1.0);
  };
  const Vec3 bc = ac - ab, bp = ap - ab;
  const double t = along(ap, ab), u = along(ap, ac), v = along(bp, bc);
  const Vec3 offsets[] = {ap - t * ab, ap - u * ac, bp - v * bc};
  const Vec3 weights[] = {{1.0 - t, t, 0.0}, {1.0 - u, 0.0, u}, {0.0, 1.0 - v, v}};
  near.square = square(offsets[0]);
  std::size_t best = 0;
  for (std::size_t side = 1; side < 3; ++side) {
    const double found = square(offsets[side]);
    if (!(found < near.square)) continue;
    near.square = found;
    best = side;
  }
  near.offset = offsets[best];
  near.weights = weights[best];
}

/// The nearest point of a triangle to p, unless that is farther than the square `most` [m²] by more
/// than rounding: of barycentric weights outside of a triangle, p is beyond that side's line in the
/// plane by weight times height of the triangle over it, and nothing of it is nearer. Of slivers by
/// find_closest_on_triangle(), which is right for any.
inline bool find_within(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, double most,
                        NearPoint& near) noexcept {
  // [-], [m²] far above what rounding does to the bound, far below what a tie is
  constexpr double kRelative = 1.0 + 1e-6, kAbsolute = 1e-24;
  const Vec3 ab = b - a, ac = c - a, ap = p - a, cross = ab.cross(ac);
  const double bb = square(ab), cc = square(ac), crossed = square(cross);
  near = {};
  if (!(crossed > tree_kernels::kHealthySquare * bb * cc)) {
    const SurfacePoint found = find_closest_on_triangle(p, a, b, c);
    near.weights = found.weights;
    near.offset = p - found.point;
    near.square = square(near.offset);
    return true;
  }
  const double bc = dot_in_order(ab, ac), pb = dot_in_order(ap, ab), pc = dot_in_order(ap, ac);
  const double inverse = 1.0 / crossed;
  const double v = (cc * pb - bc * pc) * inverse, w = (bb * pc - bc * pb) * inverse;
  const double over = dot_in_order(ap, cross), u = 1.0 - v - w;
  const double left = (most * kRelative + kAbsolute - over * over * inverse) * inverse;
  if (left < 0.0 || (w < 0.0 && w * w > left * bb) || (v < 0.0 && v * v > left * cc) ||
      (u < 0.0 && u * u > left * (bb + cc - 2.0 * bc))) {
    return false;
  }
  near.normal = cross / std::sqrt(crossed);
  near.height = dot_in_order(ap, near.normal);
  if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) {
    near.weights = {1.0 - v - w, v, w};
    near.offset = near.height * near.normal;
    near.square = near.height * near.height;
  } else {
    find_on_sides(ap, ab, ac, near);
  }
  return true;
}

/// Likewise, however far.
inline NearPoint find_near_point(const Vec3& p, const Vec3& a, const Vec3& b,
                                 const Vec3& c) noexcept {
  NearPoint near;
  find_within(p, a, b, c, std::numeric_limits<double>::infinity(), near);
  return near;
}

/// Whether a point of another triangle, by its square and height, is to be taken for the nearest in
/// place of the one that is. Where several triangles share the point, the one that p is highest
/// over or deepest under tells the side: over an edge, the plane of another may lie on either.
inline bool is_nearer(double square, double height, double nearest_square,
                      double nearest_height) noexcept {
  const double slack = tree_kernels::kTie * nearest_square;
  if (square > nearest_square + slack) return false;
  return square < nearest_square - slack || std::abs(height) > std::abs(nearest_height);
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: from a point to
// triangles.
#if defined(PALPATE_TREE_DISTANCES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_TREE_DISTANCES_INL_H
#undef PALPATE_TREE_DISTANCES_INL_H
#else
#define PALPATE_TREE_DISTANCES_INL_H
#endif

#include "palpate/sim/contact/tree_points-inl.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

/// Where along an edge of this squared length the closest point lies, from 0 to 1.
PALPATE_TREE_INLINE Four find_on_edge(Four along, Four squared_length) {
  const Four zero = set(0.0);
  const Four share = max(min(along / squared_length, set(1.0)), zero);
  return select(zero < squared_length, share, zero);
}

/// Where on each triangle, and how far from there.
struct Found {
  Four square, u, v, w;
};

/// Keeps the nearer.
PALPATE_TREE_INLINE void keep_nearer(const Points& way, Four u, Four v, Four w, Found& best) {
  const Four found = square(way);
  const Mask nearer = found < best.square;
  best = {min(found, best.square), select(nearer, u, best.u), select(nearer, v, best.v),
          select(nearer, w, best.w)};
}

/// [m²] From p to the closest point of each triangle: find_closest_on_triangle(), the same
/// operations in the same order.
PALPATE_TREE_INLINE Four measure_triangles(const Points& p, const Corners& corners) {
  const auto& [a, b, c] = corners;
  const Four zero = set(0.0), one = set(1.0);
  const Points ab = b - a, ac = c - a, bc = c - b, ap = p - a, bp = p - b;
  const Four aa = square(ab), cc = square(ac), ac_on_ab = dot(ab, ac);
  const Four on_ab = find_on_edge(dot(ap, ab), aa), on_ac = find_on_edge(dot(ap, ac), cc);
  const Four on_bc = find_on_edge(dot(bp, bc), square(bc));
  Found best = {square(ap - on_ab * ab), one - on_ab, on_ab, zero};
  keep_nearer(ap - on_ac * ac, one - on_ac, zero, on_ac, best);
  keep_nearer(bp - on_bc * bc, zero, one - on_bc, on_bc, best);

  const Four determinant = aa * cc - ac_on_ab * ac_on_ab, inverse = one / determinant;
  const Four d1 = dot(ap, ab), d2 = dot(ap, ac);
  const Four v = (cc * d1 - ac_on_ab * d2) * inverse, w = (aa * d2 - ac_on_ab * d1) * inverse;
  const Mask inside = ((zero < determinant) & (zero <= v)) & ((zero <= w) & (v + w <= one));
  const Mask nearer = inside & ((set(kSliver) * aa * cc < determinant) |
                                (square(ap - (v * ab + w * ac)) < best.square));
  const Points point = select(nearer, one - (v + w), best.u) * a + select(nearer, v, best.v) * b +
                       select(nearer, w, best.w) * c;
  return square(p - min(max(point, min(min(a, b), c)), max(max(a, b), c)));
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_DISTANCES_INL_H

// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: from a point to triangles.
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

/// What find_closest_on_triangle() takes from four triangles at once.
struct Sight {
  Points p;
  Corners corners;
  Points low, high;
};

/// [m²] From p to the points with these weights, held inside the boxes of their triangles.
PALPATE_TREE_INLINE Four measure_point(const Sight& sight, const Points& weighted) {
  return square(sight.p - min(max(weighted, sight.low), sight.high));
}

/// Where along an edge of this squared length the closest point lies, from 0 to 1.
PALPATE_TREE_INLINE Four find_on_edge(Four along, Four squared_length) {
  const Four zero = set(0.0);
  const Four share = max(min(along / squared_length, set(1.0)), zero);
  return select(zero < squared_length, share, zero);
}

/// [m] From p to the closest point of each triangle: find_closest_on_triangle(), the same
/// operations in the same order.
PALPATE_TREE_INLINE Four measure_triangles(const Points& p, const Corners& corners) {
  const auto& [a, b, c] = corners;
  const Sight sight = {p, corners, min(min(a, b), c), max(max(a, b), c)};
  const Four zero = set(0.0), one = set(1.0);
  const Points ab = b - a, ac = c - a, ap = p - a;
  const Four aa = square(ab), cc = square(ac), bc = dot(ab, ac);
  const Four determinant = aa * cc - bc * bc;
  const Four d1 = dot(ab, ap), d2 = dot(ac, ap);
  const Four v = (cc * d1 - bc * d2) / determinant, w = (aa * d2 - bc * d1) / determinant;
  const Mask inside = ((zero < determinant) & (zero <= v)) & ((zero <= w) & (v + w <= one));
  const Four face = measure_point(sight, (one - (v + w)) * a + v * b + w * c);
  const Mask flat = inside & (set(kSliver) * aa * cc < determinant);

  const Points edge = c - b;
  const Four on_ab = find_on_edge(d1, aa);
  const Four on_bc = find_on_edge(dot(p - b, edge), square(edge));
  const Four on_ca = find_on_edge(dot(p - c, a - c), cc);
  const Four beside = min(min(measure_point(sight, (one - on_ab) * a + on_ab * b),
                              measure_point(sight, (one - on_bc) * b + on_bc * c)),
                          measure_point(sight, on_ca * a + (one - on_ca) * c));
  return sqrt(select(flat, face, min(beside, select(inside, face, beside))));
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_DISTANCES_INL_H

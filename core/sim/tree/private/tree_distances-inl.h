// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: from a point or a
// offset to triangles.
#if defined(PALPATE_TREE_DISTANCES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_TREE_DISTANCES_INL_H
#undef PALPATE_TREE_DISTANCES_INL_H
#else
#define PALPATE_TREE_DISTANCES_INL_H
#endif

#include "palpate/sim/tree/private/tree_points-inl.h"

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
PALPATE_TREE_INLINE void keep_nearer(const Points& offset, Four u, Four v, Four w, Found& best) {
  const Four found = square(offset);
  const Mask nearer = found < best.square;
  best = {min(found, best.square), select(nearer, u, best.u), select(nearer, v, best.v),
          select(nearer, w, best.w)};
}

/// The closest point of each triangle to p as find_closest_on_triangle() weighs it, by the same
/// operations in the same order. The distance is that before rounding is taken out of the point.
PALPATE_TREE_INLINE Found find_nearest(const Points& p, const Corners& corners) {
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
  const Four within = square(ap - (v * ab + w * ac));
  const Mask nearer = inside & ((set(kSliver) * aa * cc < determinant) | (within < best.square));
  return {select(nearer, within, best.square), select(nearer, one - (v + w), best.u),
          select(nearer, v, best.v), select(nearer, w, best.w)};
}

/// [m²] From p to the closest points: the last of find_closest_on_triangle().
PALPATE_TREE_INLINE Four measure_found(const Points& p, const Corners& corners,
                                       const Found& found) {
  const auto& [a, b, c] = corners;
  const Points point = found.u * a + found.v * b + found.w * c;
  return square(p - min(max(point, min(min(a, b), c)), max(max(a, b), c)));
}

/// [m] By how much the distances of find_nearest() and measure_found() may differ at most: the
/// weights are the same, and of what is done with them each operation rounds once.
inline double bound_rounding(const AabbTree& tree, const Vec3& p) noexcept {
  return 8.0 * compute_slack(tree.low(), tree.high(), p, p);
}

/// As enter_box().
PALPATE_TREE_INLINE Four enter_boxes(const Segment& segment, const Points& low,
                                     const Points& high) {
  const Four infinity = set(std::numeric_limits<double>::infinity());
  const Four zero = set(0.0), grow = set(segment.grow);
  const Four lows[3] = {low.x, low.y, low.z}, highs[3] = {high.x, high.y, high.z};
  Four in = zero, out = set(segment.end);
  for (int k = 0; k < 3; ++k) {
    const Four from = set(segment.from[k]);
    const Four to_low = (lows[k] - grow) - from, to_high = (highs[k] + grow) - from;
    if (segment.direction[k] == 0.0) {
      in = select((to_low <= zero) & (zero <= to_high), in, infinity);
      continue;
    }
    const Four inverse = set(segment.inverse[k]);
    const Four t0 = to_low * inverse, t1 = to_high * inverse;
    in = max(in, min(t0, t1));
    out = min(out, max(t0, t1));
  }
  return select(in <= out, in, infinity);
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_DISTANCES_INL_H

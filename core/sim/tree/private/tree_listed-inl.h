// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: of some triangles
// each, those that are nearest to four points.
#if defined(PALPATE_TREE_LISTED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_TREE_LISTED_INL_H
#undef PALPATE_TREE_LISTED_INL_H
#else
#define PALPATE_TREE_LISTED_INL_H
#endif

#include "palpate/sim/tree/private/tree_points-inl.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

PALPATE_TREE_INLINE Points cross(const Points& a, const Points& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
PALPATE_TREE_INLINE Points select(Mask mask, const Points& a, const Points& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
PALPATE_TREE_INLINE Four magnitude(Four a) { return max(a, set(0.0) - a); }
PALPATE_TREE_INLINE Four clamp_share(Four share) { return max(min(share, set(1.0)), set(0.0)); }

/// As NearPoint, one per lane.
struct NearPoints {
  Points weights, offset, normal;
  Four square, height;
};

/// As find_on_sides().
PALPATE_TREE_INLINE void find_on_sides(const Points& ap, const Points& ab, const Points& ac,
                                       Four on_ab, Four on_ac, NearPoints& near) {
  const Four zero = set(0.0), one = set(1.0);
  const Points bc = ac - ab, bp = ap - ab;
  const Four t = clamp_share(on_ab), u = clamp_share(on_ac);
  const Four v = clamp_share(dot(bp, bc) / dot(bc, bc));
  near.offset = ap - t * ab;
  near.weights = {one - t, t, zero};
  near.square = dot(near.offset, near.offset);
  const auto keep_nearer = [&](const Points& offset, const Points& weights) {
    const Four square = dot(offset, offset);
    const Mask nearer = square < near.square;
    near.square = select(nearer, square, near.square);
    near.offset = select(nearer, offset, near.offset);
    near.weights = select(nearer, weights, near.weights);
  };
  keep_nearer(ap - u * ac, {one - u, zero, u});
  keep_nearer(bp - v * bc, {zero, one - v, v});
}

/// As find_near_point(); bits of the triangles that are slivers are left out of `healthy`.
PALPATE_TREE_INLINE NearPoints find_near_points(const Points& p, const Corners& corners,
                                                unsigned& healthy) {
  const auto& [a, b, c] = corners;
  const Four zero = set(0.0), one = set(1.0);
  const Points ab = b - a, ac = c - a, ap = p - a, across = cross(ab, ac);
  const Four bb = dot(ab, ab), cc = dot(ac, ac);
  const Four square = dot(across, across);
  healthy &= bits((set(kHealthySquare) * bb) * cc < square);
  const Four bc = dot(ab, ac), pb = dot(ap, ab), pc = dot(ap, ac);
  const Four inverse = one / square;
  const Four v = (cc * pb - bc * pc) * inverse, w = (bb * pc - bc * pb) * inverse;
  const Mask inside = ((zero <= v) & (zero <= w)) & (v + w <= one);
  NearPoints near;
  const Four length = sqrt(square);
  near.normal = {across.x / length, across.y / length, across.z / length};
  near.height = dot(ap, near.normal);
  const Points weights = {(one - v) - w, v, w}, offset = near.height * near.normal;
  const Four height_square = near.height * near.height;
  if (bits(inside) == 0b1111) {
    near.weights = weights;
    near.offset = offset;
    near.square = height_square;
    return near;
  }
  find_on_sides(ap, ab, ac, pb / bb, pc / cc, near);
  near.weights = select(inside, weights, near.weights);
  near.offset = select(inside, offset, near.offset);
  near.square = select(inside, height_square, near.square);
  return near;
}

inline unsigned find_nearest_listed(std::span<const Triangle> triangles, std::span<const Vec3> x,
                                    const FourLists& lists, FourNearest& found) noexcept {
  std::size_t most = 0;
  for (const auto& list : lists.triangles) most = std::max(most, list.size());
  Four rows[4];
  for (std::size_t k = 0; k < 4; ++k) rows[k] = load_point(*lists.points[k]);
  Points p;
  transpose(rows, p.x, p.y, p.z);
  unsigned healthy = 0b1111;
  NearPoints best;
  Four best_number = set(0.0);
  for (std::size_t n = 0; n < most; ++n) {
    const Triangle* chosen[4];
    alignas(32) double numbers[4];
    for (std::size_t k = 0; k < 4; ++k) {
      // a list that has ended goes on with its last triangle, which is chosen no second time
      const std::span<const int> list = lists.triangles[k];
      const int number = list[std::min(n, list.size() - 1)];
      chosen[k] = &triangles[static_cast<std::size_t>(number)];
      numbers[k] = number;
    }
    const Corners corners = {gather(x, chosen, 0), gather(x, chosen, 1), gather(x, chosen, 2)};
    const NearPoints near = find_near_points(p, corners, healthy);
    const Four number = load(numbers);
    if (n == 0) {
      best = near;
      best_number = number;
      continue;
    }
    const Four slack = set(kTie) * best.square;
    const Mask taken =
        (near.square <= best.square + slack) &
        ((near.square < best.square - slack) | (magnitude(best.height) < magnitude(near.height)));
    best.weights = select(taken, near.weights, best.weights);
    best.offset = select(taken, near.offset, best.offset);
    best.normal = select(taken, near.normal, best.normal);
    best.square = select(taken, near.square, best.square);
    best.height = select(taken, near.height, best.height);
    best_number = select(taken, number, best_number);
  }
  const auto keep = [](const Points& points, double(&to)[3][4]) {
    store(points.x, to[0]);
    store(points.y, to[1]);
    store(points.z, to[2]);
  };
  keep(best.weights, found.weights);
  keep(best.offset, found.offset);
  keep(best.normal, found.normal);
  store(best.square, found.square);
  store(best.height, found.height);
  store(best_number, found.triangle);
  return healthy;
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_LISTED_INL_H

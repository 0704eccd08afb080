// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: points, one per
// lane.
#if defined(PALPATE_TREE_POINTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_TREE_POINTS_INL_H
#undef PALPATE_TREE_POINTS_INL_H
#else
#define PALPATE_TREE_POINTS_INL_H
#endif

#include <array>

#include "palpate/sim/tree/private/tree_kernels.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

/// One point or vector per lane.
struct Points {
  Four x, y, z;
};

PALPATE_TREE_INLINE Points operator+(const Points& a, const Points& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
PALPATE_TREE_INLINE Points operator-(const Points& a, const Points& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
PALPATE_TREE_INLINE Points operator*(Four s, const Points& a) {
  return {s * a.x, s * a.y, s * a.z};
}
PALPATE_TREE_INLINE Points min(const Points& a, const Points& b) {
  return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)};
}
PALPATE_TREE_INLINE Points max(const Points& a, const Points& b) {
  return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)};
}
/// As dot_in_order().
PALPATE_TREE_INLINE Four dot(const Points& a, const Points& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
PALPATE_TREE_INLINE Four square(const Points& a) { return dot(a, a); }
PALPATE_TREE_INLINE Points set_points(const Vec3& p) {
  return {set(p.x()), set(p.y()), set(p.z())};
}

/// Four triangles; one that is wanting is the last once more.
struct Corners {
  Points a, b, c;
};

PALPATE_TREE_INLINE Points gather(std::span<const Vec3> x, const Triangle* const (&triangles)[4],
                                  std::size_t corner) {
  Four rows[4];
  for (std::size_t k = 0; k < 4; ++k) {
    rows[k] = load_point(x[static_cast<std::size_t>((*triangles[k])[corner])]);
  }
  Points points;
  transpose(rows, points.x, points.y, points.z);
  return points;
}

/// The triangles of a leaf.
PALPATE_TREE_INLINE Corners gather_leaf(const AabbTree& tree, std::span<const Vec3> x, int first,
                                        int count) {
  const Triangle* start = tree.leaf_triangles().data() + first;
  const Triangle* const triangles[4] = {start, start + std::min(1, count - 1),
                                        start + std::min(2, count - 1),
                                        start + std::min(3, count - 1)};
  return {gather(x, triangles, 0), gather(x, triangles, 1), gather(x, triangles, 2)};
}

/// Bits of the triangles that a leaf has.
PALPATE_TREE_INLINE unsigned filled(int count) { return (1u << count) - 1u; }

/// Takes the lowest bit out of `set` and returns its place.
PALPATE_TREE_INLINE std::size_t take_lowest(unsigned& set) {
  const auto place = static_cast<std::size_t>(std::countr_zero(set));
  set &= set - 1;
  return place;
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_POINTS_INL_H

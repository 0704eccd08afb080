// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: the queries.
#if defined(PALPATE_TREE_QUERIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_TREE_QUERIES_INL_H
#undef PALPATE_TREE_QUERIES_INL_H
#else
#define PALPATE_TREE_QUERIES_INL_H
#endif

#include "palpate/sim/tree/private/tree_boxes-inl.h"
#include "palpate/sim/tree/private/tree_distances-inl.h"
#include "palpate/sim/tree/private/tree_listed-inl.h"
#include "palpate/sim/tree/private/tree_refit-inl.h"
#include "palpate/sim/tree/private/tree_walk-inl.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

PALPATE_TREE_INLINE int triangle_at(const AabbTree& tree, int first, std::size_t lane) {
  return tree.order()[static_cast<std::size_t>(first) + lane];
}

/// The triangles of a leaf.
PALPATE_TREE_INLINE std::span<const int> leaf_order(const AabbTree& tree, int first, int count) {
  return tree.order().subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
}

/// Whether a segment along z may pass inside: the first refusal of find_hit(), by the same
/// operations.
PALPATE_TREE_INLINE unsigned pass_inside(const Shear& shear, Four ax, Four ay, Four az, Four bx,
                                         Four by, Four bz, Four cx, Four cy, Four cz) {
  const Four sx = set(shear.sx), sy = set(shear.sy), zero = set(0.0);
  const Four a_x = ax - sx * az, a_y = ay - sy * az;
  const Four b_x = bx - sx * bz, b_y = by - sy * bz;
  const Four c_x = cx - sx * cz, c_y = cy - sy * cz;
  const Four u = c_x * b_y - c_y * b_x;
  const Four v = a_x * c_y - a_y * c_x;
  const Four w = b_x * a_y - b_y * a_x;
  const Four least = min(min(u, v), w), most = max(max(u, v), w);
  return bits((zero <= least) | (most <= zero));
}

/// kAxis is shear.kz, known to the compiler: a branch by it would be guessed wrongly in most
/// leaves.
template <int kAxis>
PALPATE_TREE_INLINE unsigned pass_inside(const Shear& shear, const Corners& k, const Points& from) {
  const Points a = k.a - from, b = k.b - from, c = k.c - from;
  if constexpr (kAxis == 0) {
    return pass_inside(shear, a.y, a.z, a.x, b.y, b.z, b.x, c.y, c.z, c.x);
  } else if constexpr (kAxis == 1) {
    return pass_inside(shear, a.z, a.x, a.y, b.z, b.x, b.y, c.z, c.x, c.y);
  } else {
    return pass_inside(shear, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
  }
}

template <int kAxis>
inline SurfacePoint find_first_along(const AabbTree& tree, std::span<const Vec3> x,
                                     const Segment& segment, const Shear& shear,
                                     double length) noexcept {
  const Slabs slabs(segment);
  const Points from = set_points(segment.from);
  SurfacePoint best;
  best.distance = std::numeric_limits<double>::max();
  // a box that is missed measures infinity and is never wanted
  float most = std::numeric_limits<float>::max();
  walk_nearest_first(
      tree, [&](const AabbTree::Node& node) { return enter_boxes(slabs, node); },
      [&] { return most; },
      [&](int first, int count) {
        unsigned passed =
            pass_inside<kAxis>(shear, gather_leaf(tree, x, first, count), from) & filled(count);
        while (passed != 0) {
          const std::size_t lane = take_lowest(passed);
          const Triangle& t = tree.leaf_triangles()[static_cast<std::size_t>(first) + lane];
          const auto hit =
              find_hit(shear, segment, length, x[static_cast<std::size_t>(t[0])],
                       x[static_cast<std::size_t>(t[1])], x[static_cast<std::size_t>(t[2])]);
          if (!hit) continue;
          const int triangle = triangle_at(tree, first, lane);
          if (!is_better(hit->distance, triangle, best.distance, best.triangle)) continue;
          best = *hit;
          best.triangle = triangle;
          most = std::min(widen(best.distance / length), std::numeric_limits<float>::max());
        }
      });
  return best;
}

inline std::optional<SurfacePoint> find_first_hit(const AabbTree& tree, std::span<const Vec3> x,
                                                  const Segment& segment, double length) noexcept {
  const Shear shear(segment.direction);
  const auto find = shear.kz == 0   ? &find_first_along<0>
                    : shear.kz == 1 ? &find_first_along<1>
                                    : &find_first_along<2>;
  const SurfacePoint best = find(tree, x, segment, shear, length);
  if (best.triangle < 0) return std::nullopt;
  return best;
}

inline int find_closest(const AabbTree& tree, std::span<const Vec3> x, const Vec3& point,
                        double max_distance) noexcept {
  const Points p = set_points(point);
  const Cell cell(point);
  double nearest = max_distance, most = square_upwards(max_distance);
  const double rounding = tree.nodes().empty() ? 0.0 : bound_rounding(tree, point);
  double perhaps = square_upwards(max_distance + rounding);
  float widened = widen(most);
  int best = -1;
  walk_nearest_first(
      tree, [&](const AabbTree::Node& node) { return measure_distances(cell, node); },
      [&] { return widened; },
      [&](int first, int count) {
        const Corners corners = gather_leaf(tree, x, first, count);
        const Found found = find_nearest(p, corners);
        if ((bits(found.square <= set(perhaps)) & filled(count)) == 0) return;
        const Four square = measure_found(p, corners, found);
        unsigned wanted = bits(square <= set(most)) & filled(count);
        alignas(32) double distances[4];
        store(sqrt(square), distances);
        while (wanted != 0) {
          const std::size_t lane = take_lowest(wanted);
          const int triangle = triangle_at(tree, first, lane);
          if (!is_better(distances[lane], triangle, nearest, best)) continue;
          nearest = distances[lane];
          best = triangle;
        }
        most = square_upwards(nearest);
        perhaps = square_upwards(nearest + rounding);
        widened = widen(most);
      });
  return best;
}

inline void collect_in_sphere(const AabbTree& tree, std::span<const Vec3> x, const Vec3& centre,
                              double radius, Collector& collector) noexcept {
  const Points p = set_points(centre);
  const Cell cell(centre);
  // nearly all triangles are surely inside or surely not; only the others are measured to the bit
  const double rounding = tree.nodes().empty() ? 0.0 : bound_rounding(tree, centre);
  const double less = radius - 2.0 * rounding;
  const double surely = less > 0.0 ? less * less : -1.0;
  const double perhaps = square_upwards(radius + rounding);
  walk(
      tree, [&](const AabbTree::Node& node) { return measure_distances(cell, node); },
      widen(square_upwards(radius)),
      [&](int first, int count) {
        const Corners corners = gather_leaf(tree, x, first, count);
        const Found found = find_nearest(p, corners);
        unsigned inside = bits(found.square <= set(surely));
        if ((bits(found.square <= set(perhaps)) & filled(count) & ~inside) != 0) {
          inside = bits(sqrt(measure_found(p, corners, found)) <= set(radius));
        }
        collector.add(leaf_order(tree, first, count), inside & filled(count));
      });
}

inline void collect_near_segment(const AabbTree& tree, std::span<const Vec3> x,
                                 const Segment& segment, Collector& collector) noexcept {
  const Slabs slabs(segment);
  const double most = std::numeric_limits<double>::max();
  walk(
      tree, [&](const AabbTree::Node& node) { return enter_boxes(slabs, node); },
      std::numeric_limits<float>::max(),
      [&](int first, int count) {
        const Corners k = gather_leaf(tree, x, first, count);
        const Four in = enter_boxes(segment, min(min(k.a, k.b), k.c), max(max(k.a, k.b), k.c));
        const unsigned entered = bits(in <= set(most)) & filled(count);
        collector.add(leaf_order(tree, first, count), entered);
      });
}

/// Writes no more than `out` holds, which is not less than the tree has.
inline int list_near_segment(const AabbTree& tree, const Segment& segment,
                             std::span<int> out) noexcept {
  const Slabs slabs(segment);
  std::size_t found = 0;
  walk(
      tree, [&](const AabbTree::Node& node) { return enter_boxes(slabs, node); },
      std::numeric_limits<float>::max(),
      [&](int first, int count) {
        const std::span<const int> leaf = leaf_order(tree, first, count);
        const std::size_t taken = std::min(leaf.size(), out.size() - found);
        std::copy_n(leaf.begin(), taken, out.begin() + static_cast<std::ptrdiff_t>(found));
        found += taken;
      });
  return static_cast<int>(found);
}

/// All of it, for the table.
inline Kernels list_kernels(const char* target) {
  return {target,
          &refit,
          &refit_moving,
          &find_first_hit,
          &find_closest,
          &collect_in_sphere,
          &collect_near_segment,
          &list_near_segment,
          &find_nearest_listed};
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_QUERIES_INL_H

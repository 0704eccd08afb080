// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: the queries.
#if defined(PALPATE_TREE_QUERIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_TREE_QUERIES_INL_H
#undef PALPATE_TREE_QUERIES_INL_H
#else
#define PALPATE_TREE_QUERIES_INL_H
#endif

#include "palpate/sim/contact/tree_distances-inl.h"
#include "palpate/sim/contact/tree_refit-inl.h"
#include "palpate/sim/contact/tree_walk-inl.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

PALPATE_TREE_INLINE int triangle_at(const AabbTree& tree, int first, std::size_t lane) {
  return tree.order()[static_cast<std::size_t>(first) + lane];
}

/// Whether a way along z may pass inside: the first refusal of find_hit(), by the same operations.
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

PALPATE_TREE_INLINE unsigned pass_inside(const Shear& shear, const Corners& k, const Points& from) {
  const Points a = k.a - from, b = k.b - from, c = k.c - from;
  switch (shear.kz) {
    case 0:
      return pass_inside(shear, a.y, a.z, a.x, b.y, b.z, b.x, c.y, c.z, c.x);
    case 1:
      return pass_inside(shear, a.z, a.x, a.y, b.z, b.x, b.y, c.z, c.x, c.y);
    default:
      return pass_inside(shear, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
  }
}

inline std::optional<SurfacePoint> find_first_hit(const AabbTree& tree, std::span<const Vec3> x,
                                                  const Way& way, double length) noexcept {
  const Shear shear(way.direction);
  const Points from = set_points(way.from);
  SurfacePoint best;
  // a box that is missed measures infinity and is never wanted
  best.distance = std::numeric_limits<double>::max();
  double most = best.distance;
  walk_nearest_first(
      tree,
      [&](const AabbTree::Node& node) { return enter_boxes(way, load_low(node), load_high(node)); },
      [&] { return most; },
      [&](int first, int count) {
        unsigned passed =
            pass_inside(shear, gather_leaf(tree, x, first, count), from) & filled(count);
        while (passed != 0) {
          const int triangle = triangle_at(tree, first, take_lowest(passed));
          const Triangle& t = tree.triangles()[static_cast<std::size_t>(triangle)];
          const auto hit =
              find_hit(shear, way, length, x[static_cast<std::size_t>(t[0])],
                       x[static_cast<std::size_t>(t[1])], x[static_cast<std::size_t>(t[2])]);
          if (!hit || !is_better(hit->distance, triangle, best.distance, best.triangle)) continue;
          best = *hit;
          best.triangle = triangle;
          most = best.distance / length * (1.0 + 8.0 * std::numeric_limits<double>::epsilon());
        }
      });
  if (best.triangle < 0) return std::nullopt;
  return best;
}

inline int find_closest(const AabbTree& tree, std::span<const Vec3> x, const Vec3& point,
                        double max_distance) noexcept {
  const Points p = set_points(point);
  double nearest = max_distance, most = square_upwards(max_distance);
  int best = -1;
  walk_nearest_first(
      tree,
      [&](const AabbTree::Node& node) {
        return measure_distances(p, load_low(node), load_high(node));
      },
      [&] { return most; },
      [&](int first, int count) {
        const Four square = measure_triangles(p, gather_leaf(tree, x, first, count));
        unsigned wanted = bits(square <= set(most)) & filled(count);
        if (wanted == 0) return;
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
      });
  return best;
}

inline void collect_in_sphere(const AabbTree& tree, std::span<const Vec3> x, const Vec3& centre,
                              double radius, Collector& collector) noexcept {
  const Points p = set_points(centre);
  const double most = square_upwards(radius);
  walk(
      tree,
      [&](const AabbTree::Node& node) {
        return measure_distances(p, load_low(node), load_high(node));
      },
      most,
      [&](int first, int count) {
        const Four square = measure_triangles(p, gather_leaf(tree, x, first, count));
        unsigned inside = bits(sqrt(square) <= set(radius)) & filled(count);
        while (inside != 0) collector.add(triangle_at(tree, first, take_lowest(inside)));
      });
}

inline void collect_near_way(const AabbTree& tree, std::span<const Vec3> x, const Way& way,
                             Collector& collector) noexcept {
  const double most = std::numeric_limits<double>::max();
  walk(
      tree,
      [&](const AabbTree::Node& node) { return enter_boxes(way, load_low(node), load_high(node)); },
      most,
      [&](int first, int count) {
        const Corners k = gather_leaf(tree, x, first, count);
        const Four in = enter_boxes(way, min(min(k.a, k.b), k.c), max(max(k.a, k.b), k.c));
        unsigned entered = bits(in <= set(most)) & filled(count);
        while (entered != 0) collector.add(triangle_at(tree, first, take_lowest(entered)));
      });
}

/// All of it, for the table.
inline Kernels list_kernels(const char* target) {
  return {target,           &refit,        &refit_moving,
          &find_first_hit,  &find_closest, &collect_in_sphere,
          &collect_near_way};
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_QUERIES_INL_H

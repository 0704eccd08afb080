// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tree/queries.h"

#include <cmath>

#include "palpate/sim/tree/private/tree_kernels.h"

namespace palpate {
namespace {

/// [m] Plainly where the squares are safe numbers, which is nearly always.
double measure_length(const Vec3& direction) noexcept {
  const double squared = square(direction);
  return squared > 1e-200 && squared < 1e200 ? std::sqrt(squared) : direction.stableNorm();
}

/// [m] For the whole surface and a segment.
double find_slack(const AabbTree& tree, const Vec3& from, const Vec3& to) noexcept {
  return compute_slack(tree.low(), tree.high(), from, to);
}

}  // namespace

std::optional<SurfacePoint> find_segment_hit(const AabbTree& tree, std::span<const Vec3> x,
                                             const Vec3& from, const Vec3& to) noexcept {
  const Vec3 direction = to - from;
  const double length = measure_length(direction);
  if (tree.nodes().empty() || !(length > 0.0)) return std::nullopt;
  const Segment segment{from, direction, 1.0, find_slack(tree, from, to)};
  return tree_kernels::best().find_first_hit(tree, x, segment, length);
}

std::optional<SurfacePoint> find_ray_hit(const AabbTree& tree, std::span<const Vec3> x,
                                         const Vec3& origin, const Vec3& direction) noexcept {
  const double length = measure_length(direction);
  if (tree.nodes().empty() || !(length > 0.0)) return std::nullopt;
  const Segment segment{origin, direction.stableNormalized(), std::numeric_limits<double>::max(),
                        find_slack(tree, origin, origin)};
  return tree_kernels::best().find_first_hit(tree, x, segment, 1.0);
}

std::optional<SurfacePoint> find_closest_point(const AabbTree& tree, std::span<const Vec3> x,
                                               const Vec3& p, double max_distance) noexcept {
  if (!(max_distance >= 0.0) || !p.allFinite()) return std::nullopt;
  const int triangle = tree_kernels::best().find_closest(tree, x, p, max_distance);
  if (triangle < 0) return std::nullopt;
  const Triangle& t = tree.triangles()[static_cast<std::size_t>(triangle)];
  SurfacePoint found = find_closest_on_triangle(p, x[static_cast<std::size_t>(t[0])],
                                                x[static_cast<std::size_t>(t[1])],
                                                x[static_cast<std::size_t>(t[2])]);
  found.triangle = triangle;
  return found;
}

int find_in_sphere(const AabbTree& tree, std::span<const Vec3> x, const Vec3& centre, double radius,
                   std::span<int> out) noexcept {
  if (!(radius >= 0.0) || !centre.allFinite()) return 0;
  Collector collector(out);
  tree_kernels::best().collect_in_sphere(tree, x, centre, radius, collector);
  return collector.finish();
}

int find_near_segment(const AabbTree& tree, std::span<const Vec3> x, const Vec3& from,
                      const Vec3& to, double radius, std::span<int> out) noexcept {
  // a slab test passes over NaN, so it must not get as far
  if (tree.nodes().empty() || !(radius >= 0.0) || !from.allFinite() || !to.allFinite()) return 0;
  Collector collector(out);
  const Segment segment{from, to - from, 1.0, radius + find_slack(tree, from, to)};
  tree_kernels::best().collect_near_segment(tree, x, segment, collector);
  return collector.finish();
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>

#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

// All queries take the positions `x` the tree was last refitted to. None allocates. Ties are
// settled by the lower triangle index, so answers do not depend on the shape of the tree.

struct SurfacePoint {
  int triangle = -1;
  Vec3 weights = Vec3::Zero();  ///< barycentric, in [0, 1], sum 1
  Vec3 point = Vec3::Zero();    ///< [m]
  double distance = 0.0;        ///< [m] from where the query began
};
static_assert(sizeof(SurfacePoint) == 64 && alignof(SurfacePoint) == 8);

/// The closest point of one triangle; degenerate triangles are segments or points.
/// Fills weights, point and distance.
SurfacePoint find_closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b,
                                      const Vec3& c) noexcept;

/// The first triangle on the segment from `from` to `to`, both sides counting; none if the segment
/// is clear. No segment slips between triangles that share an edge. A segment within the plane of a
/// triangle crosses its neighbours, not itself; a segment of no length crosses nothing.
std::optional<SurfacePoint> find_segment_hit(const AabbTree& tree, std::span<const Vec3> x,
                                             const Vec3& from, const Vec3& to) noexcept;

/// The first triangle along a ray, as for a segment; `direction` of any length but zero, distances
/// in metres.
std::optional<SurfacePoint> find_ray_hit(const AabbTree& tree, std::span<const Vec3> x,
                                         const Vec3& origin, const Vec3& direction) noexcept;

/// The closest surface point within max_distance [m].
std::optional<SurfacePoint> find_closest_point(
    const AabbTree& tree, std::span<const Vec3> x, const Vec3& p,
    double max_distance = std::numeric_limits<double>::infinity()) noexcept;

/// Triangles with a point inside the ball or on it; ascending. Returns how many there are; only
/// as many as `out` holds are written, those with the lowest indices.
int find_in_sphere(const AabbTree& tree, std::span<const Vec3> x, const Vec3& centre, double radius,
                   std::span<int> out) noexcept;

/// Triangles whose boxes, grown by `radius` [m] on every side, meet the segment: a superset of
/// those that touch the capsule; ascending. Returns how many there are; only as many as `out`
/// holds are written, those with the lowest indices.
int find_near_segment(const AabbTree& tree, std::span<const Vec3> x, const Vec3& from,
                      const Vec3& to, double radius, std::span<int> out) noexcept;

}  // namespace palpate

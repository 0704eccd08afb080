// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/contact/private/list_contacts.h"
#include "palpate/sim/contact/private/touched_surface.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate {

std::vector<unsigned char> find_border(std::span<const Triangle> triangles) {
  const Topology topology = build_topology(triangles);
  std::vector<unsigned char> border(triangles.size(), 0);
  bool open = false;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto edge = static_cast<std::size_t>(topology.triangle_edges[t][k]);
      const auto [first, second] = topology.edge_triangles[edge];
      if (first >= 0 && second >= 0) continue;
      border[t] = static_cast<unsigned char>(border[t] | 1u << k);
      open = true;
    }
  }
  return open ? border : std::vector<unsigned char>();
}

namespace {

/// Of all points of a surface the one that is closest to a tool.
struct NearestPoint {
  double square = std::numeric_limits<double>::infinity();  // [m²] of the distance
  double facing = 0.0;     // [-] cosine of arm and normal: of triangles that share it the clearest
  bool on_border = false;  // of one of them
};

/// Relative: triangles whose closest points are equally far share that point.
constexpr double kEquallyFar = 1e-9;

bool is_on_border(unsigned char border, const Vec3& weights) noexcept {
  for (int k = 0; k < 3; ++k) {
    if ((border >> k & 1) != 0 && weights[k] == 0.0) return true;
  }
  return false;
}

NearestPoint find_nearest(const Shape& shape, const TouchedSurface& surface,
                          const Vec3& p) noexcept {
  const Candidates& candidates = *surface.candidates;
  NearestPoint nearest;
  for (std::size_t i = 0; i < static_cast<std::size_t>(candidates.count); ++i) {
    const int t = candidates.triangles[i];
    const Vec3 &a = corner_at(surface, t, 0), &b = corner_at(surface, t, 1);
    const Vec3& c = corner_at(surface, t, 2);
    const ClosestArm closest = find_closest_arm(shape, p, a, b, c);
    const double square = closest.arm.squaredNorm();
    if (square > (1.0 + kEquallyFar) * nearest.square) continue;
    if (square < (1.0 - kEquallyFar) * nearest.square) nearest = {square};
    const Vec3 normal = (b - a).cross(c - a);
    const double length = std::sqrt(square) * normal.norm();
    const double facing = length > 0.0 ? closest.arm.dot(normal) / length : 0.0;
    if (std::abs(facing) > std::abs(nearest.facing)) nearest.facing = facing;
    nearest.on_border |=
        is_on_border(candidates.border[static_cast<std::size_t>(t)], closest.weights);
  }
  return nearest;
}

}  // namespace

void follow_side(const Shape& shape, const TouchedSurface& surface, const Vec3& p) noexcept {
  Candidates& candidates = *surface.candidates;
  if (candidates.border.empty()) return;
  double& side = candidates.near.side;
  if (candidates.count == 0) side = 0.0;
  const bool known = side != 0.0;
  if (candidates.count == 0 || (known && !candidates.at_border)) return;
  const NearestPoint nearest = find_nearest(shape, surface, lift(surface, p));
  const double radius = shape.tool.radius;
  if (known && !nearest.on_border && nearest.square < radius * radius) return;
  if (nearest.facing == 0.0) return;
  const double now = nearest.facing < 0.0 ? -1.0 : 1.0;
  if (now == side) return;
  side = now;
  candidates.lanes.found = candidates.near.found = false;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/collision/private/edge_points.h"

#include "palpate/sim/mesh/topology.h"

namespace palpate {
namespace {

Vec3 find_middle(const std::array<int, 2>& ends, std::span<const Vec3> x) noexcept {
  return 0.5 * (x[static_cast<std::size_t>(ends[0])] + x[static_cast<std::size_t>(ends[1])]);
}

double measure_area(const Triangle& corners, std::span<const Vec3> x) {
  const auto& [a, b, c] = corners;
  const Vec3 &at = x[static_cast<std::size_t>(a)], &to = x[static_cast<std::size_t>(b)];
  return 0.5 * (to - at).cross(x[static_cast<std::size_t>(c)] - at).norm();
}

}  // namespace

EdgePoints::EdgePoints(const SurfaceMesh& edges, const SurfaceMesh& triangles,
                       const Barrier& barrier) {
  const Topology topology = build_topology(edges.triangles);
  std::vector<double> areas;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const auto& [a, b] = topology.edges[e];
    const Vec3 along =
        edges.vertices[static_cast<std::size_t>(b)] - edges.vertices[static_cast<std::size_t>(a)];
    if (!(along.norm() > kLongEdge * barrier.thickness)) continue;
    double area = 0.0;
    for (const int t : topology.edge_triangles[e]) {
      if (t < 0) continue;
      area += measure_area(edges.triangles[static_cast<std::size_t>(t)], edges.vertices) / 4.0;
    }
    ends.push_back(topology.edges[e]);
    areas.push_back(area);
  }
  x.assign(ends.size(), Vec3::Zero());
  before = x;
  contacts = SurfaceContacts(std::move(areas), triangles, barrier);
}

void follow(std::span<const Vec3> x, std::span<const Vec3> before, EdgePoints& points) noexcept {
  for (std::size_t e = 0; e < points.ends.size(); ++e) {
    points.x[e] = find_middle(points.ends[e], x);
    points.before[e] = find_middle(points.ends[e], before);
  }
}

void follow_active(std::span<const Vec3> x, EdgePoints& points) noexcept {
  for (const int point : points.contacts.active_in_use()) {
    const auto e = static_cast<std::size_t>(point);
    points.x[e] = find_middle(points.ends[e], x);
  }
}

}  // namespace palpate

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

using Corners = std::array<Vec3, 3>;

inline Corners corners_of(const SurfaceMesh& mesh, const Triangle& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

/// The angle at p between q and r [rad]; exact for needles, where an arc cosine is not.
inline double angle_at(const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 u = q - p, v = r - p;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

inline double smallest_angle(const Corners& x) {
  double smallest = std::numbers::pi;
  for (int c = 0; c < 3; ++c) {
    smallest = std::min(smallest, angle_at(x[c], x[(c + 1) % 3], x[(c + 2) % 3]));
  }
  return smallest;
}

/// The corner opposite the longest side of a triangle lower than `tolerance` [m]; -1 for one that
/// has an area.
inline int find_flat_corner(const Corners& x, double tolerance) {
  const auto side = [&](int c) -> Vec3 { return x[(c + 2) % 3] - x[(c + 1) % 3]; };
  int corner = 0;
  for (int c = 1; c < 3; ++c) {
    if (side(c).norm() > side(corner).norm()) corner = c;
  }
  const double longest = side(corner).norm();
  const double height = longest > 0.0 ? side(0).cross(side(1)).norm() / longest : 0.0;
  return height <= tolerance ? corner : -1;
}

/// Twice the area long.
inline Vec3 normal_of(const Corners& x) { return (x[1] - x[0]).cross(x[2] - x[0]); }

/// No move, flip or collapse may turn a triangle by 60 degrees or more.
inline constexpr double kLeastCosine = 0.5;

/// Whether two normals differ by 60 degrees or more, or one has no direction.
inline bool is_turned(const Vec3& m, const Vec3& n) {
  return !(m.dot(n) > kLeastCosine * m.norm() * n.norm());
}

}  // namespace palpate::authoring

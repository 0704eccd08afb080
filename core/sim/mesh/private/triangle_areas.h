// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "palpate/sim/base/types.h"

namespace palpate {

/// [m²] per triangle, of vertices x [m].
inline std::vector<double> compute_triangle_areas(std::span<const Vec3> x,
                                                  std::span<const Triangle> triangles) {
  std::vector<double> areas;
  areas.reserve(triangles.size());
  for (const auto& [i, j, k] : triangles) {
    const Vec3& corner = x[static_cast<std::size_t>(i)];
    const Vec3 a = x[static_cast<std::size_t>(j)] - corner;
    const Vec3 b = x[static_cast<std::size_t>(k)] - corner;
    areas.push_back(0.5 * a.cross(b).norm());
  }
  return areas;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "palpate/sim/base/types.h"

namespace palpate::bench {

/// The same surface and the same questions for everyone.
struct Workload {
  Vec3Array x;      ///< [m]
  Vec3Array moved;  ///< [m] where refit follows the surface to
  std::vector<Triangle> triangles;
  Vec3Array from, to;      ///< [m] segments of 0.5 mm at the surface
  Vec3Array beside;        ///< [m] points up to 5 mm outside
  double radius = 1.5e-3;  ///< [m] of balls around those points
};

/// Reads the vertices and triangles of an OBJ file in metres and scatters questions over it.
Workload read_workload(const std::string& obj, int questions);

}  // namespace palpate::bench

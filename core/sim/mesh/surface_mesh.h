// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/base/types.h"

namespace palpate {

/// A triangulated surface, closed or open.
struct SurfaceMesh {
  Vec3Array vertices;               ///< [m] (n, 3)
  std::vector<Triangle> triangles;  ///< (t, 3), counter-clockwise from outside
};

/// Throws std::invalid_argument, naming the first offender, unless every vertex is finite and
/// used, every index in range, no triangle uses a vertex twice or has no area, no edge has more
/// than two triangles, and neighbours agree on which side is outside.
void validate(const SurfaceMesh& mesh);

}  // namespace palpate

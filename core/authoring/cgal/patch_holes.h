// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// What closes one hole.
struct Patch {
  Vec3Array vertices;               ///< inside the hole
  std::vector<Triangle> triangles;  ///< a vertex from n on, where the surface has n, is one of
                                    ///< `vertices`; empty where the hole cannot be closed
};

enum class PatchShape {
  smooth,  ///< refined, and bent so that its curvature goes on over the border
  flat,    ///< refined alone
};

/// A patch for each of the border loops of a manifold surface, given as find_border_loops() does;
/// no two of them may touch.
std::vector<Patch> patch_holes(const SurfaceMesh& mesh, const std::vector<std::vector<int>>& loops,
                               PatchShape shape);

}  // namespace palpate::authoring

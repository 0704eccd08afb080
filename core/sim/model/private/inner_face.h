// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "palpate/sim/mesh/mesh.h"

namespace palpate {

/// [-] Of the outer triangle's area that the inner one must have.
inline constexpr double kLeastInnerArea = 0.1;
/// [-] Of the wall's own distance between its faces, the least that is left in a narrow bend.
inline constexpr double kLeastDepth = 0.25;
/// [-] Of the vertices that may have less: more of them, and the wall is too thick as a whole.
inline constexpr double kMostReduced = 0.5;
/// [-] Of the way to the other side of the body that an inner face may take: two that come from
/// both sides do not meet.
inline constexpr double kFarShare = 0.45;

/// The inner face of a wall, and how far below the outer one it lies.
struct InnerFace {
  SurfaceMesh mesh;
  std::vector<double> depth;  ///< [m] per vertex
};

/// The vertices moved inwards by `distance` [m] along their normals, and less where that would turn
/// a triangle over, or take a vertex past one that comes from the other side. Throws
/// std::invalid_argument, naming a triangle, where that leaves less than kLeastDepth, or reduces
/// more than kMostReduced of the vertices.
InnerFace make_inner_face(const SurfaceMesh& mesh, double distance);

}  // namespace palpate

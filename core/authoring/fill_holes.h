// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// Border edges of the largest hole that is filled: finding its triangles may take the cube of it.
inline constexpr int kMostHoleEdges = 2000;

/// A surface with some of its holes closed.
struct FilledHoles {
  SurfaceMesh mesh;            ///< vertices and triangles of the source first, in their order
  int filled = 0;              ///< holes that are closed now
  std::vector<int> left_open;  ///< those asked for that no patch was found for, ascending
};

/// Closes holes of a surface, given by their numbers in find_border_loops(): each gets the
/// triangulation of least area, refined to the edge lengths around it and bent to go on as its
/// surroundings do (Liepa, SGP 2003, as CGAL has it). Where that crosses the surface the patch
/// stays flat, and where that crosses too the hole stays open; so does one of more than
/// kMostHoleEdges edges, and one that touches another border in a vertex. Throws
/// std::invalid_argument for a surface that does not pass validate(), or numbers it has no holes
/// of.
FilledHoles fill_holes(const SurfaceMesh& mesh, std::span<const int> holes);

}  // namespace palpate::authoring

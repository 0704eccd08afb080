// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// A piece whose bounding box is smaller than this part of the whole's is dropped: a speck of some
/// microns is no organ, and its short edges would ask for a million steps in a second.
inline constexpr double kIsland = 1e-3;

/// A surface without the faults a triangle list can have, and what was done for that.
struct RepairedMesh {
  SurfaceMesh mesh;
  int duplicate_triangles = 0;   ///< dropped: the same three vertices as one before
  int degenerate_triangles = 0;  ///< flatter than the weld tolerance: flipped away or dropped
  int unused_vertices = 0;       ///< dropped
  int split_vertices = 0;        ///< added where surfaces touched only in a vertex
  int parted_edges = 0;          ///< see part_touching_edges()
  int dropped_islands = 0;       ///< pieces smaller than kIsland of the whole
  int turned_triangles = 0;      ///< see orient()
  bool orientable = true;        ///< false: neighbours cannot agree, and still do not
};

/// Drops what is double, flat, unused or a speck, takes apart what touches only in a vertex or
/// along an edge, and orients outwards. Other edges with more than two triangles stay as they are:
/// which of the surfaces to keep there is not to be guessed. Indices must be in range and
/// coordinates finite.
RepairedMesh repair_mesh(const SurfaceMesh& mesh);

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// The surface with the triangles marked in `chosen` made again, of edges about `edge_length` [m]:
/// edges are split, collapsed and flipped, and vertices slide along the surface (Botsch and
/// Kobbelt, SGP 2004, as CGAL has it). Edges between chosen and other triangles, borders, and edges
/// where triangles turn by more than `sharp` [degree] stay where they are, in pieces of that
/// length. The surface must be manifold.
SurfaceMesh remesh_faces(const SurfaceMesh& mesh, const std::vector<char>& chosen,
                         double edge_length, double sharp);

}  // namespace palpate::authoring

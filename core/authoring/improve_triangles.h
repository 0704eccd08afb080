// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/move_vertices.h"
#include "palpate/authoring/source_surface.h"

namespace palpate::authoring {

/// Makes the triangles of `mesh` as even as they will go without a vertex more or less: rounds of
/// edge flips and of moves along the surface, each vertex drawn back to the closest point of
/// `source`. Border vertices slide along the border lines of `outline`, the mesh `source` was made
/// of, and what is `kept` stays. No move makes a bad triangle worse or turns one over.
void improve_triangles(const SurfaceMesh& outline, const SourceSurface& source, const Kept& kept,
                       SurfaceMesh& mesh);

}  // namespace palpate::authoring

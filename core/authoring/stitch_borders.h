// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// A surface whose borders were joined where they lie on each other.
struct StitchedMesh {
  SurfaceMesh mesh;
  int split_edges = 0;      ///< border edges with vertices of other borders on them
  int joined_vertices = 0;  ///< border vertices that became one with another
};

/// Joins borders that lie within `tolerance` [m] of each other: border vertices so near become one,
/// and a border edge with another border's vertex on it is split there (a T-junction). Nothing but
/// borders moves, by at most twice the tolerance. The result may need repair_mesh().
StitchedMesh stitch_borders(const SurfaceMesh& mesh, double tolerance);

}  // namespace palpate::authoring

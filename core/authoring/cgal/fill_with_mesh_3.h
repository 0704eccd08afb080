// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// What CGAL's Mesh_3 makes of a surface that must be closed, manifold, outward and free of
/// crossings: an open one would take the process down.
SolidMesh fill_with_mesh_3(const SurfaceMesh& surface, double cell_size);

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// CGAL's alpha wrap of any triangles with finite corners: closed, manifold, without crossings,
/// around all of them at the distance `offset` [m]; a ball of radius `alpha` [m] rolls into what it
/// keeps open.
SurfaceMesh wrap_triangles(const SurfaceMesh& mesh, double alpha, double offset);

}  // namespace palpate::authoring

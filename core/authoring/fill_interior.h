// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// The most tetrahedra that a fill is begun for: about what a published file may hold.
inline constexpr int kMostTetrahedra = 40'000;

/// [m] The cell size at which about `tetrahedron_count` tetrahedra fill the surface; good to a
/// third. Throws as fill_interior does for the surface.
double choose_cell_size(const SurfaceMesh& surface, int tetrahedron_count);

/// Throws std::invalid_argument, with the smallest size there may be, where `cell_size` [m] is not
/// positive or would fill a closed surface with more than kMostTetrahedra.
void check_cell_size(const SurfaceMesh& surface, double cell_size);

/// Tetrahedra of about `cell_size` [m] that fill a closed surface, slivers perturbed and exuded.
/// Their outside lies within a seventh of `cell_size` of the surface but has other vertices: the
/// surface rides on them as a Skin. The same surface and size give the same tetrahedra.
/// Throws std::invalid_argument for a surface that does not pass validate(), is open, faces
/// inwards or crosses itself, and for a cell size that gives no body or too large a one.
SolidMesh fill_interior(const SurfaceMesh& surface, double cell_size);

}  // namespace palpate::authoring

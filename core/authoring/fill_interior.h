// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// [-] How much a cell may grow over its own length, away from where a filling is finer.
inline constexpr double kGrowth = 0.4;

/// The most tetrahedra that a fill is begun for: about what a published file may hold.
inline constexpr int kMostTetrahedra = 40'000;

/// [-] By how much another number of tetrahedra may come than was asked for.
inline constexpr double kCountError = 0.1;

/// Where a filling is finer.
struct FineRegion {
  std::vector<int> triangles;  ///< of the surface; none: it is as fine everywhere
  double ratio = 1.0;          ///< [-] above 0 to 1: of the cell size there to that far away
};

/// `tetrahedron_count` tetrahedra that fill the surface, as fill_interior does, but for kCountError
/// where any cell size gives so many; else the nearest number that was found. Cells are
/// tried at several sizes before one is improved. They grow away from `fine` by kGrowth.
SolidMesh fill_to_count(const SurfaceMesh& surface, int tetrahedron_count,
                        const FineRegion& fine = {});

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

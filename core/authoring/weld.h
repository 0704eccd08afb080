// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

struct Welded {
  SurfaceMesh mesh;         ///< no two vertices within the tolerance, every vertex used
  int merged_vertices;      ///< vertices in use that became one with another
  int collapsed_triangles;  ///< triangles that lost a corner to it and are gone
  double largest_move;      ///< how far the vertex that moved furthest did
};

/// Makes vertices closer than `tolerance` one. In the order of the file, each vertex joins the
/// nearest one already kept, or is kept itself where none is near enough: so nothing moves further
/// than the tolerance, however long a chain of close vertices is, and the order stays.
Welded weld(const SurfaceMesh& triangles, double tolerance);

/// The same where only vertices of different groups become one: what is fine within a group stays
/// so. `group` has a number for each vertex.
Welded weld_across(const SurfaceMesh& triangles, double tolerance, std::span<const int> group);

}  // namespace palpate::authoring

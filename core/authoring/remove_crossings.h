// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// What one round made of a surface that crosses itself.
struct UncrossedMesh {
  SurfaceMesh mesh;
  int replaced_triangles = 0;  ///< of the source, taken out; patches stand in their place
  int dropped_pieces = 0;      ///< that nothing held any more, such as the tip of a spike
};

/// Takes out the triangles that cross others, with `rings` rings of neighbours around them, and
/// closes what was opened with patches that cross nothing. Where none is found, where an edge of
/// the surface itself is involved, or where the surface would fall into pieces, it stays as it is.
/// Throws std::invalid_argument for a surface that does not pass validate().
UncrossedMesh remove_crossings(const SurfaceMesh& mesh, int rings);

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// Merges the ends of edges that are much shorter than all others, of which refinement of a
/// surface leaves a few; one alone asks for many times the substeps. Keeps the outside a closed
/// surface, every tetrahedron upright, and a solid without such edges as it is, to the bit.
///
/// @param finest  [-] Of the usual size, where it is meant to be finest; 1 where it is even.
void collapse_short_edges(double finest, SolidMesh& solid);

}  // namespace palpate::authoring

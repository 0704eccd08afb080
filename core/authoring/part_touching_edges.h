// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// How far copies of a vertex are moved apart, as a part of the diagonal: far above the weld
/// tolerance, so that they stay apart, and far below what anybody sees or feels.
inline constexpr double kPartingShare = 1e-4;

/// Takes a surface apart where it touches itself along edges of four, six, ... triangles, as
/// surfaces made of voxels do: round each such edge solid and empty wedges alternate, and the two
/// triangles that bound one solid wedge become neighbours. Where the surface still hangs together
/// at both ends of such an edge, each pair gets a middle of its own. Copies of a vertex move by
/// `distance` [m] into their own solid. Edges whose triangles do not alternate, so that inside and
/// outside cannot be told, stay as they are. Returns how many edges were parted.
int part_touching_edges(SurfaceMesh& mesh, double distance);

/// Cuts a surface along every edge of more than two triangles: of those, the two that agree on a
/// side and go on flattest stay neighbours, then the next two; each that is left ends there. What
/// was told apart is made of pieces with borders, which touch and do not cross. Returns how many
/// edges were cut.
int cut_crowded_edges(SurfaceMesh& mesh);

}  // namespace palpate::authoring

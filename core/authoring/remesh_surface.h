// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// [degree] Where neighbouring triangles turn by more, their edge is a line of the shape.
inline constexpr double kSharpEdge = 60.0;

/// Triangles that remeshing may make, about: what needs more is refused.
inline constexpr double kMostRemeshed = 1e6;

/// Makes a surface of even triangles whose edges are about as long as is asked for at each vertex
/// of it [m]; where lengths change, they do by steps of 1.4, from long ones to short ones. Borders
/// and sharp edges stay where they are, all else stays on the surface. Throws
/// std::invalid_argument for a surface that does not pass validate(), lengths that are not as many
/// as vertices or not positive, or so short that more than kMostRemeshed triangles would come.
SurfaceMesh remesh_surface(const SurfaceMesh& mesh, std::span<const double> edge_lengths);

}  // namespace palpate::authoring

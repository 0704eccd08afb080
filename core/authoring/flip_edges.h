// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// Flips edges whose opposite angles are more than pi together, the worst first, so that smallest
/// angles grow [Delaunay34]. Edges of ridges stay, no triangle turns by 60 degrees or more, and no
/// edge comes to be twice. One pass: edges next to a flipped one wait for the next, and those
/// between vertices that are all `held` (one mark per vertex, or none at all) stay, as do those in
/// `kept`, which ascends. Returns the number of flips.
int flip_edges(SurfaceMesh& mesh, const std::vector<char>& held = {},
               std::span<const std::array<int, 2>> kept = {});

}  // namespace palpate::authoring

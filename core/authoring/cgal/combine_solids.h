// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// The union of `kept` without `taken`, with points of exact arithmetic rounded at the end. Each is
/// one closed manifold that faces outwards and does not cross itself. nullopt where two of them
/// touch in such a way that the result is not a manifold; empty where nothing is left.
std::optional<SurfaceMesh> combine_solids(const std::vector<SurfaceMesh>& kept,
                                          const std::vector<SurfaceMesh>& taken);

}  // namespace palpate::authoring

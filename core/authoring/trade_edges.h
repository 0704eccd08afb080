// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "palpate/authoring/source_surface.h"

namespace palpate::authoring {

/// Gets rid of triangles with an angle below `least` [rad] that no flip and no move can repair:
/// their shortest edge is collapsed and a long edge elsewhere is split, so the counts stay. Border
/// edges and border vertices stay, as do vertices that are `kept` (one mark per vertex, or none at
/// all) and edges between them. Returns how many were traded.
int trade_edges(const SourceSurface& source, double least, SurfaceMesh& mesh,
                const std::vector<char>& kept = {});

}  // namespace palpate::authoring

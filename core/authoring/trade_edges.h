// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/source_surface.h"

namespace palpate::authoring {

/// Gets rid of triangles with an angle below `least` [rad] that no flip and no move can repair:
/// their shortest edge is collapsed and a long edge elsewhere is split, so the counts stay. Border
/// edges and border vertices stay. Returns how many were traded.
int trade_edges(const SourceSurface& source, double least, SurfaceMesh& mesh);

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "palpate/authoring/feature_lines.h"
#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// A hole keeps at least this many border vertices, so that it stays a hole and not a slit.
inline constexpr int kSmallestLoop = 6;

/// Collapses edges, cheapest first, until `vertex_count` are left or no edge may go any more.
///
/// The price is the quadric error [GarlandHeckbert97]: squared distances to the planes of the
/// triangles, to planes across the border, so holes keep their shape, and a little to the vertices
/// that went, so the ones that stay are spread evenly. No triangle may turn by 90 degrees or more;
/// border vertices move along the border only. `mesh` must pass validate().
SurfaceMesh collapse_edges(const SurfaceMesh& mesh, int vertex_count);

/// A surface with fewer edges, and the lines that are left on it.
struct CollapsedMesh {
  SurfaceMesh mesh;
  FeatureLines lines;
};

/// The same, but that vertices of `lines` move along them only and corners not at all; the price
/// counts planes through the lines as it does those through the border. Distances to the planes of
/// triangle t count `weights[t]` times.
CollapsedMesh collapse_edges(const SurfaceMesh& mesh, int vertex_count, const FeatureLines& lines,
                             std::span<const double> weights);

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// A coarser surface, and how far it is from the one it was made of.
struct DecimatedMesh {
  SurfaceMesh mesh;
  double smallest_angle_before_deg;  ///< edges collapsed, triangles not yet improved
  double smallest_angle_deg;
  double mean_distance;  ///< [m] from the new surface's triangles to the source
  double max_distance;   ///< [m] no point of either is further from the other
  std::optional<int> self_intersecting_faces;  ///< absent where counting would take too long
};

/// A surface of exactly `vertex_count` vertices with well-shaped triangles, of the same shells and
/// holes. Closed stays closed, a hole stays open. Throws std::invalid_argument, saying how far it
/// got, where that many cannot be reached, and for a mesh that does not pass validate().
DecimatedMesh decimate(const SurfaceMesh& mesh, int vertex_count);

}  // namespace palpate::authoring

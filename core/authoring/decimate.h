// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// What a coarser surface keeps beside the shape that its vertices are spread over.
struct DecimateOptions {
  /// (t) a number per triangle, or none at all: borders between different ones stay on their lines
  std::vector<int> regions = {};
  /// (t) The same of what is only named: its borders stay where few of the vertices are on lines
  std::vector<int> names = {};
  /// Ridges (kRidgeTurn) stay on their lines, thin parts count for more, and no vertex goes over to
  /// the other side of one.
  bool features = false;
};

/// A coarser surface, and how far it is from the one it was made of.
struct DecimatedMesh {
  SurfaceMesh mesh;
  double smallest_angle_before_deg;  ///< edges collapsed, triangles not yet improved
  double smallest_angle_deg;
  double mean_distance;  ///< [m] from the new surface's triangles to the source
  double max_distance;   ///< [m] no point of either is further from the other
  std::optional<int> self_intersecting_faces;  ///< absent where counting would take too long
  double kept_length = 0.0;      ///< [m] of the lines that were asked for and are kept
  double left_out_length = 0.0;  ///< [m] of those that so few vertices have no room for
};

/// A surface of exactly `vertex_count` vertices with well-shaped triangles, of the same shells and
/// holes. Closed stays closed, a hole stays open. Throws std::invalid_argument, saying how far it
/// got, where that many cannot be reached, and for a mesh that does not pass validate().
///
/// Lines that options ask for are kept all together. Where there are not vertices enough for them,
/// borders of names are left out first, then ridges, then regions, and left_out_length says so.
/// Ridges are left out as well where a triangle of theirs has less than 20 degrees and without them
/// none has, hardly further from the source.
DecimatedMesh decimate(const SurfaceMesh& mesh, int vertex_count,
                       const DecimateOptions& options = {});

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// How many values lie between one limit and the next; the last limit belongs to the last count.
struct Histogram {
  std::vector<double> limits;  ///< ascending, one more than there are counts; none of no values
  std::vector<int> counts;
};

/// [degree] Every corner of every triangle, in steps of ten from 0 to 180.
Histogram count_angles(const SurfaceMesh& mesh);

struct EdgeLengths {
  double shortest = 0.0, median = 0.0, longest = 0.0;  ///< [m]
  Histogram lengths;  ///< [m] in 20 steps of equal ratio from the shortest that is none to the
                      ///< longest; all together where they are of one length
};

/// Every edge once, whatever the number of its triangles.
EdgeLengths measure_edges(const SurfaceMesh& mesh);

/// A triangle is on a thin part where the body behind it is thinner than this part of its edges:
/// its two sides are then too coarse to be bent apart from each other.
inline constexpr double kThinPart = 0.5;

/// Triangles looked behind, spread evenly over the list.
inline constexpr int kThicknessLooks = 4000;

struct Thickness {
  int looks = 0;                   ///< triangles behind which the body ends somewhere
  std::vector<int> thin_faces;     ///< of those, ascending
  std::optional<double> thinnest;  ///< [m] least of them
};

/// How thick the body is behind its triangles: from the middle of each straight inwards to where
/// the surface is left again. Nothing of a surface without triangles or with a coordinate that is
/// not finite.
Thickness measure_thickness(const SurfaceMesh& mesh);

/// [m] (t) The same behind every triangle; infinite where the body does not end.
std::vector<double> list_thicknesses(const SurfaceMesh& mesh);

}  // namespace palpate::authoring

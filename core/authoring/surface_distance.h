// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/source_surface.h"

namespace palpate::authoring {

/// How far the points of one surface are from another.
struct SurfaceDistance {
  double mean;   ///< [m] over its area, by the middles of its triangles
  double least;  ///< [m] a point of it is this far away
  double most;   ///< [m] no point of it is further away
};

/// Of every point of `from` to `onto`, of whose triangles `tree` was made. The furthest is between
/// `least` and `most`, which differ by a hundredth, or by a hundred-thousandth of the diagonal of
/// `from`, where that can be found in seconds; `most` is a bound in any case.
///
/// Distance to a triangle is convex, so over a polygon it is largest in a corner. Triangles of
/// `from` are cut where the nearest triangle of `onto` ends, and again, until that bound will do
/// for every piece [Tang09].
SurfaceDistance measure_distance(const SurfaceMesh& from, const SurfaceMesh& onto,
                                 const SourceSurface& tree);

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/surface_distance.h"

namespace palpate::authoring {

/// Sides from which a surface is looked at, spread over the sphere.
inline constexpr int kSides = 64;

/// [-] of the diagonal: how far apart the rays of one side are.
inline constexpr double kSightGrid = 0.01;

/// Points of a surface that are seen from far away, past all of its other triangles: where parallel
/// rays from kSides sides first meet it. A thing that is narrower than the rays are apart may be
/// missed, and what lies within a cleft so narrow that no side looks into it. Coordinates must be
/// finite, and there must be a triangle.
Vec3Array find_seen_points(const SurfaceMesh& mesh);

/// From what is seen of `from` to the surface of which `tree` was made: `least` is the furthest of
/// its points, `most` that and how far apart the rays are; the mean is over the points.
SurfaceDistance measure_seen_distance(const SurfaceMesh& from, const SourceSurface& tree);

}  // namespace palpate::authoring

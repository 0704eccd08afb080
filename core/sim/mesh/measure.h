// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/mesh/surface_mesh.h"

namespace palpate {

/// [m²]
double compute_area(const SurfaceMesh& mesh);

/// [m³], positive when the triangles run counter-clockwise from outside; a number without
/// meaning for an open surface.
double compute_volume(const SurfaceMesh& mesh);

/// [m²] per vertex: a third of every triangle around it. Sums to compute_area.
std::vector<double> compute_vertex_areas(const SurfaceMesh& mesh);

/// Unit normals per vertex, weighted by area; zero where the triangles cancel out.
Vec3Array compute_vertex_normals(std::span<const Vec3> vertices,
                                 std::span<const Triangle> triangles);

/// Smallest corner angle of any triangle [rad]; 0 where there is none.
double compute_smallest_angle(const SurfaceMesh& mesh);

/// Lower and upper corner of the axis-aligned box [m].
std::array<Vec3, 2> compute_bounds(std::span<const Vec3> vertices);

/// [m] from corner to corner of the bounding box.
double compute_diagonal(std::span<const Vec3> vertices);

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/base/types.h"

namespace palpate {

/// A triangulated surface, closed or open.
struct SurfaceMesh {
  Vec3Array vertices;               ///< [m] (n, 3)
  std::vector<Triangle> triangles;  ///< (t, 3), counter-clockwise from outside
};

/// Throws std::invalid_argument, naming the first offender, unless every vertex is finite and
/// used, every index in range, no triangle uses a vertex twice or has no area, no edge has more
/// than two triangles, and neighbours agree on which side is outside.
void validate(const SurfaceMesh& mesh);

/// A body cut into tetrahedra.
struct SolidMesh {
  Vec3Array vertices;                          ///< [m] (n, 3)
  std::vector<std::array<int, 4>> tetrahedra;  ///< (t, 4), (b - a) x (c - a) towards d
};

/// Throws std::invalid_argument, naming the first offender, unless every vertex is finite and
/// used, every index in range, every tetrahedron has a positive volume, and no face has more than
/// two.
void validate(const SolidMesh& solid);

/// [m³] of the tetrahedron a b c d, negative where it is turned inside out.
inline double compute_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
  return (b - a).cross(c - a).dot(d - a) / 6.0;
}

/// [m³] in all.
double compute_volume(const SolidMesh& solid);

/// The faces that only one tetrahedron has, counter-clockwise from outside, in the order of the
/// tetrahedra.
std::vector<Triangle> find_boundary(const SolidMesh& solid);

/// Vertex pairs along which some tetrahedron has an edge, ends ascending, sorted.
std::vector<std::array<int, 2>> find_edges(const SolidMesh& solid);

/// [rad] The smallest angle between two faces of any tetrahedron.
double compute_smallest_dihedral(const SolidMesh& solid);

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

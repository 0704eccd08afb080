// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/base/types.h"

namespace palpate {

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

}  // namespace palpate

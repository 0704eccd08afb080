// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/mesh/mesh.h"

namespace palpate {

// Any triangles will do here, damaged ones too, so a repair can ask; indices must not be negative.

/// Who is next to whom on a surface.
struct Topology {
  std::vector<std::array<int, 2>> edges;           ///< vertex pairs, ends ascending, sorted
  std::vector<std::array<int, 2>> edge_triangles;  ///< one or two of each edge, -1 for none
  std::vector<std::array<int, 3>> triangle_edges;  ///< edge opposite corner c of each triangle
};

/// Only the first two triangles of an edge are kept; count_non_manifold_edges tells of others.
Topology build_topology(std::span<const Triangle> triangles);

/// Edges with more than two triangles, or whose two triangles run along it in the same direction.
int count_non_manifold_edges(std::span<const Triangle> triangles);

/// Border loops as lists of vertices in the direction that keeps the surface on the left;
/// empty for a closed surface. A vertex where two loops touch ends up in both. A border that ends
/// in an edge of three triangles is no loop, and is listed as far as it goes.
std::vector<std::vector<int>> find_border_loops(std::span<const Triangle> triangles);

/// The shell number of every vertex, counted from 0 in order of first vertex; vertices no
/// triangle uses get -1.
std::vector<int> find_shells(int vertex_count, std::span<const Triangle> triangles);

/// V - E + F over the vertices in use.
int compute_euler_number(std::span<const Triangle> triangles);

/// True when there are triangles and none has a side to itself.
bool is_closed(std::span<const Triangle> triangles);

}  // namespace palpate

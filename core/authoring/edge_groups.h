// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <tuple>
#include <vector>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// One side of a triangle: from its corner `corner` to the next one.
struct HalfEdge {
  int low, high;  ///< its vertices, ascending
  int triangle, corner;
  bool forward;  ///< the triangle runs from low to high

  bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// All sides, those of one edge next to each other, in order of triangle within an edge.
inline std::vector<HalfEdge> sort_half_edges(std::span<const Triangle> triangles) {
  std::vector<HalfEdge> sides;
  sides.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int c = 0; c < 3; ++c) {
      const int from = triangles[t][c], to = triangles[t][(c + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), t, c, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) <
           std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return sides;
}

/// Calls visit(span of HalfEdge) once per edge, in ascending order of the edges.
template <class Visit>
void for_each_edge(std::span<const HalfEdge> sides, Visit visit) {
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].same_edge(sides[first])) ++last;
    visit(sides.subspan(first, last - first));
    first = last;
  }
}

/// Edges with more than two triangles.
int count_crowded_edges(std::span<const Triangle> triangles);

/// Which sides of an edge hang together: places of two in the span that it is asked with.
using PairSides = std::function<std::vector<std::array<int, 2>>(std::span<const HalfEdge>)>;

/// The vertices as they would be if surfaces that touch only in a vertex were taken apart there:
/// triangle corner -> vertex, the first fan of each vertex keeping its number. Corners are counted
/// 3 * triangle + corner; `next` is the first free vertex number and is raised.
std::vector<int> separate_fans(std::span<const Triangle> triangles, int& next);

/// The same where `pair` says which triangles are neighbours at an edge.
std::vector<int> separate_fans(std::span<const Triangle> triangles, int& next,
                               const PairSides& pair);

}  // namespace palpate::authoring

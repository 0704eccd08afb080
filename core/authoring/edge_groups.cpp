// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/edge_groups.h"

#include <numeric>

namespace palpate::authoring {
namespace {

int find_root(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

void unite(std::vector<int>& parent, int i, int j) {
  const int a = find_root(parent, i), b = find_root(parent, j);
  parent[std::max(a, b)] = std::min(a, b);
}

}  // namespace

int count_crowded_edges(std::span<const Triangle> triangles) {
  int count = 0;
  const std::vector<HalfEdge> sides = sort_half_edges(triangles);
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) { count += edge.size() > 2; });
  return count;
}

std::vector<int> separate_fans(std::span<const Triangle> triangles, int& next) {
  return separate_fans(triangles, next, [](std::span<const HalfEdge> edge) {
    return edge.size() == 2 ? std::vector{std::array{0, 1}} : std::vector<std::array<int, 2>>{};
  });
}

std::vector<int> separate_fans(std::span<const Triangle> triangles, int& next,
                               const PairSides& pair) {
  std::vector<int> parent(3 * triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const std::vector<HalfEdge> sides = sort_half_edges(triangles);
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    // the corner of a side at its lower vertex, and at its higher one
    const auto at = [](const HalfEdge& e, bool low) {
      return 3 * e.triangle + (e.forward == low ? e.corner : (e.corner + 1) % 3);
    };
    for (const auto& [i, j] : pair(edge)) {
      unite(parent, at(edge[i], true), at(edge[j], true));
      unite(parent, at(edge[i], false), at(edge[j], false));
    }
  });

  std::vector<int> vertex(parent.size());
  std::vector<char> taken(next, 0);
  for (int i = 0; i < static_cast<int>(parent.size()); ++i) {
    const int root = find_root(parent, i), here = triangles[i / 3][i % 3];
    if (root != i) {
      vertex[i] = vertex[root];  // roots come first in their set
    } else {
      vertex[i] = taken[here] ? next++ : here;
      taken[here] = 1;
    }
  }
  return vertex;
}

}  // namespace palpate::authoring

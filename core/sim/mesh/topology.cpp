// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/mesh/topology.h"

#include <algorithm>
#include <compare>
#include <numeric>

namespace palpate {
namespace {

/// The side of `triangle` opposite its corner `corner`, filed under its vertices in ascending
/// order; `along` where the triangle runs from `low` to `high`.
struct Side {
  int low, high, triangle, corner;
  bool along;

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
  auto operator<=>(const Side&) const = default;
};

/// All sides, those of one edge next to each other, in order of triangle within an edge.
std::vector<Side> sort_sides(std::span<const Triangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int c = 0; c < 3; ++c) {
      const int from = triangles[t][(c + 1) % 3], to = triangles[t][(c + 2) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), t, c, from < to});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Calls visit(span of Side) once per edge, in ascending order of the edges.
template <class Visit>
void for_each_edge(std::span<const Side> sides, Visit visit) {
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].same_edge(sides[first])) ++last;
    visit(sides.subspan(first, last - first));
    first = last;
  }
}

int find_root(std::vector<int>& parent, int vertex) {
  while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
  return vertex;
}

int largest_vertex(std::span<const Triangle> triangles) {
  int largest = -1;
  for (const Triangle& t : triangles) largest = std::max({largest, t[0], t[1], t[2]});
  return largest;
}

/// The border as a graph of directed edges, taken up one by one.
class Border {
 public:
  explicit Border(std::span<const Triangle> triangles) {
    const int vertex_count = largest_vertex(triangles) + 1;
    at_.resize(vertex_count);
    place_.assign(vertex_count, -1);
    const std::vector<Side> sides = sort_sides(triangles);
    for_each_edge(sides, [&](std::span<const Side> edge) {
      if (edge.size() != 1 || edge[0].low == edge[0].high) return;
      const auto [low, high, t, c, along] = edge[0];
      at_[low].push_back(static_cast<int>(ends_.size()));
      at_[high].push_back(static_cast<int>(ends_.size()));
      ends_.push_back(along ? std::array{low, high} : std::array{high, low});
    });
    taken_.assign(ends_.size(), false);
  }

  int edge_count() const { return static_cast<int>(ends_.size()); }
  bool taken(int edge) const { return taken_[edge]; }

  /// Walks from the start of `edge` until no way leads on, and adds every loop closed on the way.
  void walk(int edge, std::vector<std::vector<int>>& loops) {
    std::vector<int> path = {ends_[edge][0]};
    place_[path[0]] = 0;
    for (int next = edge; next >= 0; next = find_way_on(path.back())) {
      taken_[next] = true;
      const int from = path.back();
      const int to = ends_[next][0] == from ? ends_[next][1] : ends_[next][0];
      if (place_[to] < 0) {
        place_[to] = static_cast<int>(path.size());
        path.push_back(to);
        continue;
      }
      // the path meets itself: what lies between is a loop, and the walk goes on from there
      loops.emplace_back(path.begin() + place_[to], path.end());
      while (path.back() != to) {
        place_[path.back()] = -1;
        path.pop_back();
      }
    }
    if (path.size() > 1) loops.push_back(path);
    for (const int vertex : path) place_[vertex] = -1;
  }

 private:
  /// An edge not yet taken at `vertex`, one that leaves it if there is one; -1 for none. Only
  /// triangles that disagree on their outside make it go against the direction of an edge.
  int find_way_on(int vertex) const {
    int against = -1;
    for (const int edge : at_[vertex]) {
      if (taken_[edge]) continue;
      if (ends_[edge][0] == vertex) return edge;
      if (against < 0) against = edge;
    }
    return against;
  }

  std::vector<std::array<int, 2>> ends_;
  std::vector<bool> taken_;
  std::vector<std::vector<int>> at_;
  std::vector<int> place_;
};

}  // namespace

Topology build_topology(std::span<const Triangle> triangles) {
  const std::vector<Side> sides = sort_sides(triangles);
  Topology topology;
  topology.triangle_edges.resize(triangles.size());
  for_each_edge(sides, [&](std::span<const Side> edge) {
    for (const Side& side : edge) {
      topology.triangle_edges[side.triangle][side.corner] = static_cast<int>(topology.edges.size());
    }
    topology.edges.push_back({edge[0].low, edge[0].high});
    topology.edge_triangles.push_back({edge[0].triangle, edge.size() > 1 ? edge[1].triangle : -1});
  });
  return topology;
}

int count_non_manifold_edges(std::span<const Triangle> triangles) {
  int count = 0;
  const std::vector<Side> sides = sort_sides(triangles);
  for_each_edge(sides, [&](std::span<const Side> edge) {
    const bool agree = edge.size() == 1 || (edge.size() == 2 && edge[0].along != edge[1].along);
    if (!agree && edge[0].low != edge[0].high) ++count;
  });
  return count;
}

std::vector<std::vector<int>> find_border_loops(std::span<const Triangle> triangles) {
  Border border(triangles);
  std::vector<std::vector<int>> loops;
  for (int edge = 0; edge < border.edge_count(); ++edge) {
    if (!border.taken(edge)) border.walk(edge, loops);
  }
  return loops;
}

std::vector<int> find_shells(int vertex_count, std::span<const Triangle> triangles) {
  std::vector<int> parent(vertex_count);
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<bool> used(vertex_count, false);
  for (const Triangle& t : triangles) {
    for (const int vertex : t) {
      used[vertex] = true;
      const int a = find_root(parent, t[0]), b = find_root(parent, vertex);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<int> shells(vertex_count, -1);
  int shell_count = 0;
  for (int vertex = 0; vertex < vertex_count; ++vertex) {
    if (!used[vertex]) continue;
    // the root of a shell is its smallest vertex, so it has its number already
    const int root = find_root(parent, vertex);
    shells[vertex] = root == vertex ? shell_count++ : shells[root];
  }
  return shells;
}

int compute_euler_number(std::span<const Triangle> triangles) {
  std::vector<bool> used(largest_vertex(triangles) + 1, false);
  for (const Triangle& t : triangles) {
    for (const int vertex : t) used[vertex] = true;
  }
  int edge_count = 0;
  const std::vector<Side> sides = sort_sides(triangles);
  for_each_edge(sides, [&](std::span<const Side>) { ++edge_count; });
  return static_cast<int>(std::count(used.begin(), used.end(), true)) - edge_count +
         static_cast<int>(triangles.size());
}

bool is_closed(std::span<const Triangle> triangles) {
  bool closed = !triangles.empty();
  const std::vector<Side> sides = sort_sides(triangles);
  for_each_edge(sides, [&](std::span<const Side> edge) {
    if (edge.size() == 1 && edge[0].low != edge[0].high) closed = false;
  });
  return closed;
}

}  // namespace palpate

// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/feature_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "palpate/authoring/collapse_edges.h"
#include "palpate/authoring/edge_groups.h"
#include "palpate/authoring/triangle_shape.h"

namespace palpate::authoring {
namespace {

using Edges = std::vector<std::array<int, 2>>;

double length_of(const SurfaceMesh& mesh, const std::array<int, 2>& edge) {
  return (mesh.vertices[edge[0]] - mesh.vertices[edge[1]]).norm();
}

bool is_ridge(const SurfaceMesh& mesh, std::span<const HalfEdge> edge) {
  const Vec3 m = normal_of(corners_of(mesh, mesh.triangles[edge[0].triangle]));
  const Vec3 n = normal_of(corners_of(mesh, mesh.triangles[edge[1].triangle]));
  return std::atan2(m.cross(n).norm(), m.dot(n)) >= kRidgeTurn;
}

/// Whether the triangles at an edge have different numbers.
bool differ(std::span<const int> numbers, std::span<const HalfEdge> edge) {
  return !numbers.empty() && numbers[edge[0].triangle] != numbers[edge[1].triangle];
}

int find_root(std::vector<int>& parent, int v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

/// Without those that hang together to less than `least` [m].
Edges drop_short(const SurfaceMesh& mesh, const Edges& ridges, double least) {
  std::vector<int> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [u, v] : ridges) parent[find_root(parent, u)] = find_root(parent, v);
  std::map<int, double> length;
  for (const auto& edge : ridges) length[find_root(parent, edge[0])] += length_of(mesh, edge);
  Edges kept;
  for (const auto& edge : ridges) {
    if (length[find_root(parent, edge[0])] >= least) kept.push_back(edge);
  }
  return kept;
}

/// Follows the links of a line from `from` by way of `to`; marks what is passed.
void follow(const SurfaceMesh& mesh, int from, int to, FeatureLines& found) {
  const auto number = static_cast<int>(found.lines.size());
  Line line;
  line.points.push_back(mesh.vertices[from]);
  int before = from, here = to;
  while (here != from && found.line[here] != FeatureLines::kCorner) {
    found.line[here] = number;
    line.points.push_back(mesh.vertices[here]);
    const auto& links = found.links[here];
    const int next = links[0] == before ? links[1] : links[0];
    before = here;
    here = next;
  }
  line.closed = here == from && found.line[from] != FeatureLines::kCorner;
  if (line.closed) {
    found.line[from] = number;
  } else {
    line.points.push_back(mesh.vertices[here]);
  }
  found.lines.push_back(std::move(line));
}

}  // namespace

FeatureLines find_feature_lines(const SurfaceMesh& mesh, const LineOptions& options) {
  Edges borders, ridges;
  std::vector<char> on_border(mesh.vertices.size(), 0);
  const std::vector<HalfEdge> sides = sort_half_edges(mesh.triangles);
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    const std::array ends = {edge[0].low, edge[0].high};
    if (edge.size() != 2) {
      on_border[ends[0]] = on_border[ends[1]] = 1;
    } else if (differ(options.regions, edge) || differ(options.names, edge)) {
      borders.push_back(ends);
    } else if (options.ridges && is_ridge(mesh, edge)) {
      ridges.push_back(ends);
    }
  });
  const Edges kept = drop_short(mesh, ridges, options.least_length);
  borders.insert(borders.end(), kept.begin(), kept.end());

  FeatureLines found;
  found.links.assign(mesh.vertices.size(), {});
  found.line.assign(mesh.vertices.size(), FeatureLines::kNone);
  for (const auto& [u, v] : borders) {
    found.links[u].push_back(v);
    found.links[v].push_back(u);
  }
  const auto count = static_cast<int>(mesh.vertices.size());
  for (int v = 0; v < count; ++v) {
    const std::size_t degree = found.links[v].size();
    if (degree > 0 && (degree != 2 || on_border[v])) found.line[v] = FeatureLines::kCorner;
  }
  for (int v = 0; v < count; ++v) {
    if (found.line[v] != FeatureLines::kCorner) continue;
    for (const int to : found.links[v]) {
      const bool is_new =
          found.line[to] == FeatureLines::kCorner ? v < to : found.line[to] == FeatureLines::kNone;
      if (is_new) follow(mesh, v, to, found);
    }
  }
  for (int v = 0; v < count; ++v) {
    if (found.line[v] == FeatureLines::kNone && !found.links[v].empty()) {
      follow(mesh, v, found.links[v][0], found);
    }
  }
  return found;
}

int FeatureLines::count_needed() const {
  const auto corners = std::count(line.begin(), line.end(), kCorner);
  const auto rings =
      std::count_if(lines.begin(), lines.end(), [](const Line& l) { return l.closed; });
  return static_cast<int>(corners + kSmallestLoop * rings);
}

double FeatureLines::length() const {
  double sum = 0.0;
  for (const Line& each : lines) {
    const std::size_t n = each.points.size();
    for (std::size_t i = each.closed ? 0 : 1; i < n; ++i) {
      sum += (each.points[i] - each.points[(i + n - 1) % n]).norm();
    }
  }
  return sum;
}

Vec3 FeatureLines::find_closest(int number, const Vec3& p) const {
  const auto& [points, closed] = lines[number];
  Vec3 closest = points.front();
  for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    const Vec3 &a = points[(i + points.size() - 1) % points.size()], along = points[i] - a;
    const double length2 = along.squaredNorm();
    const double s = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    const Vec3 q = a + s * along;
    if ((q - p).squaredNorm() < (closest - p).squaredNorm()) closest = q;
  }
  return closest;
}

std::vector<std::array<int, 2>> FeatureLines::list_edges() const {
  Edges edges;
  for (int v = 0; v < static_cast<int>(links.size()); ++v) {
    for (const int to : links[v]) {
      if (v < to) edges.push_back({v, to});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

FeatureLines renumber(const FeatureLines& lines, const std::vector<std::vector<int>>& links,
                      std::span<const int> source) {
  std::vector<int> number(lines.line.size(), -1);
  for (std::size_t i = 0; i < source.size(); ++i) number[source[i]] = static_cast<int>(i);
  FeatureLines renumbered;
  renumbered.lines = lines.lines;
  for (const int v : source) {
    renumbered.line.push_back(lines.line[v]);
    renumbered.links.emplace_back();
    for (const int to : links[v]) renumbered.links.back().push_back(number[to]);
  }
  return renumbered;
}

}  // namespace palpate::authoring

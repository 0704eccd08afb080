// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/stitch_borders.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "palpate/authoring/edge_groups.h"

namespace palpate::authoring {
namespace {

/// Points filed by the cell of `size` [m] they lie in.
class Grid {
 public:
  Grid(const Vec3Array& points, const std::vector<int>& chosen, double size)
      : points_(points), size_(size) {
    for (const int v : chosen) cells_[cell_of(points[v])].push_back(v);
  }

  /// Calls visit(v) for what lies in the box between two corners, and for some more around it.
  template <class Visit>
  void search(const Vec3& low, const Vec3& high, Visit visit) const {
    const Cell first = cell_of(low), last = cell_of(high);
    for (long x = first[0]; x <= last[0]; ++x) {
      for (long y = first[1]; y <= last[1]; ++y) {
        const auto end = cells_.upper_bound({x, y, last[2]});
        for (auto at = cells_.lower_bound({x, y, first[2]}); at != end; ++at) {
          for (const int v : at->second) visit(v);
        }
      }
    }
  }

 private:
  using Cell = std::array<long, 3>;

  Cell cell_of(const Vec3& p) const {
    return {std::lround(std::floor(p.x() / size_)), std::lround(std::floor(p.y() / size_)),
            std::lround(std::floor(p.z() / size_))};
  }

  const Vec3Array& points_;
  double size_;
  std::map<Cell, std::vector<int>> cells_;
};

std::vector<HalfEdge> find_border(const SurfaceMesh& mesh) {
  std::vector<HalfEdge> border;
  const std::vector<HalfEdge> sides = sort_half_edges(mesh.triangles);
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) border.push_back(edge[0]);
  });
  return border;
}

std::vector<int> list_vertices(const std::vector<HalfEdge>& border) {
  std::vector<int> vertices;
  for (const HalfEdge& e : border) vertices.insert(vertices.end(), {e.low, e.high});
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

double mean_length(const SurfaceMesh& mesh, const std::vector<HalfEdge>& border) {
  double sum = 0.0;
  for (const HalfEdge& e : border) sum += (mesh.vertices[e.high] - mesh.vertices[e.low]).norm();
  return sum / static_cast<double>(border.size());
}

/// Each border vertex becomes the first one within the tolerance. How many became another.
int join_vertices(SurfaceMesh& mesh, double tolerance) {
  const std::vector<HalfEdge> border = find_border(mesh);
  if (border.empty()) return 0;
  const std::vector<int> vertices = list_vertices(border);
  const Grid grid(mesh.vertices, vertices, std::max(2.0 * tolerance, mean_length(mesh, border)));
  std::vector<int> target(mesh.vertices.size());
  for (std::size_t v = 0; v < target.size(); ++v) target[v] = static_cast<int>(v);
  int joined = 0;
  const Vec3 reach = Vec3::Constant(tolerance);
  for (const int v : vertices) {
    const Vec3& p = mesh.vertices[v];
    grid.search(p - reach, p + reach, [&](int u) {
      if (u >= target[v] || target[u] != u) return;
      if ((mesh.vertices[u] - p).norm() <= tolerance) target[v] = u;
    });
    joined += target[v] != v;
  }
  for (Triangle& t : mesh.triangles) t = {target[t[0]], target[t[1]], target[t[2]]};
  std::erase_if(mesh.triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return joined;
}

struct OnEdge {
  double share;  ///< of the way along the edge
  int vertex;
};

/// The border vertices that lie on an edge, in their order along it.
std::vector<OnEdge> find_on_edge(const SurfaceMesh& mesh, const Grid& grid, int from, int to,
                                 int apex, double tolerance) {
  const Vec3 &a = mesh.vertices[from], &b = mesh.vertices[to];
  const Vec3 along = b - a;
  const double length = along.norm();
  std::vector<OnEdge> found;
  const Vec3 reach = Vec3::Constant(tolerance);
  grid.search(a.cwiseMin(b) - reach, a.cwiseMax(b) + reach, [&](int v) {
    if (v == from || v == to || v == apex) return;
    const double at = (mesh.vertices[v] - a).dot(along) / length;
    if (at <= tolerance || at >= length - tolerance) return;
    if ((mesh.vertices[v] - a - (at / length) * along).norm() > tolerance) return;
    found.push_back({at / length, v});
  });
  std::sort(found.begin(), found.end(), [](const OnEdge& x, const OnEdge& y) {
    return std::tie(x.share, x.vertex) < std::tie(y.share, y.vertex);
  });
  return found;
}

/// Splits border edges at the vertices on them; one edge of a triangle at a time, so it is done
/// until no edge is left.
int split_edges(SurfaceMesh& mesh, double tolerance) {
  constexpr int kSides = 3;
  int split = 0;
  for (int round = 0; round < kSides; ++round) {
    const std::vector<HalfEdge> border = find_border(mesh);
    if (border.empty()) break;
    const Grid grid(mesh.vertices, list_vertices(border),
                    std::max(2.0 * tolerance, mean_length(mesh, border)));
    std::vector<char> changed(mesh.triangles.size(), 0);
    const int before = split;
    for (const HalfEdge& e : border) {
      if (changed[e.triangle]) continue;
      const Triangle t = mesh.triangles[e.triangle];
      const int from = t[e.corner], to = t[(e.corner + 1) % 3], apex = t[(e.corner + 2) % 3];
      const auto on = find_on_edge(mesh, grid, from, to, apex, tolerance);
      if (on.empty()) continue;
      changed[e.triangle] = 1;
      ++split;
      int last = from;
      for (const OnEdge& each : on) {
        mesh.triangles.push_back({last, each.vertex, apex});
        last = each.vertex;
      }
      mesh.triangles[e.triangle] = {last, to, apex};
    }
    if (split == before) break;
  }
  return split;
}

}  // namespace

StitchedMesh stitch_borders(const SurfaceMesh& mesh, double tolerance) {
  StitchedMesh stitched;
  stitched.mesh = mesh;
  stitched.joined_vertices = join_vertices(stitched.mesh, tolerance);
  stitched.split_edges = split_edges(stitched.mesh, tolerance);
  return stitched;
}

}  // namespace palpate::authoring

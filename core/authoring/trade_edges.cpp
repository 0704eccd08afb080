// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/trade_edges.h"

#include <optional>
#include <set>

#include "palpate/authoring/edge_groups.h"
#include "palpate/authoring/triangle_shape.h"

namespace palpate::authoring {
namespace {

/// More bad triangles than this are not stragglers; the rounds before have not done their work.
constexpr int kMostTrades = 200;

/// How many of the longest edges are tried before giving up.
constexpr int kMostSplits = 20;

struct Edge {
  int u, v;           // u < v
  int first, second;  // its triangles; -1 on a border
};

class Trading {
 public:
  Trading(const SourceSurface& source, const std::vector<char>& kept, SurfaceMesh& mesh)
      : source_(source), kept_(kept), mesh_(mesh) {
    find_neighbours();
  }

  /// Collapses an edge of triangle `t` and splits another; leaves all as it was where that would
  /// leave an angle no better than `t`'s.
  bool trade(int t) {
    const SurfaceMesh before = mesh_;
    const double worst = smallest_angle(corners_of(mesh_, mesh_.triangles[t]));
    const std::optional<Edge> edge = find_shortest_edge(t);
    if (edge && collapse(*edge, worst)) {
      if (split_longest(edge->v, {edge->first, edge->second}, worst)) {
        find_neighbours();
        return true;
      }
      mesh_ = before;
    }
    return false;
  }

 private:
  void find_neighbours() {
    fans_.assign(mesh_.vertices.size(), {});
    on_border_.assign(mesh_.vertices.size(), 0);
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
      for (const int v : mesh_.triangles[t]) fans_[v].push_back(t);
    }
    edges_.clear();
    const std::vector<HalfEdge> sides = sort_half_edges(mesh_.triangles);
    for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
      const int second = edge.size() == 2 ? edge[1].triangle : -1;
      edges_.push_back({edge[0].low, edge[0].high, edge[0].triangle, second});
      if (second < 0) on_border_[edge[0].low] = on_border_[edge[0].high] = 1;
    });
  }

  bool is_kept(int v) const { return !kept_.empty() && kept_[v] != 0; }

  double length(const Edge& e) const { return (mesh_.vertices[e.u] - mesh_.vertices[e.v]).norm(); }

  std::optional<Edge> find_shortest_edge(int t) const {
    std::optional<Edge> shortest;
    for (const Edge& e : edges_) {
      if (e.first != t && e.second != t) continue;
      if (!shortest || length(e) < length(*shortest)) shortest = e;
    }
    return shortest;
  }

  std::set<int> neighbours(int v) const {
    std::set<int> around;
    for (const int t : fans_[v])
      around.insert(mesh_.triangles[t].begin(), mesh_.triangles[t].end());
    around.erase(v);
    return around;
  }

  /// The link condition [Dey99]: u and v have just the two corners opposite their edge in common,
  /// and these keep three triangles.
  bool may_collapse(const Edge& e) const {
    if (e.second < 0 || on_border_[e.u] || on_border_[e.v]) return false;
    if (is_kept(e.u) || is_kept(e.v)) return false;
    const std::set<int> of_u = neighbours(e.u), of_v = neighbours(e.v);
    int shared = 0;
    for (const int v : of_u) {
      if (!of_v.count(v)) continue;
      ++shared;
      if (!on_border_[v] && fans_[v].size() <= 3) return false;
    }
    return shared == 2;
  }

  /// Both ends meet in the middle; the triangles between them are left without area.
  bool collapse(const Edge& e, double worst) {
    if (!may_collapse(e)) return false;
    const Vec3 place =
        source_.find_closest(0.5 * (mesh_.vertices[e.u] + mesh_.vertices[e.v])).point;
    for (const int end : {e.u, e.v}) {
      for (const int t : fans_[end]) {
        if (t == e.first || t == e.second) continue;
        const Corners before = corners_of(mesh_, mesh_.triangles[t]);
        Corners after = before;
        for (int c = 0; c < 3; ++c) {
          if (mesh_.triangles[t][c] == end) after[c] = place;
        }
        if (is_turned(normal_of(before), normal_of(after)) || smallest_angle(after) <= worst) {
          return false;
        }
      }
    }
    mesh_.vertices[e.u] = place;
    for (const int t : fans_[e.v]) {
      for (int& v : mesh_.triangles[t]) v = v == e.v ? e.u : v;
    }
    return true;
  }

  /// Puts `vertex`, no longer in use, and the two `spare` triangles into a long edge.
  bool split_longest(int vertex, std::array<int, 2> spare, double worst) {
    std::vector<Edge> inner;
    for (const Edge& e : edges_) {
      const auto is_spare = [&](int t) { return t == spare[0] || t == spare[1]; };
      if (e.second < 0 || is_spare(e.first) || is_spare(e.second)) continue;
      if (is_kept(e.u) && is_kept(e.v)) continue;
      if (e.u != vertex && e.v != vertex) inner.push_back(e);
    }
    const auto count = std::min<std::size_t>(kMostSplits, inner.size());
    const auto last = inner.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(inner.begin(), last, inner.end(), [&](const Edge& l, const Edge& r) {
      return std::pair(-length(l), l.u) < std::pair(-length(r), r.u);
    });
    return std::any_of(inner.begin(), last,
                       [&](const Edge& e) { return split(e, vertex, spare, worst); });
  }

  bool split(const Edge& e, int vertex, std::array<int, 2> spare, double worst) {
    const Vec3 place =
        source_.find_closest(0.5 * (mesh_.vertices[e.u] + mesh_.vertices[e.v])).point;
    const std::array sources = {e.first, e.second};
    std::array<Triangle, 4> parts;
    for (int i = 0; i < 2; ++i) {
      for (int half = 0; half < 2; ++half) {
        Triangle& part = parts[2 * i + half];
        part = mesh_.triangles[sources[i]];
        std::replace(part.begin(), part.end(), half == 0 ? e.u : e.v, vertex);
      }
    }
    const Vec3 old_place = mesh_.vertices[vertex];
    mesh_.vertices[vertex] = place;
    for (int i = 0; i < 4; ++i) {
      const Corners after = corners_of(mesh_, parts[i]);
      const Corners before = corners_of(mesh_, mesh_.triangles[sources[i / 2]]);
      if (is_turned(normal_of(before), normal_of(after)) || smallest_angle(after) <= worst) {
        mesh_.vertices[vertex] = old_place;
        return false;
      }
    }
    for (int i = 0; i < 2; ++i) {
      mesh_.triangles[sources[i]] = parts[2 * i];
      mesh_.triangles[spare[i]] = parts[2 * i + 1];
    }
    return true;
  }

  const SourceSurface& source_;
  const std::vector<char>& kept_;
  SurfaceMesh& mesh_;
  std::vector<Edge> edges_;
  std::vector<std::vector<int>> fans_;
  std::vector<char> on_border_;
};

/// The triangle with the smallest angle that has not been tried; -1 where none is below `least`.
int find_worst(const SurfaceMesh& mesh, double least, const std::set<Triangle>& tried) {
  int worst = -1;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const double angle = smallest_angle(corners_of(mesh, mesh.triangles[t]));
    if (angle >= least || tried.count(mesh.triangles[t])) continue;
    least = angle;
    worst = t;
  }
  return worst;
}

}  // namespace

int trade_edges(const SourceSurface& source, double least, SurfaceMesh& mesh,
                const std::vector<char>& kept) {
  Trading trading(source, kept, mesh);
  std::set<Triangle> tried;
  int trades = 0;
  for (int i = 0; i < kMostTrades; ++i) {
    const int worst = find_worst(mesh, least, tried);
    if (worst < 0) break;
    tried.insert(mesh.triangles[worst]);
    trades += trading.trade(worst);
  }
  return trades;
}

}  // namespace palpate::authoring

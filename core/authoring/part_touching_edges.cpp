// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/part_touching_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "palpate/authoring/edge_groups.h"

namespace palpate::authoring {
namespace {

/// Triangles at an edge closer than this [rad] lie on each other: none of them is the next.
constexpr double kSameAngle = 1e-9;

/// [m³] Six times the volume within a surface, about its first vertex. Negative where it is inside
/// out.
double measure_sixfold_volume(const SurfaceMesh& mesh) {
  double sum = 0.0;
  const Vec3 origin = mesh.vertices.front();
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 a = mesh.vertices[i] - origin, b = mesh.vertices[j] - origin,
               c = mesh.vertices[k] - origin;
    sum += a.cross(b).dot(c);
  }
  return sum;
}

/// Pairs the triangles round an edge by the solid between them.
class Wedges {
 public:
  explicit Wedges(const SurfaceMesh& mesh)
      : mesh_(mesh), inside_out_(measure_sixfold_volume(mesh) < 0.0) {}

  bool inside_out() const { return inside_out_; }

  /// Which sides bound the same solid; empty where that cannot be told.
  ///
  /// A triangle that runs along the edge has its normal towards larger angles, and its solid on the
  /// side of smaller ones: it goes with the one before it in the order of angles.
  std::vector<std::array<int, 2>> pair(std::span<const HalfEdge> edge) const {
    const int count = static_cast<int>(edge.size());
    if (count % 2 != 0) return {};
    const std::vector<double> angle = measure_angles(edge);
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) { return angle[i] < angle[j]; });

    std::vector<std::array<int, 2>> pairs;
    for (int k = 0; k < count; ++k) {
      const int here = order[k], before = order[(k + count - 1) % count];
      if (edge[here].forward == edge[before].forward) return {};
      if (k > 0 && !(angle[here] - angle[before] > kSameAngle)) return {};
      if (edge[here].forward != inside_out_) pairs.push_back({here, before});
    }
    return pairs;
  }

  /// The two that agree and go on flattest, then the next two; all that agree with none are left.
  std::vector<std::array<int, 2>> pair_flattest(std::span<const HalfEdge> edge) const {
    const int count = static_cast<int>(edge.size());
    const std::vector<double> angle = measure_angles(edge);
    std::vector<std::tuple<double, int, int>> bends;  // how far from flat, and of which two
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < count; ++j) {
        if (edge[i].forward == edge[j].forward) continue;
        const double apart = std::abs(angle[i] - angle[j]);
        bends.emplace_back(std::abs(apart - std::numbers::pi), i, j);
      }
    }
    std::sort(bends.begin(), bends.end());
    std::vector<char> taken(count, 0);
    std::vector<std::array<int, 2>> pairs;
    for (const auto& [bend, i, j] : bends) {
      if (taken[i] || taken[j]) continue;
      taken[i] = taken[j] = 1;
      pairs.push_back({i, j});
    }
    return pairs;
  }

 private:
  /// [rad] Of each triangle about the edge, from the first on.
  std::vector<double> measure_angles(std::span<const HalfEdge> edge) const {
    const Vec3 &from = mesh_.vertices[edge[0].low], &to = mesh_.vertices[edge[0].high];
    const Vec3 axis = (to - from).normalized();
    const auto reach = [&](const HalfEdge& side) -> Vec3 {
      const Vec3 w = mesh_.vertices[mesh_.triangles[side.triangle][(side.corner + 2) % 3]] - from;
      return w - axis * axis.dot(w);
    };
    const Vec3 x = reach(edge[0]), y = axis.cross(x);
    std::vector<double> angles;
    for (const HalfEdge& side : edge) {
      const Vec3 w = reach(side);
      const double angle = std::atan2(w.dot(y), w.dot(x));
      angles.push_back(angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle);
    }
    return angles;
  }

  const SurfaceMesh& mesh_;
  bool inside_out_;
};

/// Moves every vertex that has copies against the normal of the triangles it is left with.
void move_apart(SurfaceMesh& mesh, const std::vector<int>& original, int before, double distance) {
  std::vector<char> moves(mesh.vertices.size(), 0);
  for (std::size_t v = before; v < mesh.vertices.size(); ++v) moves[v] = moves[original[v]] = 1;
  Vec3Array normals(mesh.vertices.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 normal = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    for (const int v : t) normals[v] += normal;
  }
  for (std::size_t v = 0; v < moves.size(); ++v) {
    const double size = normals[v].norm();
    if (moves[v] && size > 0.0) mesh.vertices[v] -= distance / size * normals[v];
  }
}

/// Gives every corner its vertex; which one each vertex is a copy of.
std::vector<int> put_corners(SurfaceMesh& mesh, const std::vector<int>& vertex, int count) {
  std::vector<int> original(count);
  std::iota(original.begin(), original.end(), 0);
  mesh.vertices.resize(count);
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    int& corner = mesh.triangles[i / 3][i % 3];
    original[vertex[i]] = corner;
    mesh.vertices[vertex[i]] = mesh.vertices[corner];
    corner = vertex[i];
  }
  return original;
}

/// Splits the triangles of edges that are there twice: what was told apart along them still hangs
/// together at both ends. Each pair gets a middle of its own, and so does a side that is left
/// alone.
class DoubleEdges {
 public:
  /// `cut`: where no two agree, each side ends there; else such an edge stays as it is.
  DoubleEdges(SurfaceMesh& mesh, bool cut) : mesh_(mesh), cut_(cut) {}

  /// Until there are none; a triangle is split along one of its sides at a time.
  void split(const std::function<PairSides(const Wedges&)>& choose) {
    while (split_once(choose)) {
    }
  }

 private:
  bool split_once(const std::function<PairSides(const Wedges&)>& choose) {
    const SurfaceMesh before = mesh_;
    const Wedges wedges(before);
    const PairSides pair = choose(wedges);
    const std::vector<HalfEdge> sides = sort_half_edges(before.triangles);
    changed_.assign(before.triangles.size(), 0);
    bool any = false;
    for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
      if (edge.size() <= 2) return;
      const auto is_changed = [&](const HalfEdge& side) { return changed_[side.triangle] != 0; };
      if (std::any_of(edge.begin(), edge.end(), is_changed)) return;
      const auto pairs = pair(edge);
      if (pairs.empty() && !cut_) return;
      any = true;
      split_edge(edge, pairs);
    });
    return any;
  }

  void split_edge(std::span<const HalfEdge> edge, const std::vector<std::array<int, 2>>& pairs) {
    std::vector<char> alone(edge.size(), 1);
    for (const auto& [i, j] : pairs) {
      const int middle = add_middle(edge[0]);
      split_side(edge[i], middle);
      split_side(edge[j], middle);
      alone[i] = alone[j] = 0;
    }
    for (std::size_t i = 0; i < edge.size(); ++i) {
      if (alone[i]) split_side(edge[i], add_middle(edge[0]));
    }
  }

  int add_middle(const HalfEdge& side) {
    mesh_.vertices.push_back(Vec3(0.5 * (mesh_.vertices[side.low] + mesh_.vertices[side.high])));
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }

  void split_side(const HalfEdge& side, int middle) {
    const Triangle t = mesh_.triangles[side.triangle];
    const int a = t[side.corner], b = t[(side.corner + 1) % 3], c = t[(side.corner + 2) % 3];
    mesh_.triangles[side.triangle] = {a, middle, c};
    mesh_.triangles.push_back({middle, b, c});
    changed_[side.triangle] = 1;
  }

  SurfaceMesh& mesh_;
  bool cut_;
  std::vector<char> changed_;
};

}  // namespace

int part_touching_edges(SurfaceMesh& mesh, double distance) {
  if (count_crowded_edges(mesh.triangles) == 0) return 0;
  const Wedges wedges(mesh);
  int parted = 0;
  const auto pair = [&](std::span<const HalfEdge> edge) {
    std::vector<std::array<int, 2>> pairs;
    if (edge.size() > 2) pairs = wedges.pair(edge);
    parted += !pairs.empty();
    if (!pairs.empty()) return pairs;
    // two neighbours; and what cannot be told apart stays together
    for (int i = 1; i < static_cast<int>(edge.size()); ++i) pairs.push_back({i - 1, i});
    return pairs;
  };
  const int before = static_cast<int>(mesh.vertices.size());
  int next = before;
  const std::vector<int> vertex = separate_fans(mesh.triangles, next, pair);
  if (parted == 0) return 0;

  std::vector<int> original = put_corners(mesh, vertex, next);
  DoubleEdges(mesh, false).split([](const Wedges& w) -> PairSides {
    return [&w](std::span<const HalfEdge> edge) { return w.pair(edge); };
  });
  for (int v = next; v < static_cast<int>(mesh.vertices.size()); ++v) original.push_back(v);
  move_apart(mesh, original, before, wedges.inside_out() ? -distance : distance);
  return parted;
}

int cut_crowded_edges(SurfaceMesh& mesh) {
  const int crowded = count_crowded_edges(mesh.triangles);
  if (crowded == 0) return 0;
  const Wedges wedges(mesh);
  const auto pair = [&](std::span<const HalfEdge> edge) {
    if (edge.size() > 2) return wedges.pair_flattest(edge);
    return edge.size() == 2 ? std::vector{std::array{0, 1}} : std::vector<std::array<int, 2>>{};
  };
  int next = static_cast<int>(mesh.vertices.size());
  const std::vector<int> vertex = separate_fans(mesh.triangles, next, pair);
  put_corners(mesh, vertex, next);
  DoubleEdges(mesh, true).split([](const Wedges& w) -> PairSides {
    return [&w](std::span<const HalfEdge> edge) { return w.pair_flattest(edge); };
  });
  return crowded;
}

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/weld.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <unordered_map>

namespace palpate::authoring {
namespace {

/// Kept vertices, filed by the cell they lie in. A cell is two tolerances wide: what is near a
/// point lies in at most two cells along each axis, and a cell holds only a few kept vertices.
class Kept {
 public:
  /// `group` is empty, or has a number for each point: then one finds those of others only.
  Kept(std::span<const Vec3> points, double tolerance, std::span<const int> group)
      : points_(points), group_(group), tolerance_(tolerance), next_(points.size(), -1) {}

  /// The nearest kept vertex within the tolerance, the first of equals; -1 for none.
  int find(int vertex) const {
    const Vec3& p = points_[vertex];
    int nearest = -1;
    double distance = tolerance_;
    const Cell low = cell_of(p.array() - tolerance_), high = cell_of(p.array() + tolerance_);
    for (int corner = 0; corner < 8; ++corner) {
      const bool right = corner & 1, back = corner & 2, top = corner & 4;
      if ((right && low.x == high.x) || (back && low.y == high.y) || (top && low.z == high.z)) {
        continue;
      }
      search({right ? high.x : low.x, back ? high.y : low.y, top ? high.z : low.z}, vertex, nearest,
             distance);
    }
    return nearest;
  }

  void add(int vertex) {
    const auto [first, is_new] = first_.try_emplace(cell_of(points_[vertex].array()), vertex);
    if (is_new) return;
    next_[vertex] = first->second;
    first->second = vertex;
  }

 private:
  struct Cell {
    double x, y, z;  // whole numbers, or the point itself where the tolerance is zero
    bool operator==(const Cell&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      const std::hash<double> hash;
      return (hash(c.x) * 0x9e3779b97f4a7c15u + hash(c.y)) * 0x9e3779b97f4a7c15u + hash(c.z);
    }
  };

  Cell cell_of(const Eigen::Array3d& p) const {
    if (tolerance_ == 0.0) return {p.x(), p.y(), p.z()};
    const Eigen::Array3d place = (p / (2.0 * tolerance_)).floor();
    return {place.x(), place.y(), place.z()};
  }

  void search(const Cell& cell, int vertex, int& nearest, double& distance) const {
    const auto first = first_.find(cell);
    if (first == first_.end()) return;
    for (int v = first->second; v >= 0; v = next_[v]) {
      if (!group_.empty() && group_[v] == group_[vertex]) continue;
      const double d = (points_[v] - points_[vertex]).norm();
      if (d > distance || (d == distance && nearest >= 0 && v > nearest)) continue;
      nearest = v;
      distance = d;
    }
  }

  std::span<const Vec3> points_;
  std::span<const int> group_;
  double tolerance_;
  std::unordered_map<Cell, int, Hash> first_;
  std::vector<int> next_;  // the next one in the same cell, -1 for none
};

/// The kept vertex each vertex becomes; -1 where no triangle uses it.
std::vector<int> find_targets(const SurfaceMesh& mesh, double tolerance,
                              std::span<const int> group) {
  std::vector<int> target(mesh.vertices.size(), -1);
  for (const Triangle& t : mesh.triangles) {
    for (const int corner : t) target[corner] = corner;
  }
  Kept kept(mesh.vertices, tolerance, group);
  for (int v = 0; v < static_cast<int>(target.size()); ++v) {
    if (target[v] < 0) continue;
    const int near = kept.find(v);
    if (near < 0)
      kept.add(v);
    else
      target[v] = near;
  }
  return target;
}

/// The surface with each vertex in the place of its target.
Welded move_to(const SurfaceMesh& triangles, const std::vector<int>& target) {
  Welded welded{};
  std::vector<char> used(target.size(), 0);
  for (const Triangle& t : triangles.triangles) {
    const Triangle to = {target[t[0]], target[t[1]], target[t[2]]};
    if (to[0] == to[1] || to[1] == to[2] || to[2] == to[0]) {
      ++welded.collapsed_triangles;
      continue;
    }
    for (const int corner : to) used[corner] = 1;
    welded.mesh.triangles.push_back(to);
  }

  std::vector<int> place(target.size(), -1);
  for (std::size_t v = 0; v < target.size(); ++v) {
    if (target[v] >= 0 && target[v] != static_cast<int>(v)) {
      const double move = (triangles.vertices[v] - triangles.vertices[target[v]]).norm();
      welded.largest_move = std::max(welded.largest_move, move);
      ++welded.merged_vertices;
    }
    if (!used[v]) continue;
    place[v] = static_cast<int>(welded.mesh.vertices.size());
    welded.mesh.vertices.push_back(triangles.vertices[v]);
  }
  for (Triangle& t : welded.mesh.triangles) t = {place[t[0]], place[t[1]], place[t[2]]};
  return welded;
}

}  // namespace

Welded weld(const SurfaceMesh& triangles, double tolerance) {
  return move_to(triangles, find_targets(triangles, tolerance, {}));
}

Welded weld_across(const SurfaceMesh& triangles, double tolerance, std::span<const int> group) {
  return move_to(triangles, find_targets(triangles, tolerance, group));
}

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/orient.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "palpate/authoring/edge_groups.h"
#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {
namespace {

/// An open shell that encloses less than this part of area^(3/2) about its centroid is flat: its
/// bulge is a thousandth of its width, and its hollow side cannot be told.
constexpr double kFlat = 1e-4;

struct Shell {
  std::vector<int> triangles;
  bool closed = true;
  bool turn = false;
  double volume = 0.0;  ///< [m³] about the centroid, as the triangles run after agreeing
  std::array<Vec3, 2> bounds;
};

/// Who is across each side of each triangle, and whether it runs the other way as it should.
struct Neighbour {
  int triangle = -1;
  bool agrees = true;
};

std::vector<std::array<Neighbour, 3>> find_neighbours(std::span<const Triangle> triangles) {
  std::vector<std::array<Neighbour, 3>> neighbours(triangles.size());
  const std::vector<HalfEdge> sides = sort_half_edges(triangles);
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 2) return;
    const bool agrees = edge[0].forward != edge[1].forward;
    neighbours[edge[0].triangle][edge[0].corner] = {edge[1].triangle, agrees};
    neighbours[edge[1].triangle][edge[1].corner] = {edge[0].triangle, agrees};
  });
  return neighbours;
}

/// Walks the shells and finds which triangles to turn so that all agree with the majority.
class Agreement {
 public:
  explicit Agreement(std::span<const Triangle> triangles)
      : turn(triangles.size(), 0),
        neighbours_(find_neighbours(triangles)),
        seen_(triangles.size(), 0) {
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
      if (!seen_[t]) walk(t);
    }
  }

  std::vector<char> turn;
  std::vector<Shell> shells;
  bool orientable = true;

 private:
  void walk(int first) {
    Shell shell{};
    shell.triangles.push_back(first);
    seen_[first] = 1;
    for (std::size_t i = 0; i < shell.triangles.size(); ++i) {
      const int t = shell.triangles[i];
      for (const Neighbour& n : neighbours_[t]) visit(t, n, shell);
    }
    const auto against = std::count_if(shell.triangles.begin(), shell.triangles.end(),
                                       [&](int t) { return turn[t] != 0; });
    if (2 * against > static_cast<long>(shell.triangles.size())) {
      for (const int t : shell.triangles) turn[t] = !turn[t];
    }
    shells.push_back(std::move(shell));
  }

  void visit(int t, const Neighbour& n, Shell& shell) {
    if (n.triangle < 0) {
      shell.closed = false;
      return;
    }
    const char wanted = n.agrees ? turn[t] : !turn[t];
    if (seen_[n.triangle]) {
      orientable = orientable && turn[n.triangle] == wanted;
      return;
    }
    seen_[n.triangle] = 1;
    turn[n.triangle] = wanted;
    shell.triangles.push_back(n.triangle);
  }

  std::vector<std::array<Neighbour, 3>> neighbours_;
  std::vector<char> seen_;
};

void turn_over(Triangle& t) { std::swap(t[1], t[2]); }

/// The volume about the centroid, by the divergence theorem: V = 1/6 sum (a x b)·c.
void measure(const SurfaceMesh& mesh, Shell& shell) {
  Vec3Array corners;
  double area = 0.0;
  Vec3 centroid = Vec3::Zero();
  for (const int t : shell.triangles) {
    const auto [i, j, k] = mesh.triangles[t];
    const Vec3 &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
    corners.insert(corners.end(), {a, b, c});
    const double part = 0.5 * (b - a).cross(c - a).norm();
    area += part;
    centroid += part * (a + b + c) / 3.0;
  }
  if (area > 0.0) centroid /= area;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Vec3 a = corners[i] - centroid, b = corners[i + 1] - centroid,
               c = corners[i + 2] - centroid;
    shell.volume += a.cross(b).dot(c) / 6.0;
  }
  if (!shell.closed && std::abs(shell.volume) < kFlat * area * std::sqrt(area)) shell.volume = 0.0;
  shell.bounds = compute_bounds(corners);
}

/// How often a closed shell winds around p: the solid angle of its triangles over 4 pi
/// [vanOosterom83]. One inside, zero outside, in absolute value.
double compute_winding(const SurfaceMesh& mesh, const Shell& shell, const Vec3& p) {
  double angle = 0.0;
  for (const int t : shell.triangles) {
    const Vec3 a = mesh.vertices[mesh.triangles[t][0]] - p;
    const Vec3 b = mesh.vertices[mesh.triangles[t][1]] - p;
    const Vec3 c = mesh.vertices[mesh.triangles[t][2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2.0 * std::atan2(a.dot(b.cross(c)),
                              la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4.0 * std::numbers::pi);
}

bool contains(const SurfaceMesh& mesh, const Shell& outer, const Shell& inner) {
  if (!outer.closed || (inner.bounds[0].array() < outer.bounds[0].array()).any() ||
      (inner.bounds[1].array() > outer.bounds[1].array()).any()) {
    return false;
  }
  const Vec3& p = mesh.vertices[mesh.triangles[inner.triangles.front()][0]];
  return std::abs(compute_winding(mesh, outer, p)) > 0.5;
}

/// Largest first: the first one that contains a shell is the outermost.
std::vector<int> sort_by_volume(const std::vector<Shell>& shells) {
  std::vector<int> order(shells.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
    return std::abs(shells[i].volume) > std::abs(shells[j].volume);
  });
  return order;
}

void choose_outside(const SurfaceMesh& mesh, std::vector<Shell>& shells) {
  for (Shell& shell : shells) measure(mesh, shell);
  const std::vector<int> order = sort_by_volume(shells);
  for (std::size_t i = 0; i < order.size(); ++i) {
    Shell& shell = shells[order[i]];
    shell.turn = shell.volume < 0.0;
    if (!shell.closed) continue;
    for (std::size_t j = 0; j < i; ++j) {
      if (!contains(mesh, shells[order[j]], shell)) continue;
      shell.turn = shells[order[j]].turn;
      break;
    }
  }
}

}  // namespace

Orientation orient(SurfaceMesh& mesh) {
  const std::vector<Triangle> before = mesh.triangles;
  Agreement agreement(mesh.triangles);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (agreement.turn[t]) turn_over(mesh.triangles[t]);
  }
  choose_outside(mesh, agreement.shells);
  for (const Shell& shell : agreement.shells) {
    if (!shell.turn) continue;
    for (const int t : shell.triangles) turn_over(mesh.triangles[t]);
  }

  int turned = 0;
  for (std::size_t t = 0; t < before.size(); ++t) turned += before[t] != mesh.triangles[t];
  return {agreement.orientable, turned};
}

}  // namespace palpate::authoring

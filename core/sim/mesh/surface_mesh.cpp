// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"

namespace palpate {
namespace {

/// A triangle lower than this part of its longest side has no area: below it the cosines of its
/// corners are rounding.
constexpr double kFlat = 1e-9;

std::string name_triangle(int t) { return write_text("mesh: triangle ", t); }

void check_vertices(const SurfaceMesh& mesh) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& x = mesh.vertices[i];
    if (x.allFinite()) continue;
    refuse(write_text("mesh: vertex ", i), write_text("(", x.x(), ", ", x.y(), ", ", x.z(), ") m"),
           "finite numbers");
  }
}

void check_indices(const SurfaceMesh& mesh) {
  const int vertex_count = static_cast<int>(mesh.vertices.size());
  std::vector<bool> used(mesh.vertices.size(), false);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto& [i, j, k] = mesh.triangles[t];
    for (const int vertex : mesh.triangles[t]) {
      if (vertex < 0 || vertex >= vertex_count) {
        refuse(name_triangle(t), write_text("vertex ", vertex),
               write_text("0 to ", vertex_count - 1));
      }
      used[vertex] = true;
    }
    if (i == j || j == k || k == i) {
      refuse(name_triangle(t), write_text("vertices ", i, ", ", j, ", ", k),
             "three different ones");
    }
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end()) {
    refuse(write_text("mesh: vertex ", unused - used.begin()), "no triangle that uses it",
           "at least one");
  }
}

void check_areas(const SurfaceMesh& mesh) {
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto& [i, j, k] = mesh.triangles[t];
    const Vec3 a = mesh.vertices[k] - mesh.vertices[j], b = mesh.vertices[i] - mesh.vertices[k],
               c = mesh.vertices[j] - mesh.vertices[i];
    const double longest = std::max({a.norm(), b.norm(), c.norm()});
    const double height = longest > 0.0 ? b.cross(c).norm() / longest : 0.0;
    if (height > kFlat * longest) continue;
    refuse(name_triangle(t), write_text("height ", height, " m over a side of ", longest, " m"),
           "a triangle with an area");
  }
}

void check_neighbours(const SurfaceMesh& mesh) {
  // for each edge the triangles that run along it upwards and downwards, -1 for none
  std::map<std::array<int, 2>, std::array<int, 2>> neighbours;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int c = 0; c < 3; ++c) {
      const int from = mesh.triangles[t][c], to = mesh.triangles[t][(c + 1) % 3];
      const std::array<int, 2> edge = {std::min(from, to), std::max(from, to)};
      auto& sides = neighbours.try_emplace(edge, std::array{-1, -1}).first->second;
      int& side = sides[from < to ? 0 : 1];
      const int other = sides[from < to ? 1 : 0];
      if (side >= 0 && other >= 0) {
        refuse(name_triangle(t),
               write_text("edge ", edge[0], "-", edge[1], " already between triangles ",
                          std::min(side, other), " and ", std::max(side, other)),
               "at most two triangles at an edge");
      }
      if (side >= 0) {
        refuse(
            name_triangle(t),
            write_text("edge ", from, "-", to, " run in the same direction as in triangle ", side),
            "neighbours that agree on which side is outside, and two to an edge at most");
      }
      side = t;
    }
  }
}

}  // namespace

void validate(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) refuse("mesh: triangles", "none", "at least one");
  check_vertices(mesh);
  check_indices(mesh);
  check_areas(mesh);
  check_neighbours(mesh);
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/mesh/mesh.h"

namespace palpate {
namespace {

/// Along the outward normal, as long as twice the area [m²].
Vec3 compute_double_area(std::span<const Vec3> x, const Triangle& t) {
  return (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
}

}  // namespace

double compute_area(const SurfaceMesh& mesh) {
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    area += 0.5 * compute_double_area(mesh.vertices, t).norm();
  }
  return area;
}

/// The divergence theorem: V = 1/6 sum of a·(b × c), the tetrahedra between the triangles and one
/// point. The point is a vertex, because far from the origin the sum would lose its digits.
double compute_volume(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) return 0.0;
  const Vec3 o = mesh.vertices[mesh.triangles[0][0]];
  double volume = 0.0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 a = mesh.vertices[i] - o, b = mesh.vertices[j] - o, c = mesh.vertices[k] - o;
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

std::vector<double> compute_vertex_areas(const SurfaceMesh& mesh) {
  std::vector<double> areas(mesh.vertices.size(), 0.0);
  for (const Triangle& t : mesh.triangles) {
    const double third = compute_double_area(mesh.vertices, t).norm() / 6.0;
    for (const int vertex : t) areas[vertex] += third;
  }
  return areas;
}

Vec3Array compute_vertex_normals(std::span<const Vec3> vertices,
                                 std::span<const Triangle> triangles) {
  Vec3Array normals(vertices.size(), Vec3::Zero());
  std::vector<double> areas(vertices.size(), 0.0);
  for (const Triangle& t : triangles) {
    const Vec3 weighted = compute_double_area(vertices, t);
    for (const int vertex : t) {
      normals[vertex] += weighted;
      areas[vertex] += weighted.norm();
    }
  }
  // what is left of triangles that cancel is rounding; a direction made of it would mean nothing
  constexpr double kCancelled = 1e-12;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const double length = normals[i].norm();
    normals[i] = length > kCancelled * areas[i] ? Vec3(normals[i] / length) : Vec3::Zero();
  }
  return normals;
}

/// The angle from its sine and cosine together: exact at 0, where an arc cosine loses half the
/// digits, and 0 at a corner without sides.
double compute_smallest_angle(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) return 0.0;
  double smallest = std::numbers::pi;
  for (const Triangle& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) {
      const Vec3& apex = mesh.vertices[t[c]];
      const Vec3 u = mesh.vertices[t[(c + 1) % 3]] - apex, v = mesh.vertices[t[(c + 2) % 3]] - apex;
      smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  }
  return smallest;
}

std::array<Vec3, 2> compute_bounds(std::span<const Vec3> vertices) {
  if (vertices.empty()) return {Vec3::Zero(), Vec3::Zero()};
  Vec3 low = vertices[0], high = vertices[0];
  for (const Vec3& x : vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return {low, high};
}

double compute_diagonal(std::span<const Vec3> vertices) {
  const auto [low, high] = compute_bounds(vertices);
  return (high - low).norm();
}

}  // namespace palpate

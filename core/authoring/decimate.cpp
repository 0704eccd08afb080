// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/decimate.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <string>

#include "palpate/authoring/collapse_edges.h"
#include "palpate/authoring/improve_triangles.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {
namespace {

double to_degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

/// Corner, middle of the next side, for each corner, and the middle of the triangle.
std::array<Vec3, 7> sample(const SurfaceMesh& mesh, const Triangle& t) {
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  return {a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3.0};
}

double area_of(const SurfaceMesh& mesh, const Triangle& t) {
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  return 0.5 * (b - a).cross(c - a).norm();
}

void measure_distance(const SurfaceMesh& from, const SourceSurface& source, DecimatedMesh& to) {
  double sum = 0.0, area = 0.0, furthest = 0.0;
  for (const Triangle& t : to.mesh.triangles) {
    double middle = 0.0;
    for (const Vec3& p : sample(to.mesh, t)) {
      middle = (source.find_closest(p).point - p).norm();  // of the last sample in the end
      furthest = std::max(furthest, middle);
    }
    const double part = area_of(to.mesh, t);
    sum += part * middle;
    area += part;
  }
  const SourceSurface result(to.mesh);
  for (const Vec3& p : from.vertices) {
    furthest = std::max(furthest, (result.find_closest(p).point - p).norm());
  }
  to.mean_distance = sum / area;
  to.max_distance = furthest;
}

void validate_count(const SurfaceMesh& mesh, int vertex_count) {
  const int most = static_cast<int>(mesh.vertices.size());
  if (vertex_count >= 4 && vertex_count <= most) return;
  throw std::invalid_argument("decimate: vertex_count must be 4 to " + std::to_string(most) +
                              ", the vertices of the mesh, got " + std::to_string(vertex_count));
}

}  // namespace

DecimatedMesh decimate(const SurfaceMesh& mesh, int vertex_count) {
  validate(mesh);
  validate_count(mesh, vertex_count);
  DecimatedMesh result{};
  result.mesh = collapse_edges(mesh, vertex_count);
  const int reached = static_cast<int>(result.mesh.vertices.size());
  if (reached != vertex_count) {
    throw std::invalid_argument("decimate: vertex_count must be at least " +
                                std::to_string(reached) + ", as far as this mesh goes, got " +
                                std::to_string(vertex_count));
  }
  result.smallest_angle_before_deg = to_degrees(compute_smallest_angle(result.mesh));

  const SourceSurface source(mesh);
  improve_triangles(mesh, source, result.mesh);
  validate(result.mesh);
  result.smallest_angle_deg = to_degrees(compute_smallest_angle(result.mesh));
  measure_distance(mesh, source, result);
  if (const auto faces = find_self_intersecting_faces(result.mesh)) {
    result.self_intersecting_faces = static_cast<int>(faces->size());
  }
  return result;
}

}  // namespace palpate::authoring

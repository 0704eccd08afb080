// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/decimate.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <string>

#include "palpate/authoring/collapse_edges.h"
#include "palpate/authoring/improve_triangles.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/authoring/surface_distance.h"
#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {
namespace {

double to_degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

void measure(const SurfaceMesh& from, const SourceSurface& source, DecimatedMesh& to) {
  const SurfaceDistance there = measure_distance(to.mesh, from, source);
  const SurfaceDistance back = measure_distance(from, to.mesh, SourceSurface(to.mesh));
  to.mean_distance = there.mean;
  to.max_distance = std::max(there.most, back.most);
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
  measure(mesh, source, result);
  if (const auto faces = find_self_intersecting_faces(result.mesh)) {
    result.self_intersecting_faces = static_cast<int>(faces->size());
  }
  return result;
}

}  // namespace palpate::authoring

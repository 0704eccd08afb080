// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/inspect_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/authoring/edge_groups.h"
#include "palpate/authoring/orient.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

/// Whether two surfaces, or two places of one, touch in a vertex without sharing an edge there.
bool has_pinched_vertex(const SurfaceMesh& mesh) {
  const int vertex_count = static_cast<int>(mesh.vertices.size());
  int next = vertex_count;
  separate_fans(mesh.triangles, next);
  return next > vertex_count;
}

/// Handles of a manifold of s shells and b border loops: 2 s - 2 g - b = V - E + F.
int compute_genus(int shells, int loops, std::span<const Triangle> triangles) {
  return (2 * shells - loops - compute_euler_number(triangles)) / 2;
}

std::optional<double> finite(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<int> measure_loops(std::span<const Triangle> triangles) {
  std::vector<int> lengths;
  for (const auto& loop : find_border_loops(triangles)) {
    lengths.push_back(static_cast<int>(loop.size()));
  }
  std::sort(lengths.rbegin(), lengths.rend());
  return lengths;
}

int count_shells(const SurfaceMesh& mesh) {
  const auto shells = find_shells(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  return shells.empty() ? 0 : *std::max_element(shells.begin(), shells.end()) + 1;
}

}  // namespace

MeshReport inspect_mesh(const SurfaceMesh& mesh) {
  MeshReport report;
  report.vertices = static_cast<int>(mesh.vertices.size());
  report.triangles = static_cast<int>(mesh.triangles.size());
  if (mesh.triangles.empty()) return report;

  report.shells = count_shells(mesh);
  report.border_loops = measure_loops(mesh.triangles);
  report.closed = report.border_loops.empty();
  report.non_manifold_edges = count_crowded_edges(mesh.triangles);
  if (auto faces = find_self_intersecting_faces(mesh)) {
    report.self_intersecting_faces = static_cast<int>(faces->size());
    report.crossing_faces = *std::move(faces);
  }
  report.smallest_angle_deg = finite(compute_smallest_angle(mesh) * 180.0 / std::numbers::pi);
  const auto [low, high] = compute_bounds(mesh.vertices);
  for (int i = 0; i < 3; ++i) report.size_mm[i] = 1e3 * (high[i] - low[i]);

  SurfaceMesh turned = mesh;
  const Orientation orientation = orient(turned);
  report.orientable = orientation.orientable;
  if (report.non_manifold_edges > 0 || !orientation.orientable) return report;
  const int loops = static_cast<int>(report.border_loops.size());
  if (!has_pinched_vertex(mesh)) report.genus = compute_genus(report.shells, loops, mesh.triangles);
  if (report.closed) {
    report.outward = orientation.turned == 0;
    report.volume_ml = finite(1e6 * std::abs(compute_volume(turned)));
  }
  return report;
}

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/inspect_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "palpate/authoring/edge_groups.h"
#include "palpate/authoring/join_parts.h"
#include "palpate/authoring/orient.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/authoring/triangle_shape.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

/// All triangles of an edge hang together, however many there are.
std::vector<std::array<int, 2>> join_all(std::span<const HalfEdge> edge) {
  std::vector<std::array<int, 2>> pairs;
  for (int i = 1; i < static_cast<int>(edge.size()); ++i) pairs.push_back({i - 1, i});
  return pairs;
}

/// Where two surfaces, or two places of one, touch in a vertex without sharing an edge there.
std::vector<int> find_pinched_vertices(const SurfaceMesh& mesh) {
  const int vertex_count = static_cast<int>(mesh.vertices.size());
  int next = vertex_count;
  const std::vector<int> parted = separate_fans(mesh.triangles, next, join_all);
  std::vector<int> found;
  for (std::size_t i = 0; i < parted.size(); ++i) {
    if (parted[i] >= vertex_count) found.push_back(mesh.triangles[i / 3][i % 3]);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Handles of a manifold of s shells and b border loops: 2 s - 2 g - b = V - E + F.
int compute_genus(const MeshReport& report) {
  const int loops = static_cast<int>(report.border_loops.size());
  return (2 * report.shells - loops - report.euler_number) / 2;
}

std::optional<double> finite(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

void measure_borders(const SurfaceMesh& mesh, MeshReport& report) {
  std::vector<std::pair<int, double>> borders;
  for (const auto& loop : find_border_loops(mesh.triangles)) {
    double length = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      length += (mesh.vertices[loop[(i + 1) % loop.size()]] - mesh.vertices[loop[i]]).norm();
    }
    borders.emplace_back(static_cast<int>(loop.size()), 1e3 * length);
  }
  std::sort(borders.rbegin(), borders.rend());
  for (const auto& [vertices, length] : borders) {
    report.border_loops.push_back(vertices);
    report.border_lengths_mm.push_back(length);
  }
  report.closed = borders.empty();
}

int count_shells(const SurfaceMesh& mesh) {
  const auto shells = find_shells(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  return shells.empty() ? 0 : *std::max_element(shells.begin(), shells.end()) + 1;
}

void count_edge_faults(const SurfaceMesh& mesh, MeshReport& report) {
  const std::vector<HalfEdge> sides = sort_half_edges(mesh.triangles);
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    report.non_manifold_edges += edge.size() > 2;
    report.disagreeing_edges += edge.size() == 2 && edge[0].forward == edge[1].forward;
  });
}

int count_coincident(const SurfaceMesh& mesh) {
  std::vector<std::array<double, 3>> places;
  for (const Vec3& x : mesh.vertices) places.push_back({x.x(), x.y(), x.z()});
  std::sort(places.begin(), places.end());
  return static_cast<int>(places.end() - std::unique(places.begin(), places.end()));
}

std::vector<int> find_duplicates(std::span<const Triangle> triangles) {
  std::vector<std::tuple<Triangle, int>> rows;
  for (int face = 0; face < static_cast<int>(triangles.size()); ++face) {
    Triangle t = triangles[face];
    std::sort(t.begin(), t.end());
    rows.emplace_back(t, face);
  }
  std::sort(rows.begin(), rows.end());
  std::vector<int> found;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (std::get<0>(rows[i]) == std::get<0>(rows[i - 1])) found.push_back(std::get<1>(rows[i]));
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<int> find_degenerate(const SurfaceMesh& mesh) {
  const double tolerance = kWeldTolerance * compute_diagonal(mesh.vertices);
  std::vector<int> found;
  for (int face = 0; face < static_cast<int>(mesh.triangles.size()); ++face) {
    if (find_flat_corner(corners_of(mesh, mesh.triangles[face]), tolerance) >= 0) {
      found.push_back(face);
    }
  }
  return found;
}

void find_faults(const SurfaceMesh& mesh, MeshReport& report) {
  count_edge_faults(mesh, report);
  report.pinched_vertices = find_pinched_vertices(mesh);
  report.coincident_vertices = count_coincident(mesh);
  report.duplicate_faces = find_duplicates(mesh.triangles);
  report.degenerate_faces = find_degenerate(mesh);
  if (auto faces = find_self_intersecting_faces(mesh)) {
    report.self_intersecting_faces = static_cast<int>(faces->size());
    report.crossing_faces = *std::move(faces);
  }
}

void measure_triangles(const SurfaceMesh& mesh, MeshReport& report) {
  report.smallest_angle_deg = finite(compute_smallest_angle(mesh) * 180.0 / std::numbers::pi);
  report.angles_deg = count_angles(mesh);
  EdgeLengths edges = measure_edges(mesh);
  report.edges_mm = {{1e3 * edges.shortest, 1e3 * edges.median, 1e3 * edges.longest}};
  for (double& limit : edges.lengths.limits) limit *= 1e3;
  report.edge_lengths_mm = std::move(edges.lengths);
  const auto [low, high] = compute_bounds(mesh.vertices);
  for (int i = 0; i < 3; ++i) report.size_mm[i] = 1e3 * (high[i] - low[i]);
}

/// Which side is outside, and what that lets one measure.
void measure_body(const SurfaceMesh& mesh, MeshReport& report) {
  SurfaceMesh turned = mesh;
  const Orientation orientation = orient(turned);
  report.orientable = orientation.orientable;
  Thickness thickness = measure_thickness(turned);
  report.thickness_looks = thickness.looks;
  report.thin_faces = std::move(thickness.thin_faces);
  if (thickness.thinnest) report.thinnest_mm = 1e3 * *thickness.thinnest;
  if (report.non_manifold_edges > 0 || !orientation.orientable) return;
  if (report.pinched_vertices.empty()) report.genus = compute_genus(report);
  if (report.closed) {
    report.outward = orientation.turned == 0;
    report.volume_ml = finite(1e6 * std::abs(compute_volume(turned)));
  }
}

}  // namespace

MeshReport inspect_mesh(const SurfaceMesh& mesh) {
  MeshReport report;
  report.vertices = static_cast<int>(mesh.vertices.size());
  report.triangles = static_cast<int>(mesh.triangles.size());
  if (mesh.triangles.empty()) return report;
  report.shells = count_shells(mesh);
  report.euler_number = compute_euler_number(mesh.triangles);
  measure_borders(mesh, report);
  find_faults(mesh, report);
  measure_triangles(mesh, report);
  measure_body(mesh, report);
  return report;
}

}  // namespace palpate::authoring

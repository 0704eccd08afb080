// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/smooth_surface.h"

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

/// [Taubin95] 1/kSmooth + 1/kSwell = 0.1: what is longer than some ten edges passes unchanged.
constexpr double kSmooth = 0.6307, kSwell = -0.6732;

/// The volume is met to a millionth in two; each cures what the curvature added to the one before.
constexpr int kVolumeSteps = 4;

struct Neighbours {
  explicit Neighbours(const SurfaceMesh& mesh)
      : edges(build_topology(mesh.triangles)),
        count(mesh.vertices.size(), 0),
        border(mesh.vertices.size(), 0) {
    for (std::size_t e = 0; e < edges.edges.size(); ++e) {
      for (const int v : edges.edges[e]) {
        ++count[v];
        if (edges.edge_triangles[e][1] < 0) border[v] = 1;
      }
    }
  }

  Topology edges;
  std::vector<int> count;
  std::vector<char> border;
};

/// Moves each vertex by `factor` of the way to the mean of its neighbours.
void move_to_mean(const Neighbours& neighbours, double factor, Vec3Array& x) {
  Vec3Array sum(x.size(), Vec3::Zero());
  for (const auto& [i, j] : neighbours.edges.edges) {
    sum[i] += x[j];
    sum[j] += x[i];
  }
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (neighbours.border[v]) continue;
    x[v] += factor * (sum[v] / neighbours.count[v] - x[v]);
  }
}

void restore_volume(double wanted, SurfaceMesh& mesh) {
  for (int step = 0; step < kVolumeSteps; ++step) {
    const double move = (wanted - compute_volume(mesh)) / compute_area(mesh);
    const Vec3Array normals = compute_vertex_normals(mesh.vertices, mesh.triangles);
    for (std::size_t v = 0; v < normals.size(); ++v) mesh.vertices[v] += move * normals[v];
  }
}

}  // namespace

SurfaceMesh smooth_surface(const SurfaceMesh& mesh, int steps) {
  validate(mesh);
  if (steps < 1) refuse("smooth: steps", write_text(steps), "1 or more");
  SurfaceMesh smooth = mesh;
  const Neighbours neighbours(mesh);
  for (int step = 0; step < steps; ++step) {
    move_to_mean(neighbours, kSmooth, smooth.vertices);
    move_to_mean(neighbours, kSwell, smooth.vertices);
  }
  if (is_closed(mesh.triangles)) restore_volume(compute_volume(mesh), smooth);
  return smooth;
}

}  // namespace palpate::authoring

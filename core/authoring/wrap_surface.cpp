// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/wrap_surface.h"

#include <cmath>

#include "palpate/authoring/cgal/wrap_triangles.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate::authoring {
namespace {

/// Of the diagonal: a wrap of a thousandth has a million triangles.
constexpr double kSmallestAlpha = 1e-3;

void check(const SurfaceMesh& mesh, double alpha) {
  if (mesh.triangles.empty()) refuse("wrap", "no triangles", "a surface");
  for (const Vec3& p : mesh.vertices) {
    if (!p.allFinite()) refuse("wrap: vertices", "one that is not finite", "finite numbers");
  }
  const double least = kSmallestAlpha * compute_diagonal(mesh.vertices);
  if (!(alpha >= least) || !std::isfinite(alpha)) {
    refuse("wrap: alpha", write_text(1e3 * alpha, " mm"),
           write_text(1e3 * least, " mm or more, a thousandth of the diagonal"));
  }
}

/// Moves every vertex inwards by the offset, where that crosses nothing.
void draw_back(double offset, SurfaceMesh& mesh) {
  const Vec3Array before = mesh.vertices;
  const Vec3Array normals = compute_vertex_normals(mesh.vertices, mesh.triangles);
  for (std::size_t v = 0; v < normals.size(); ++v) mesh.vertices[v] -= offset * normals[v];
  const auto faces = find_self_intersecting_faces(mesh);
  if (!faces || !faces->empty()) mesh.vertices = before;
}

}  // namespace

WrappedMesh wrap_surface(const SurfaceMesh& mesh, double alpha) {
  check(mesh, alpha);
  WrappedMesh wrapped{};
  wrapped.mesh = wrap_triangles(mesh, alpha, kWrapOffset * alpha);
  validate(wrapped.mesh);
  draw_back(kWrapOffset * alpha, wrapped.mesh);
  wrapped.volume = compute_volume(wrapped.mesh);
  wrapped.to_source = measure_distance(wrapped.mesh, mesh, SourceSurface(mesh));
  wrapped.from_source = measure_distance(mesh, wrapped.mesh, SourceSurface(wrapped.mesh));
  return wrapped;
}

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/wrap_surface.h"

#include <algorithm>
#include <cmath>

#include "palpate/authoring/cgal/wrap_triangles.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/tree/queries.h"

namespace palpate::authoring {
namespace {

/// Of the diagonal: a wrap of a thousandth has a million triangles.
constexpr double kSmallestAlpha = 1e-3;

/// [-] of alpha: the wrap lies on what is nearer.
constexpr double kOnIt = 0.1;

/// [-] of a piece's triangles: where the wrap lies on fewer of them, the piece lies inside.
constexpr double kLeastKept = 0.05;

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

/// The corners of the triangles of each piece.
std::vector<Vec3Array> list_pieces(const SurfaceMesh& mesh) {
  const std::vector<int> shell =
      find_shells(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  std::vector<Vec3Array> pieces;
  for (const Triangle& t : mesh.triangles) {
    const auto number = static_cast<std::size_t>(shell[t[0]]);
    if (number >= pieces.size()) pieces.resize(number + 1);
    for (const int v : t) pieces[number].push_back(mesh.vertices[v]);
  }
  return pieces;
}

/// The pieces of `source` of which `mesh` has next to nothing within `reach` [m].
std::vector<DroppedPiece> find_dropped(const SurfaceMesh& mesh, const SurfaceMesh& source,
                                       double reach) {
  const AabbTree tree(mesh.vertices, mesh.triangles);
  std::vector<DroppedPiece> dropped;
  for (const Vec3Array& x : list_pieces(source)) {
    const std::size_t count = x.size() / 3;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 middle = (x[3 * i] + x[3 * i + 1] + x[3 * i + 2]) / 3.0;
      kept += find_closest_point(tree, mesh.vertices, middle, reach).has_value();
    }
    if (static_cast<double>(kept) >= kLeastKept * static_cast<double>(count)) continue;
    const auto [low, high] = compute_bounds(x);
    const Vec3 middle = 0.5 * (low + high);
    dropped.push_back(
        {static_cast<int>(count), (high - low).norm(), {middle.x(), middle.y(), middle.z()}});
  }
  std::stable_sort(dropped.begin(), dropped.end(),
                   [](const auto& a, const auto& b) { return a.size > b.size; });
  return dropped;
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
  wrapped.from_source = measure_seen_distance(mesh, SourceSurface(wrapped.mesh));
  wrapped.dropped = find_dropped(wrapped.mesh, mesh, kOnIt * alpha);
  return wrapped;
}

}  // namespace palpate::authoring

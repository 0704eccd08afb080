// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/cgal/patch_holes.h"

#define CGAL_EIGEN3_ENABLED 1  // what bends the patches solves with Eigen

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <map>

#include "palpate/authoring/cgal/private/surface_mesh.h"

// A file of its own: a minute and more to compile, and nobody includes it.

namespace palpate::authoring {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;
using Face = Surface::Face_index;

/// The halfedge along the hole: the surface lies left of its loop, so the hole lies on the other
/// side.
Halfedge find_border(const Surface& surface, const std::vector<int>& loop) {
  const Halfedge along = surface.halfedge(to_vertex(loop[1]), to_vertex(loop[0]));
  return along != Surface::null_halfedge() && surface.is_border(along) ? along
                                                                       : Surface::null_halfedge();
}

/// Closes a hole in `surface` and says by which faces.
std::vector<Face> close(Surface& surface, Halfedge border, PatchShape shape) {
  std::vector<Face> faces;
  std::vector<Vertex> vertices;
  const auto to_faces = std::back_inserter(faces);
  const auto to_vertices = std::back_inserter(vertices);
  if (shape == PatchShape::smooth) {
    pmp::triangulate_refine_and_fair_hole(surface, border, to_faces, to_vertices);
  } else {
    pmp::triangulate_and_refine_hole(surface, border, to_faces, to_vertices);
  }
  return faces;
}

Patch read_patch(const Surface& surface, const std::vector<Face>& faces, int old_count) {
  Patch patch;
  std::map<Vertex, int> number;
  for (const Face face : faces) {
    Triangle t{};
    std::size_t corner = 0;
    for (const Vertex v : surface.vertices_around_face(surface.halfedge(face))) {
      int at = static_cast<int>(v.idx());
      if (at >= old_count) {
        const auto [found, is_new] =
            number.try_emplace(v, old_count + static_cast<int>(patch.vertices.size()));
        at = found->second;
        const auto& p = surface.point(v);
        if (is_new) patch.vertices.emplace_back(p.x(), p.y(), p.z());
      }
      t[corner++] = at;
    }
    patch.triangles.push_back(t);
  }
  return patch;
}

}  // namespace

std::vector<Patch> patch_holes(const SurfaceMesh& mesh, const std::vector<std::vector<int>>& loops,
                               PatchShape shape) {
  std::vector<Patch> patches;
  if (loops.empty()) return patches;
  auto surface = to_surface<Surface>(mesh, "fill");
  for (const auto& loop : loops) {
    const Halfedge border = find_border(surface, loop);
    patches.emplace_back();
    if (border == Surface::null_halfedge()) continue;
    const std::vector<Face> faces = close(surface, border, shape);
    patches.back() = read_patch(surface, faces, static_cast<int>(mesh.vertices.size()));
  }
  return patches;
}

}  // namespace palpate::authoring

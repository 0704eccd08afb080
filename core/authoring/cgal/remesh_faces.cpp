// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/cgal/remesh_faces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include "palpate/sim/base/private/refuse.h"

// A file of its own: a minute and more to compile, and nobody includes it.

namespace palpate::authoring {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;
using Face = Surface::Face_index;

/// Of splitting, collapsing, flipping and sliding; more change little.
constexpr unsigned kRounds = 5;

/// Of the length that is asked for, the edges come out this much shorter in the middle.
constexpr double kShorter = 0.91;

Vertex to_vertex(int v) { return Vertex(static_cast<unsigned>(v)); }

Surface to_surface(const SurfaceMesh& mesh) {
  Surface surface;
  for (const Vec3& p : mesh.vertices) surface.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (surface.add_face(to_vertex(a), to_vertex(b), to_vertex(c)) == Surface::null_face()) {
      refuse(write_text("remesh: triangle ", i), "an edge or a vertex shared by too many",
             "a manifold surface");
    }
  }
  return surface;
}

SurfaceMesh to_mesh(Surface& surface) {
  surface.collect_garbage();
  SurfaceMesh mesh;
  for (const Vertex v : surface.vertices()) {
    const auto& p = surface.point(v);
    mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const Face face : surface.faces()) {
    Triangle t{};
    std::size_t corner = 0;
    for (const Vertex v : surface.vertices_around_face(surface.halfedge(face))) {
      t[corner++] = static_cast<int>(v.idx());
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

}  // namespace

SurfaceMesh remesh_faces(const SurfaceMesh& mesh, const std::vector<char>& chosen,
                         double edge_length, double sharp) {
  Surface surface = to_surface(mesh);
  std::vector<Face> faces;
  for (const Face face : surface.faces()) {
    if (chosen[face.idx()]) faces.push_back(face);
  }
  if (faces.empty()) return mesh;
  const auto [kept, is_new] = surface.add_property_map<Surface::Edge_index, bool>("kept", false);
  pmp::detect_sharp_edges(surface, sharp, kept);
  pmp::isotropic_remeshing(faces, edge_length / kShorter, surface,
                           CGAL::parameters::number_of_iterations(kRounds)
                               .edge_is_constrained_map(kept)
                               .number_of_relaxation_steps(3)
                               .relax_constraints(true));
  return to_mesh(surface);
}

}  // namespace palpate::authoring

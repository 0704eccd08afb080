// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"

// For the files that compile CGAL's algorithms, each with the points that it needs; no other header
// includes it.

namespace palpate::authoring {

inline CGAL::SM_Vertex_index to_vertex(int v) {
  return CGAL::SM_Vertex_index(static_cast<unsigned>(v));
}

/// With the numbers of vertices and triangles as they are. Throws std::invalid_argument, naming
/// `work`, where the triangles are no manifold.
template <class Surface>
Surface to_surface(const SurfaceMesh& mesh, const char* work) {
  Surface surface;
  for (const Vec3& p : mesh.vertices) {
    surface.add_vertex(typename Surface::Point(p.x(), p.y(), p.z()));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (surface.add_face(to_vertex(a), to_vertex(b), to_vertex(c)) == Surface::null_face()) {
      refuse(write_text(work, ": triangle ", i), "an edge or a vertex shared by too many",
             "a manifold surface");
    }
  }
  return surface;
}

/// What of it was not removed, in its order; exact points are rounded.
template <class Surface>
SurfaceMesh to_mesh(const Surface& surface) {
  SurfaceMesh mesh;
  std::vector<int> number(surface.num_vertices() + surface.number_of_removed_vertices(), -1);
  for (const auto v : surface.vertices()) {
    number[v.idx()] = static_cast<int>(mesh.vertices.size());
    const auto& p = surface.point(v);
    mesh.vertices.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                               CGAL::to_double(p.z()));
  }
  for (const auto face : surface.faces()) {
    Triangle t{};
    std::size_t corner = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(face))) {
      t[corner++] = number[v.idx()];
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

}  // namespace palpate::authoring

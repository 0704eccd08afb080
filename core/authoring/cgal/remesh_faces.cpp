// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/cgal/remesh_faces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include "palpate/authoring/cgal/private/surface_mesh.h"

// A file of its own: a minute and more to compile, and nobody includes it.

namespace palpate::authoring {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Surface::Face_index;

/// Of splitting, collapsing, flipping and sliding; more change little.
constexpr unsigned kRounds = 5;

/// Of the length that is asked for, the edges come out this much shorter in the middle.
constexpr double kShorter = 0.91;

}  // namespace

SurfaceMesh remesh_faces(const SurfaceMesh& mesh, const std::vector<char>& chosen,
                         double edge_length, double sharp) {
  auto surface = to_surface<Surface>(mesh, "remesh");
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
  surface.collect_garbage();
  return to_mesh(surface);
}

}  // namespace palpate::authoring

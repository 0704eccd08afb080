// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/cgal/combine_solids.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <map>
#include <utility>

#include "palpate/authoring/cgal/private/surface_mesh.h"

// A file of its own: minutes to compile, and nobody includes it.

namespace palpate::authoring {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
// exact points, as a solid that was cut is cut again
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

bool is_apart(const Surface& a, const Surface& b) {
  return a.is_empty() || b.is_empty() || !CGAL::do_overlap(pmp::bbox(a), pmp::bbox(b));
}

/// Puts the union of both into the first; false where that is not a manifold.
bool unite(Surface& a, Surface& b) {
  if (is_apart(a, b)) {
    a += b;
    return true;
  }
  return pmp::corefine_and_compute_union(a, b, a);
}

/// Two by two, so that every triangle is cut a few times and not as often as there are solids.
bool unite_all(std::vector<Surface>& solids) {
  while (solids.size() > 1) {
    std::vector<Surface> larger;
    for (std::size_t i = 0; i < solids.size(); i += 2) {
      if (i + 1 < solids.size() && !unite(solids[i], solids[i + 1])) return false;
      larger.push_back(std::move(solids[i]));
    }
    solids = std::move(larger);
  }
  return true;
}

std::vector<Surface> to_surfaces(const std::vector<SurfaceMesh>& meshes) {
  std::vector<Surface> surfaces;
  for (const SurfaceMesh& mesh : meshes) {
    surfaces.push_back(to_surface<Surface>(mesh, "parts"));
  }
  return surfaces;
}

}  // namespace

std::optional<SurfaceMesh> combine_solids(const std::vector<SurfaceMesh>& kept,
                                          const std::vector<SurfaceMesh>& taken) {
  std::vector<Surface> more = to_surfaces(kept), less = to_surfaces(taken);
  if (more.empty()) return SurfaceMesh{};
  if (!unite_all(more) || !unite_all(less)) return std::nullopt;
  Surface& solid = more.front();
  if (!less.empty() && !is_apart(solid, less.front()) &&
      !pmp::corefine_and_compute_difference(solid, less.front(), solid)) {
    return std::nullopt;
  }
  return to_mesh(solid);
}

}  // namespace palpate::authoring

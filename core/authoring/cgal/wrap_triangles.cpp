// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/cgal/wrap_triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/alpha_wrap_3.h>

#include "palpate/authoring/cgal/private/quick_boxes.h"
#include "palpate/authoring/cgal/private/surface_mesh.h"

// A file of its own: a minute to compile, and nobody includes it.

namespace palpate::authoring {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

}  // namespace

SurfaceMesh wrap_triangles(const SurfaceMesh& mesh, double alpha, double offset) {
  std::vector<Kernel::Point_3> points;
  points.reserve(mesh.vertices.size());
  for (const Vec3& p : mesh.vertices) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::array<std::size_t, 3>> faces;
  faces.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    faces.push_back({static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                     static_cast<std::size_t>(t[2])});
  }
  Surface wrapped;
  const auto options = CGAL::parameters::geom_traits(QuickBoxKernel());
  CGAL::alpha_wrap_3(points, faces, alpha, offset, wrapped, options);
  return to_mesh(wrapped);
}

}  // namespace palpate::authoring

// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/fill_interior.h"

#include <algorithm>
#include <cmath>

#include "palpate/authoring/cgal/fill_with_mesh_3.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

/// Mesh_3 at a cell size L gives this many tetrahedra per volume of L³, from 5.4 on the shipped
/// spleen to 6.8 on the kidney, whose surface is large for its volume.
constexpr double kTetrahedraPerCell = 6.0;
/// [-] A cell size that was chosen for the most there may be gives as many but for rounding.
constexpr double kRounding = 1e-9;

void check_surface(const SurfaceMesh& surface) {
  validate(surface);
  if (!is_closed(surface.triangles)) {
    const std::size_t loops = find_border_loops(surface.triangles).size();
    refuse("fill: surface",
           write_text("an open one, with ", loops, loops == 1 ? " hole" : " holes"),
           "a closed one: nothing says how far the inside of an open one goes");
  }
  const double volume = compute_volume(surface);
  if (!(volume > 0.0)) {
    refuse("fill: surface", write_text("a volume of ", volume, " m³"),
           "a positive one: triangles counter-clockwise from outside");
  }
  const auto crossing = find_self_intersecting_faces(surface);
  if (!crossing || !crossing->empty()) {
    refuse("fill: surface",
           crossing ? write_text(crossing->size(), " triangles that cross others")
                    : std::string("more triangles upon each other than can be counted"),
           "a surface that does not cross itself");
  }
}

/// Without vertices that only flat tetrahedra had, and without those.
SolidMesh tidy(const SolidMesh& solid) {
  SolidMesh tidied;
  std::vector<int> number(solid.vertices.size(), -1);
  for (auto corners : solid.tetrahedra) {
    auto& [a, b, c, d] = corners;
    const double volume =
        compute_volume(solid.vertices[a], solid.vertices[b], solid.vertices[c], solid.vertices[d]);
    if (volume == 0.0) continue;
    if (volume < 0.0) std::swap(c, d);
    for (int& i : corners) {
      if (number[i] < 0) {
        number[i] = static_cast<int>(tidied.vertices.size());
        tidied.vertices.push_back(solid.vertices[i]);
      }
      i = number[i];
    }
    tidied.tetrahedra.push_back(corners);
  }
  return tidied;
}

}  // namespace

void check_cell_size(const SurfaceMesh& surface, double cell_size) {
  if (!(std::isfinite(cell_size) && cell_size > 0.0)) {
    refuse("fill: cell_size", write_text(cell_size, " m"), "a positive number");
  }
  const double volume = compute_volume(surface);
  const double expected = kTetrahedraPerCell * volume / std::pow(cell_size, 3);
  if (expected > kMostTetrahedra * (1.0 + kRounding)) {
    refuse(
        "fill: cell_size",
        write_text(1e3 * cell_size, " mm, which gives about ", std::round(expected), " tetrahedra"),
        write_text("at least ", 1e3 * std::cbrt(kTetrahedraPerCell * volume / kMostTetrahedra),
                   " mm for at most ", kMostTetrahedra));
  }
}

double choose_cell_size(const SurfaceMesh& surface, int tetrahedron_count) {
  check_surface(surface);
  if (tetrahedron_count < 1 || tetrahedron_count > kMostTetrahedra) {
    refuse("fill: tetrahedron_count", write_text(tetrahedron_count),
           write_text("1 to ", kMostTetrahedra));
  }
  return std::cbrt(kTetrahedraPerCell * compute_volume(surface) / tetrahedron_count);
}

SolidMesh fill_interior(const SurfaceMesh& surface, double cell_size) {
  check_surface(surface);
  check_cell_size(surface, cell_size);
  SolidMesh solid = tidy(fill_with_mesh_3(surface, cell_size));
  if (solid.tetrahedra.empty()) {
    refuse("fill: cell_size", write_text(1e3 * cell_size, " mm, at which nothing is filled"),
           "a smaller one");
  }
  validate(solid);
  return solid;
}

}  // namespace palpate::authoring

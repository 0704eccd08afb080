// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/cgal/fill_with_mesh_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Random.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <map>
#include <stdexcept>

#include "palpate/authoring/cgal/private/surface_mesh.h"

// A file of its own: minutes and gigabytes to compile, and nobody includes it.

namespace palpate::authoring {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_3<Surface, Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Sequential_tag>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

// with these, perturbing and exuding leave dihedral angles of 12 degrees and more [laws: filling]
constexpr double kFacetAngle = 25.0;      // [degree]
constexpr double kFacetDistance = 0.15;   // of the cell size
constexpr double kRadiusEdgeRatio = 2.0;  // of a cell's circumsphere to its shortest edge
constexpr unsigned kSeed = 1;
/// [s] Else perturbing and exuding may take as long as refining did, on this machine, just then.
constexpr double kNoLimit = 0.0;

SolidMesh to_solid(const Complex& complex) {
  SolidMesh solid;
  std::map<Triangulation::Vertex_handle, int> number;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end();
       ++cell) {
    std::array<int, 4> corners{};
    for (int c = 0; c < 4; ++c) {
      const auto [at, is_new] =
          number.try_emplace(cell->vertex(c), static_cast<int>(solid.vertices.size()));
      if (is_new) {
        const auto& p = complex.triangulation().point(cell->vertex(c));
        solid.vertices.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                    CGAL::to_double(p.z()));
      }
      corners[static_cast<std::size_t>(c)] = at->second;
    }
    solid.tetrahedra.push_back(corners);
  }
  return solid;
}

/// A size, or a distance from the surface, that depends on the place.
struct Field {
  using FT = Kernel::FT;
  using Index = Domain::Index;

  FT operator()(const Kernel::Point_3& p, int, const Index&) const {
    return share * near({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }

  std::function<double(const Vec3&)> near;
  double share = 1.0;
};

Criteria build_criteria(const CellSize& size) {
  namespace parameters = CGAL::parameters;
  if (!size.near) {
    return Criteria(parameters::facet_angle = kFacetAngle, parameters::facet_size = size.largest,
                    parameters::facet_distance = kFacetDistance * size.largest,
                    parameters::cell_radius_edge_ratio = kRadiusEdgeRatio,
                    parameters::cell_size = size.largest);
  }
  const Field field{size.near};
  return Criteria(parameters::facet_angle = kFacetAngle, parameters::facet_size = field,
                  parameters::facet_distance = Field{size.near, kFacetDistance},
                  parameters::cell_radius_edge_ratio = kRadiusEdgeRatio,
                  parameters::cell_size = field);
}

}  // namespace

SolidMesh fill_with_mesh_3(const SurfaceMesh& surface, const CellSize& size,
                           const Accepts& accepts) {
  namespace parameters = CGAL::parameters;
  // perturbing draws from CGAL's own source, which else begins with the time of day
  CGAL::get_default_random() = CGAL::Random(kSeed);
  const auto bounded = to_surface<Surface>(surface, "fill");
  const Domain domain(bounded);
  Complex complex = CGAL::make_mesh_3<Complex>(domain, build_criteria(size), parameters::no_lloyd(),
                                               parameters::no_odt(), parameters::no_perturb(),
                                               parameters::no_exude());
  if (accepts && !accepts(complex.number_of_cells_in_complex())) return {};
  CGAL::perturb_mesh_3(complex, domain, parameters::time_limit = kNoLimit);
  CGAL::exude_mesh_3(complex, parameters::time_limit = kNoLimit);
  return to_solid(complex);
}

}  // namespace palpate::authoring

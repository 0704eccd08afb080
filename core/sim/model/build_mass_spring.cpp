// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/model/private/surface_particles.h"

namespace palpate {

/// k = sqrt(3)/2 E h: springs along the edges of equilateral triangles stretch like a membrane of
/// Young's modulus E and thickness h, with a Poisson's ratio of 1/3 whatever the material's is
/// [VanGelder98], [laws: lattice].
double membrane_spring_stiffness(const Material& material) {
  validate(material);
  if (!material.wall_thickness) {
    refuse("material: wall_thickness", "none", "the thickness of the membrane [m]");
  }
  return 0.5 * std::sqrt(3.0) * material.young_modulus * *material.wall_thickness;
}

TissueModel build_mass_spring(const SurfaceMesh& mesh, const Material& material, double stiffness,
                              const SurfaceOptions& options) {
  if (!(std::isfinite(stiffness) && stiffness > 0.0)) {
    refuse("mass-spring: stiffness", write_text(stiffness, " N/m"), "a positive number");
  }
  TissueModel model = build_surface_particles(mesh, material, options);
  const std::vector<std::array<int, 2>> edges = build_topology(mesh.triangles).edges;
  std::vector<double> stiffnesses;
  stiffnesses.reserve(edges.size());
  for (const auto& ends : edges) {
    stiffnesses.push_back(stiffness * compute_local_scale(options.stiffness_scale, ends));
  }
  model.springs = build_edge_links(model, edges, std::move(stiffnesses), material.damping_ratio);
  validate(model);
  return model;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "palpate/sim/model/build_solid.h"
#include "palpate/sim/model/private/surface_particles.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {
namespace {

/// [s] c/k of the link between i and j; links ascend, as build_solid makes them.
double find_link_time(const Links& links, int i, int j) {
  const std::array<int, 2> ends = {std::min(i, j), std::max(i, j)};
  const auto at = std::ranges::lower_bound(links.ends, ends);
  const auto l = static_cast<std::size_t>(at - links.ends.begin());
  return links.damping[l] / links.stiffness[l];
}

/// [s] The mean of c/k over the six edges of a tetrahedron.
double compute_damping_time(const Links& links, const std::array<int, 4>& corners) {
  double sum = 0.0;
  for (std::size_t p = 0; p < 4; ++p) {
    for (std::size_t q = p + 1; q < 4; ++q) sum += find_link_time(links, corners[p], corners[q]);
  }
  return sum / 6.0;
}

/// Masses, surface and all checks are those of build_solid; what resists is another. Links of
/// stiffness k and damping c that hold as mu does damp as a viscosity of mu c/k [laws: viscosity].
TissueModel build_with(Hyperelastic TissueModel::*table, const SolidMesh& solid,
                       const Material& material, const SolidOptions& options) {
  TissueModel model = build_solid(solid, material, options);
  const LameConstants lame = compute_lame_constants(material);
  std::vector<double> lambda, mu, viscosity;
  for (const auto& corners : solid.tetrahedra) {
    const double scale = compute_local_scale(options.stiffness_scale, corners);
    lambda.push_back(scale * lame.lambda);
    mu.push_back(scale * lame.mu);
    viscosity.push_back(mu.back() * compute_damping_time(model.springs, corners));
  }
  model.springs = {};
  model.volumes = {};
  model.damping_law = DampingLaw::axis;
  model.*table = build_hyperelastic(particle_count(model), solid.tetrahedra, std::move(lambda),
                                    std::move(mu), std::move(viscosity), options.nodal_share);
  validate(model);
  return model;
}

}  // namespace

TissueModel build_corotated_solid(const SolidMesh& solid, const Material& material,
                                  const SolidOptions& options) {
  return build_with(&TissueModel::corotated, solid, material, options);
}

TissueModel build_neo_hookean_solid(const SolidMesh& solid, const Material& material,
                                    const SolidOptions& options) {
  return build_with(&TissueModel::neo_hookean, solid, material, options);
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/model/build_solid.h"
#include "palpate/sim/model/private/surface_particles.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {
namespace {

double compute_mean_length(const Links& links) {
  double sum = 0.0;
  for (const double length : links.rest_length) sum += length;
  return sum / static_cast<double>(links.rest_length.size());
}

/// [s] 2 zeta L sqrt(rho/mu): a link of length L and the mass of the material around it swings in
/// about the time in which a shear wave passes it, and zeta is the damping ratio of such a link.
double choose_damping_time(const Material& material, double shear, double edge) {
  return 2.0 * material.damping_ratio * edge * std::sqrt(material.density / shear);
}

}  // namespace

/// Masses, surface and all checks are those of build_solid; what resists is another.
TissueModel build_linear_solid(const SolidMesh& solid, const Material& material,
                               const SolidOptions& options) {
  TissueModel model = build_solid(solid, material, options);
  const double edge = compute_mean_length(model.springs);
  const LameConstants lame = compute_lame_constants(material);
  std::vector<double> lambda, mu;
  for (const auto& corners : solid.tetrahedra) {
    const double scale = compute_local_scale(options.stiffness_scale, corners);
    lambda.push_back(scale * lame.lambda);
    mu.push_back(scale * lame.mu);
  }
  model.springs = {};
  model.volumes = {};
  model.drag = 0.0;
  model.damping_law = DampingLaw::axis;
  model.elastic =
      build_elastic(particle_count(model), solid.tetrahedra, std::move(lambda), std::move(mu),
                    options.nodal_share, choose_damping_time(material, lame.mu, edge));
  validate(model);
  return model;
}

TissueModel limit_reach(TissueModel model, const std::vector<int>& surface_vertices) {
  if (model.elastic.corners.empty()) {
    refuse("reach: model", "another law", "a linear solid, as build_linear_solid makes it");
  }
  if (surface_vertices.empty()) refuse("reach: surface_vertices", "none", "at least one");
  std::vector<int>& reach = model.elastic.reach;
  reach.clear();
  for (std::size_t row = 0; row < surface_vertices.size(); ++row) {
    const int v = surface_vertices[row];
    if (v < 0 || v >= surface_count(model)) {
      refuse(write_text("reach: surface_vertices: row ", row), write_text("vertex ", v),
             write_text("0 to ", surface_count(model) - 1));
    }
    if (model.skin.corners.empty()) {
      reach.push_back(v);
    } else {
      const auto& corners = model.skin.corners[static_cast<std::size_t>(v)];
      reach.insert(reach.end(), corners.begin(), corners.end());
    }
  }
  std::sort(reach.begin(), reach.end());
  reach.erase(std::unique(reach.begin(), reach.end()), reach.end());
  validate(model);
  return model;
}

}  // namespace palpate

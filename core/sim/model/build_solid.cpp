// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/build_solid.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/model/private/check_options.h"
#include "palpate/sim/model/private/surface_particles.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {
namespace {

void check_material(const Material& material) {
  validate(material);
  if (material.wall_thickness) {
    refuse("material: wall_thickness", write_text(1e3 * *material.wall_thickness, " mm"),
           "none: a solid is filled");
  }
  const double nu = material.poisson_ratio;
  if (!(nu >= kLeastSolidPoisson && nu <= kMostSolidPoisson)) {
    refuse("material: poisson_ratio", write_text(nu),
           write_text(kLeastSolidPoisson, " to ", kMostSolidPoisson, " for a solid"));
  }
}

void check_options(const SolidOptions& options, std::size_t vertex_count) {
  check_common_options(options, vertex_count);
  if (!(options.nodal_share >= 0.0 && options.nodal_share <= 1.0)) {
    refuse("options: nodal_share", write_text(options.nodal_share), "0 to 1");
  }
}

TissueModel build_particles(const SolidMesh& solid, const SolidOptions& options) {
  TissueModel model;
  model.rest_position = solid.vertices;
  model.mass.assign(solid.vertices.size(), 0.0);
  model.fixed = options.fixed;
  std::sort(model.fixed.begin(), model.fixed.end());
  model.fixed.erase(std::unique(model.fixed.begin(), model.fixed.end()), model.fixed.end());
  model.triangles = find_boundary(solid);
  model.drag = options.drag;
  model.damping_law = options.damping_law;
  return model;
}

}  // namespace

LameConstants compute_lame_constants(const Material& material) {
  validate(material);
  const double nu = material.poisson_ratio, e = material.young_modulus;
  if (!(nu < 0.5)) refuse("material: poisson_ratio", write_text(nu), "less than 0.5");
  return {e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), e / (2.0 * (1.0 + nu))};
}

/// k_e = 5/2 mu sum V/L² over the tetrahedra around an edge: averaged over all directions such
/// springs are an isotropic material with lambda = mu [VanGelder98], [laws: solid]. What that lacks
/// of lambda is left to the volumes, B = lambda - mu, which is 0 at nu = 1/4.
TissueModel build_solid(const SolidMesh& solid, const Material& material,
                        const SolidOptions& options) {
  validate(solid);
  check_material(material);
  check_options(options, solid.vertices.size());
  TissueModel model = build_particles(solid, options);
  const LameConstants lame = compute_lame_constants(material);
  std::map<std::array<int, 2>, double> stiffness;
  std::vector<double> volume, bulk;
  for (const auto& corners : solid.tetrahedra) {
    const auto& [a, b, c, d] = corners;
    const Vec3Array& x = solid.vertices;
    const double scale = compute_local_scale(options.stiffness_scale, corners);
    volume.push_back(compute_volume(x[a], x[b], x[c], x[d]));
    // rounding must not make it negative at nu = 1/4
    bulk.push_back(scale * std::max(0.0, lame.lambda - lame.mu));
    for (std::size_t p = 0; p < 4; ++p) {
      model.mass[corners[p]] += 0.25 * material.density * volume.back();
      for (std::size_t q = p + 1; q < 4; ++q) {
        const int i = std::min(corners[p], corners[q]), j = std::max(corners[p], corners[q]);
        stiffness[{i, j}] += 2.5 * scale * lame.mu * volume.back() / (x[i] - x[j]).squaredNorm();
      }
    }
  }
  std::vector<std::array<int, 2>> edges;
  std::vector<double> stiffnesses;
  for (const auto& [ends, k] : stiffness) {
    edges.push_back(ends);
    stiffnesses.push_back(k);
  }
  model.springs = build_edge_links(model, edges, std::move(stiffnesses), material.damping_ratio);
  model.volumes = build_volumes(particle_count(model), solid.tetrahedra, std::move(volume),
                                std::move(bulk), options.nodal_share);
  validate(model);
  return model;
}

}  // namespace palpate

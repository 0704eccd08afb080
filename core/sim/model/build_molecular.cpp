// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/model/definiteness.h"
#include "palpate/sim/model/private/surface_particles.h"

namespace palpate {
namespace {

void check_constants(const MolecularConstants& constants) {
  const bool eq10 = constants.angle_law == AngleLaw::eq10;
  // angles resist no change of size, so nothing can make up for bonds that do not
  if (!(std::isfinite(constants.bond_stiffness) && constants.bond_stiffness > 0.0)) {
    refuse("molecular: bond_stiffness", write_text(constants.bond_stiffness, " N/m"),
           "a positive number");
  }
  if (!std::isfinite(constants.bend_stiffness) || (eq10 && constants.bend_stiffness < 0.0)) {
    refuse("molecular: bend_stiffness", write_text(constants.bend_stiffness, eq10 ? " N" : " J"),
           eq10 ? "0 or a positive number" : "a finite number");
  }
  if (!std::isfinite(constants.stretch_coupling) || (eq10 && constants.stretch_coupling != 0.0)) {
    refuse("molecular: stretch_coupling", write_text(constants.stretch_coupling, " N"),
           eq10 ? "0 under AngleLaw::eq10, which has no stretch-bend force" : "a finite number");
  }
}

/// A row per triangle. Its part of the bond along an edge is half of K_b, local scale included.
Angles build_angles(const SurfaceMesh& mesh, const Topology& topology,
                    const MolecularConstants& constants, const std::vector<double>& scale) {
  Angles angles = build_rest_angles(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<double, 3> share;
    for (int c = 0; c < 3; ++c) {
      const auto& ends = topology.edges[topology.triangle_edges[t][c]];
      share[c] = 0.5 * constants.bond_stiffness * compute_local_scale(scale, ends);
    }
    const double local = compute_local_scale(scale, mesh.triangles[t]);
    const double bend = constants.bend_stiffness * local;
    const double coupling = constants.stretch_coupling * local;
    angles.bend_stiffness.push_back({bend, bend, bend});
    angles.stretch_coupling.push_back({coupling, coupling, coupling});
    angles.bond_share.push_back(share);
  }
  return angles;
}

/// Refuses constants under which a triangle is indefinite, with the K_btheta that all can take.
void check_triangles(const Angles& angles, const MolecularConstants& constants,
                     const std::vector<double>& scale) {
  const auto triangle_count = static_cast<int>(angles.corners.size());
  int first_refused = -1;
  for (int t = 0; t < triangle_count && first_refused < 0; ++t) {
    if (!is_positive_definite(compute_rest_stiffness(angles, t))) first_refused = t;
  }
  if (first_refused < 0) return;

  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CouplingRange all = {-kInfinity, kInfinity};
  int lowest = first_refused, highest = first_refused;
  for (int t = 0; t < triangle_count; ++t) {
    const double local = compute_local_scale(scale, angles.corners[t]);
    const auto range = find_coupling_range(angles, t, {local, local, local});
    if (!range) {
      refuse(write_text("mesh: triangle ", t),
             write_text("a tangent at rest that K_theta ", constants.bend_stiffness,
                        " J makes indefinite at any K_btheta"),
             "a larger K_theta or K_b");
    }
    if (range->low > all.low) all.low = range->low, lowest = t;
    if (range->high < all.high) all.high = range->high, highest = t;
  }
  const double got = constants.stretch_coupling;
  const int worst = got <= all.low ? lowest : got >= all.high ? highest : first_refused;
  if (all.low >= all.high) {
    refuse(
        write_text("mesh: triangles ", lowest, " and ", highest),
        write_text("no K_btheta that both can take with K_theta ", constants.bend_stiffness, " J"),
        "a larger K_theta or K_b");
  }
  refuse(write_text("mesh: triangle ", worst),
         write_text("K_btheta ", got, " N, which makes its tangent at rest indefinite"),
         describe(all) + " on this mesh");
}

}  // namespace

TissueModel build_molecular(const SurfaceMesh& mesh, const Material& material,
                            const MolecularConstants& constants, const SurfaceOptions& options) {
  check_constants(constants);
  TissueModel model = build_surface_particles(mesh, material, options);
  const Topology topology = build_topology(mesh.triangles);
  model.angle_law = constants.angle_law;
  model.angles = build_angles(mesh, topology, constants, options.stiffness_scale);
  if (constants.angle_law == AngleLaw::gradient) {
    check_triangles(model.angles, constants, options.stiffness_scale);
  }
  model.bonds = build_edge_links(model, topology.edges, sum_bond_shares(model.angles, topology),
                                 material.damping_ratio);
  validate(model);
  return model;
}

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/model/build_surface.h"

namespace palpate {

// What the surface models have in common: the particles, and the links along the edges.

/// A model of the surface without links: particles, masses, what is held, home springs, pressure,
/// drag. Throws std::invalid_argument on an invalid mesh, material or option.
TissueModel build_surface_particles(const SurfaceMesh& mesh, const Material& material,
                                    const SurfaceOptions& options);

/// Links of `stiffness` [N/m] along `edges`, at rest where the model's particles are, each damped
/// with `damping_ratio` [-] of what is critical for its two end masses and its stiffness, or for
/// `damped_as` [N/m] in its place, where that is given: a bond alone may be negative.
Links build_edge_links(const TissueModel& model, std::span<const std::array<int, 2>> edges,
                       std::vector<double> stiffness, double damping_ratio,
                       std::span<const double> damped_as = {});

/// A row per triangle with its shape at rest; the constants are still to be filled in.
Angles build_rest_angles(const SurfaceMesh& mesh);

/// [N/m] the stiffness of every bond: what its one or two triangles have of it.
std::vector<double> sum_bond_shares(const Angles& angles, const Topology& topology);

/// Which bonds the triangles carry: those whose every side is at rest at the same length. Their
/// damping is spread evenly over the sides.
struct BondShares {
  std::vector<bool> left;                        ///< bonds that no triangle carries
  std::vector<std::array<double, 3>> stiffness;  ///< [N/m] per row of Angles: of each side
  std::vector<std::array<double, 3>> damping;    ///< [N·s/m] likewise
  std::vector<std::array<int, 3>> bond;          ///< likewise; -1 of one that is left
  std::vector<int> side_count;                   ///< per bond: sides that carry it
};

BondShares share_bonds(const TissueModel& model);

/// The mean of `scale` at the vertices of a link or triangle; 1 where `scale` is empty.
template <std::size_t N>
double compute_local_scale(const std::vector<double>& scale, const std::array<int, N>& vertices) {
  if (scale.empty()) return 1.0;
  double sum = 0.0;
  for (const int vertex : vertices) sum += scale[vertex];
  return sum / N;
}

}  // namespace palpate

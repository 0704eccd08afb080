// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/material.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// What a designer may choose about a solid beside its material.
struct SolidOptions {
  /// [-] 0 to 1: how much of the resistance to a change of volume acts on the mean around each
  /// particle. 0 locks near nu = 0.5; 1 alone lets single tetrahedra turn inside out.
  double nodal_share = 0.9;
  /// [-] per vertex of the solid, positive, 1 everywhere where empty; a tetrahedron takes the mean
  std::vector<double> stiffness_scale = {};
  std::vector<int> fixed = {};  ///< vertices of the solid held at rest, in any order
  double drag = 2.0;            ///< [1/s]
  DampingLaw damping_law = DampingLaw::axis;
};

/// Lamé's constants of a material.
struct LameConstants {
  double lambda = 0.0;  ///< [Pa]
  double mu = 0.0;      ///< [Pa] the shear modulus
};

/// Throws std::invalid_argument for a Poisson's ratio of 0.5, where lambda is infinite.
LameConstants compute_lame_constants(const Material& material);

/// Poisson's ratios that springs and a volume term can stand for: below, the volume term would be
/// negative; above, it stiffens beyond any use.
inline constexpr double kLeastSolidPoisson = 0.25;
inline constexpr double kMostSolidPoisson = 0.49;

/// The mass-spring model of a solid with true volumes ("MSS+V") [laws: solid]: a spring along every
/// edge of the tetrahedra, and what resists a change of volume in each of them. Its surface is the
/// boundary of the tetrahedra. A material of the same E and nu answers small strains alike, on
/// average over the directions that edges have.
/// Throws std::invalid_argument on an invalid solid, material or option, for a material with a
/// wall, and for a Poisson's ratio outside of 0.25 to 0.49.
TissueModel build_solid(const SolidMesh& solid, const Material& material,
                        const SolidOptions& options = {});

/// The linear elastic model of the same solid, for shallow presses: Hooke's law in every
/// tetrahedron, no links. Strain follows stress in the time in which a shear wave passes an edge,
/// times 2 damping_ratio. Drag and damping law of the options have no part in it.
/// Throws as build_solid does.
TissueModel build_linear_solid(const SolidMesh& solid, const Material& material,
                               const SolidOptions& options = {});

/// Solids of the same body whose tetrahedra may be strained and turned far: of corotated linear
/// elasticity [laws: corotated], and of the stable neo-Hookean law [laws: neo-hookean]. No links.
/// Tetrahedra have the viscosity that the links of build_solid would give them [laws: viscosity];
/// the damping law of the options has no part in it. Throw as build_solid does.
TissueModel build_corotated_solid(const SolidMesh& solid, const Material& material,
                                  const SolidOptions& options = {});
TissueModel build_neo_hookean_solid(const SolidMesh& solid, const Material& material,
                                    const SolidOptions& options = {});

/// The same linear solid for pushes on these vertices of its surface alone, in any order: the
/// precomputed response has room for no others (response.h), and elsewhere it does not give.
/// Throws std::invalid_argument for another model, no vertices, or one that is not there.
TissueModel limit_reach(TissueModel model, const std::vector<int>& surface_vertices);

/// The skin by which `surface` rides on the tetrahedra of a solid: each vertex in the one that it
/// lies in, or outside of all of them in the nearest.
Skin build_skin(const SurfaceMesh& surface, const SolidMesh& solid);

/// The same solid under a finer surface, which is what is touched and seen. Throws
/// std::invalid_argument on an invalid surface, and where it lies so far from the tetrahedra that
/// these say nothing about it.
TissueModel cover_with_skin(TissueModel model, const SurfaceMesh& surface);

}  // namespace palpate

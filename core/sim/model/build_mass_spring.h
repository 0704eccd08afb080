// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "palpate/sim/mesh/surface_mesh.h"
#include "palpate/sim/model/material.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// What a designer may choose about a surface model beside its material. Scales multiply the
/// stiffness locally, home springs included, and are empty for 1 everywhere.
struct SurfaceOptions {
  std::optional<double> home_stiffness = {};  ///< [N/m³] per area; none for the default below
  /// [-] per vertex, positive; a link takes the mean of its ends, a triangle that of its corners
  std::vector<double> stiffness_scale = {};
  std::vector<int> fixed = {};  ///< vertices held at rest, in any order
  double pressure = 0.0;        ///< [Pa]
  double drag = 2.0;            ///< [1/s]
  DampingLaw damping_law = DampingLaw::axis;
};

/// [N/m³] home stiffness when none is given. 0 for a solid (no wall thickness). For hollow organs
/// and sheets, which have no stiffness out of their plane, E h / d² with d a tenth of the bounding
/// box's diagonal: a dent then fades over the length d.
double default_home_stiffness(const SurfaceMesh& mesh, const Material& material);

/// [kg] per vertex, lumped by area: density x volume for a closed solid, density x wall
/// thickness x area for hollow organs and open surfaces.
/// Throws std::invalid_argument for an open surface without a wall thickness.
std::vector<double> compute_lumped_mass(const SurfaceMesh& mesh, const Material& material);

/// [N/m] of the springs that make a surface stretch like a membrane of the material and its wall
/// thickness. Throws std::invalid_argument without one.
double membrane_spring_stiffness(const Material& material);

/// The mass-spring model of a surface: one spring of `stiffness` [N/m] (Eq 1) along every edge.
/// Damping of each spring is 2 zeta sqrt(k m_i m_j / (m_i + m_j)).
/// Throws std::invalid_argument on an invalid mesh, material or option.
TissueModel build_mass_spring(const SurfaceMesh& mesh, const Material& material, double stiffness,
                              const SurfaceOptions& options = {});

}  // namespace palpate

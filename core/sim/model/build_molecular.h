// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/build_mass_spring.h"

namespace palpate {

/// Constants of the molecular model, the same at every bond and corner (Eq 8, 9, 11).
struct MolecularConstants {
  double bond_stiffness = 50.0;   ///< [N/m] K_b of a bond inside the surface; half at its border
  double bend_stiffness = 0.0;    ///< [J] K_theta per corner; [N] under AngleLaw::eq10
  double stretch_coupling = 0.0;  ///< [N] K_btheta per corner; may be negative, 0 under eq10
  AngleLaw angle_law = AngleLaw::gradient;
};

/// The molecular model of a surface: a bond along every edge, an angle and a stretch-bend term at
/// every triangle corner. Throws std::invalid_argument as build_mass_spring does, and where the
/// constants make a triangle indefinite, naming it and the admissible range of K_btheta.
TissueModel build_molecular(const SurfaceMesh& mesh, const Material& material,
                            const MolecularConstants& constants,
                            const SurfaceOptions& options = {});

}  // namespace palpate

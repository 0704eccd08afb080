// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/build_molecular.h"

namespace palpate {

// Surface models whose constants come from the material: Young's modulus, Poisson's ratio and the
// thickness of the wall. Where `stiffness_scale` differs from 1, Young's modulus is scaled.

/// How a spring's constant follows from the two triangles at it. Springs have one constant per
/// side and cannot be a membrane in every strain; compare_with_membrane says what that leaves.
enum class SpringRule {
  van_gelder,  ///< k = E h sum A/L² [VanGelder98]
  lloyd,       ///< nearest to the finite element's stiffness matrix, in squares [Lloyd07]
};

/// The mass-spring model of a wall of `material`. Throws std::invalid_argument as
/// build_mass_spring does, without a wall thickness, and for triangles below kSmallestAngle.
TissueModel build_membrane_springs(const SurfaceMesh& mesh, const Material& material,
                                   SpringRule rule = SpringRule::van_gelder,
                                   const SurfaceOptions& options = {});

/// The molecular model of a wall of `material`. Under AngleLaw::gradient each triangle is, at
/// rest, exactly the plane-stress finite element, whatever the K_theta `bend_stiffness` [J] is;
/// bonds may then be negative where the triangle is definite as a whole. AngleLaw::eq10 has no
/// stretch-bend: its constants in [N] come nearest to that in squares, are exact in equilateral
/// triangles, and allow no bend_stiffness of one's own. Throws as build_membrane_springs.
TissueModel build_membrane_molecular(const SurfaceMesh& mesh, const Material& material,
                                     double bend_stiffness = 0.0,
                                     AngleLaw angle_law = AngleLaw::gradient,
                                     const SurfaceOptions& options = {});

/// The constants of Eq 10 nearest to those of `angles` under AngleLaw::gradient, row by row, in
/// the sum of squares of the stiffness at rest, among those under which no triangle gives way. In
/// an equilateral triangle without stretch-bend K10 = 1.5 K_theta/l, and nothing is lost.
Angles convert_to_eq10(const Angles& angles);

/// [-] per row: how far convert_to_eq10 is from `angles`, |S_eq10 - S| / |S| of the slopes at rest.
std::vector<double> compute_eq10_residuals(const Angles& angles);

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "palpate/sim/mesh/mesh.h"
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

/// A wall of triangular prisms, which stretches and bends as its material does.
///
/// Vertex i of the surface is particle i, on the outer face; particle n + i lies below it on the
/// inner face, h/sqrt(3) away along the vertex normal. Each face is an exact membrane of half the
/// wall (build_membrane_molecular), so that at that distance the two have the stretching stiffness
/// of the wall and its bending stiffness E h³/(12 (1 - nu²)) as well; springs of E A/h keep them
/// apart, and prisms pass the shear between them. No home springs unless they are asked for.
/// Throws std::invalid_argument as build_membrane_molecular does, and where the wall is too thick
/// for the surface: a triangle of the inner face would be turned over or lost.
TissueModel build_shell(const SurfaceMesh& mesh, const Material& material,
                        const SurfaceOptions& options = {});

}  // namespace palpate

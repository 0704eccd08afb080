// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/material.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

// A wall under plane stress, which surface models are measured against: the linear triangle of
// finite elements, told in the lengths of its sides [laws: membrane].

/// [degree] A triangle with a smaller angle has no constants: it is refused.
inline constexpr double kSmallestAngle = 0.05;

/// [N/m] (3, 3) for every triangle: the second derivative of its energy, as a wall of `material`,
/// in the lengths of its three sides, side c opposite corner c. With lambda = E nu/(1 - nu²) and
/// mu = E/(2 (1 + nu)), H_ij = (h L_i L_j/4A) ((lambda + 2 mu) cot_i cot_j + mu (2 delta_ij - 1)).
/// Throws std::invalid_argument without a wall thickness and for a triangle below kSmallestAngle.
std::vector<Mat3> compute_membrane_stiffnesses(const SurfaceMesh& mesh, const Material& material);

/// How a surface model at rest compares with a membrane of its material.
struct MembraneFit {
  double young_modulus = 0.0;  ///< [Pa] of the isotropic membrane nearest to the model as a whole
  double poisson_ratio = 0.0;  ///< [-] of the same
  double least = 0.0;          ///< [-] of the material's stiffness, in the softest strain anywhere
  double most = 0.0;           ///< [-] in the stiffest
  double error = 0.0;          ///< [-] root mean square over area of |C_model - C| / |C|
  int worst_triangle = -1;     ///< where |C_model - C| is largest
};

/// Measures springs, bonds, angles and stretch-bend terms of `model` against a membrane of
/// `material`, whose modulus `stiffness_scale`, empty or one per particle, multiplies locally. A
/// spring belongs in equal parts to the triangles at it. Throws std::invalid_argument as
/// compute_membrane_stiffnesses does, and for a model without triangles.
MembraneFit compare_with_membrane(const TissueModel& model, const Material& material,
                                  const std::vector<double>& stiffness_scale = {});

/// One line for people: "like E = 4.98 kPa, nu = 0.333; 0.81 to 1.45 times the material's ...".
std::string describe(const MembraneFit& fit);

}  // namespace palpate

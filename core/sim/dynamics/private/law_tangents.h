// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/tangent.h"

// What each law adds to K = -df/dx [N/m] at positions x and no velocity, and to C = -df/dv
// [N·s/m], both (3n, 3n). Rows and columns of fixed particles are zero, and the pattern is the same
// for all positions.

namespace palpate {

/// Springs, bonds, angles and stretch-bend, and `home` springs where they are asked for.
Eigen::SparseMatrix<double> compute_side_stiffness(const TissueModel& model,
                                                   std::span<const Vec3> x, Projection projection,
                                                   bool home);

Eigen::SparseMatrix<double> compute_prism_stiffness(const TissueModel& model,
                                                    std::span<const Vec3> x, Projection projection);
Eigen::SparseMatrix<double> compute_prism_damping(const TissueModel& model,
                                                  std::span<const Vec3> x);

/// Projected, the curvature of the law is clamped at 0 and the part that the turning of faces adds
/// is left out: what remains is positive semidefinite.
Eigen::SparseMatrix<double> compute_volume_stiffness(const TissueModel& model,
                                                     std::span<const Vec3> x,
                                                     Projection projection);

/// Of a linear solid, the same at all positions; damping is damping_time times as much.
Eigen::SparseMatrix<double> compute_elastic_stiffness(const TissueModel& model);

/// Projected, the negative eigenvalues of d²W/dF² of each tetrahedron, with what the means around
/// its particles add, are clamped at 0: what remains is positive semidefinite.
Eigen::SparseMatrix<double> compute_corotated_stiffness(const TissueModel& model,
                                                        std::span<const Vec3> x,
                                                        Projection projection);
Eigen::SparseMatrix<double> compute_neo_hookean_stiffness(const TissueModel& model,
                                                          std::span<const Vec3> x,
                                                          Projection projection);
/// The viscosity of one of their tables.
Eigen::SparseMatrix<double> compute_viscous_damping(const TissueModel& model,
                                                    const Hyperelastic& table,
                                                    std::span<const Vec3> x);

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCore>
#include <span>

#include "palpate/sim/dynamics/state.h"

namespace palpate {

enum class Projection {
  none,                   ///< the exact derivative; not symmetric under AngleLaw::eq10
  positive_semidefinite,  ///< tensions and 3x3 length Hessians clamped at 0 [laws: tension];
                          ///< under AngleLaw::eq10 the Hessian of the equivalent angle energy
};

/// K = -df/dx at positions x and zero velocity [N/m], (3n, 3n), springs, bonds, angles, prisms,
/// volumes, solids of every law and home; pressure and pushes are left out. Rows and columns of
/// fixed particles are zero.
Eigen::SparseMatrix<double> compute_stiffness(const TissueModel& model, std::span<const Vec3> x,
                                              Projection projection);

/// C = -df/dv at positions x [N·s/m], (3n, 3n), links, prisms, solids and drag. Fixed as
/// above.
Eigen::SparseMatrix<double> compute_damping(const TissueModel& model, std::span<const Vec3> x);

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/tangent.h"

namespace palpate {

// The part of the tangent that the table of prisms adds.

/// K = -df/dx [N/m], (3n, 3n). Rows and columns of fixed particles are zero.
Eigen::SparseMatrix<double> compute_prism_stiffness(const TissueModel& model,
                                                    std::span<const Vec3> x, Projection projection);

/// C = -df/dv [N·s/m], as above.
Eigen::SparseMatrix<double> compute_prism_damping(const TissueModel& model,
                                                  std::span<const Vec3> x);

}  // namespace palpate

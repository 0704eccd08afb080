// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCore>

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

// The part of the tangent that the table of a linear solid adds, the same at all positions.

/// K = -df/dx [N/m], (3n, 3n); damping is damping_time times as much. Rows and columns of fixed
/// particles are zero.
Eigen::SparseMatrix<double> compute_elastic_stiffness(const TissueModel& model);

}  // namespace palpate

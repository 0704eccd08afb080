// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCore>

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// The matrix of projective dynamics for steps of dt [s]: n x n, the same for each axis,
///
///     A = (1 + dt d) M/dt² + sum of w G Gᵀ   [N/m]
///
/// where w bounds the curvature of each law's energy at rest, in every direction, so that A does
/// not depend on how the tissue lies [laws: projective]. Rows of held particles are those of 1.
Eigen::SparseMatrix<double> compute_projective_matrix(const TissueModel& model, double dt);

}  // namespace palpate

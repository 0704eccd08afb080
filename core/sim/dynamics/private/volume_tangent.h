// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/tangent.h"

namespace palpate {

/// What the volumes add to K = -df/dx at positions x [N/m], (3n, 3n), fixed particles left out. The
/// pattern is the same for all positions. Projected, the curvature of the law is clamped at 0 and
/// the part that the turning of faces adds is left out: what remains is positive semidefinite.
Eigen::SparseMatrix<double> compute_volume_stiffness(const TissueModel& model,
                                                     std::span<const Vec3> x,
                                                     Projection projection);

}  // namespace palpate

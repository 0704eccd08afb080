// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/tangent.h"

namespace palpate {

/// The part of compute_stiffness() that springs, bonds, angles and stretch-bend have in it, and
/// `home` springs where they are asked for.
Eigen::SparseMatrix<double> compute_side_stiffness(const TissueModel& model,
                                                   std::span<const Vec3> x, Projection projection,
                                                   bool home);

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "palpate/sim/model/load.h"
#include "palpate/sim/model/private/cut_out.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

// How a deformed tissue gives way at one place, from the particles around it alone.

/// [m/N] Symmetric, (k, k): how far points of the surface at positions x [m] move along their
/// directions under 1 N along each other's. A point is a push, whose force is its direction, unit.
/// The `most` particles nearest to the middle of the points move, all others are held: of a solid
/// that leaves out about a / R of the compliance of a patch of radius a, R the radius of what was
/// cut out [stability: local compliance]. None where the tissue cannot be solved for.
std::optional<Eigen::MatrixXd> compute_local_compliance(const TissueModel& model,
                                                        std::span<const Vec3> x,
                                                        std::span<const Push> along, int most);

}  // namespace palpate

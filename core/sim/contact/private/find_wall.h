// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "palpate/sim/contact/private/wall_layer.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// The wall that the prisms of a model make, with this modulus [Pa] E*; of a solid a thickness of
/// 0.
WallLayer find_wall(const TissueModel& model, const SurfaceMesh& surface, double modulus);

/// [Pa/m] per vertex, what holds a wall as a whole: its bends, home springs, and where it is fixed.
std::vector<double> find_foundations(const TissueModel& model, const SurfaceMesh& surface,
                                     const Vec3Array& normals, const WallLayer& wall);

}  // namespace palpate

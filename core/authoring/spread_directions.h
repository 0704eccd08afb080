// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// Directions of unit length, spread evenly over the sphere; the same ones every time.
Vec3Array spread_directions(int count);

}  // namespace palpate::authoring

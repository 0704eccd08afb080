// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// Smooths a surface without shrinking it: `steps` pairs of a step that smooths and one that takes
/// back what shrank [Taubin95]; then every vertex moves along its normal by the one length that
/// gives a closed surface its volume again. Border vertices stay. Throws std::invalid_argument for
/// a surface that does not pass validate(), or fewer than one step.
SurfaceMesh smooth_surface(const SurfaceMesh& mesh, int steps);

}  // namespace palpate::authoring

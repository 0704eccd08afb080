// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/build_mass_spring.h"

namespace palpate {

/// A wall of triangular prisms, which stretches and bends as its material does.
///
/// Vertex i of the surface is particle i, on the outer face; particle n + i lies below it on the
/// inner face, h/sqrt(3) away along the vertex normal. Each face is an exact membrane of half the
/// wall (build_membrane_molecular), so that at that distance the two have the stretching stiffness
/// of the wall and its bending stiffness E h³/(12 (1 - nu²)) as well; springs of E A/h keep them
/// apart, and prisms pass the shear between them. No home springs unless they are asked for.
/// Throws std::invalid_argument as build_membrane_molecular does, and where the wall is too thick
/// for the surface: a triangle of the inner face would be turned over or lost.
TissueModel build_shell(const SurfaceMesh& mesh, const Material& material,
                        const SurfaceOptions& options = {});

}  // namespace palpate

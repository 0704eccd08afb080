// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// Triangles of a shell that are looked from at most, spread evenly over its list.
inline constexpr int kExposureLooks = 64;
/// Directions of each look, spread evenly over the sphere.
inline constexpr int kDirections = 32;
/// A triangle is seen from outside where so many of them, an eighth, meet nothing: through the
/// mouth of a vessel or of a chamber fewer do.
inline constexpr int kLeastFree = 4;

/// [-] The part of each shell's triangles that are seen from outside past all others, in the order
/// of find_shells(). Any triangles will do that are finite; they may cross.
std::vector<double> measure_exposure(const SurfaceMesh& mesh);

}  // namespace palpate::authoring

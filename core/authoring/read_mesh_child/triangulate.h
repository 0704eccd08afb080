// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "palpate/sim/base/types.h"

namespace palpate::authoring {

/// Appends the triangles of a polygon with these corners: ears are cut off in the plane of its
/// vector area, so that a hollow polygon keeps its shape; what cannot be cut so is fanned out. A
/// corner that follows itself is passed over; fewer than three different ones give nothing.
void triangulate_polygon(std::span<const int> corners, const Vec3Array& vertices,
                         std::vector<Triangle>& triangles);

}  // namespace palpate::authoring

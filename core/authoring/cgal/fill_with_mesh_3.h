// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// [m] How large cells may be.
struct CellSize {
  double largest;  ///< [m] anywhere
  /// [m] Where they are smaller: asked with a point, gives at most `largest`. None: nowhere.
  std::function<double(const Vec3&)> near = nullptr;
};

/// Asked with how many cells a size gives, before they are improved: whether they shall be, which
/// takes twice as long again.
using Accepts = std::function<bool(std::size_t)>;

/// What CGAL's Mesh_3 makes of a surface that must be closed, manifold, outward and free of
/// crossings: an open one would take the process down. Without tetrahedra where `accepts` says no.
SolidMesh fill_with_mesh_3(const SurfaceMesh& surface, const CellSize& size,
                           const Accepts& accepts = nullptr);

}  // namespace palpate::authoring

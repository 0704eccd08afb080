// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "palpate/sim/collision/private/surface_contacts.h"

namespace palpate {

/// The middles of the long edges of a surface, kept from the triangles of another as its vertices
/// are: an edge is long where vertices alone would let it go deep into a ridge [contact: bodies].
struct EdgePoints {
  EdgePoints() = default;
  /// Of edges that are longer at rest than kLongEdge times the thickness of the barrier.
  EdgePoints(const SurfaceMesh& edges, const SurfaceMesh& triangles, const Barrier& barrier);

  std::vector<std::array<int, 2>> ends;  ///< vertices; never change
  SurfaceContacts contacts;              ///< of the middles, with a quarter of the triangles beside
  Vec3Array x;                           ///< [m] (follow, follow_active)
  Vec3Array before;                      ///< [m] (follow)
};

/// [-] Of the thickness of a barrier: edges that are longer have a contact in their middle. An edge
/// of length l between vertices that keep the thickness tau from a ridge of radius r may go
/// l²/(8 r) - tau into it.
inline constexpr double kLongEdge = 10.0;

/// Puts all middles between the vertices at x [m], and where these were before.
void follow(std::span<const Vec3> x, std::span<const Vec3> before, EdgePoints& points) noexcept;

/// Likewise those that may touch.
void follow_active(std::span<const Vec3> x, EdgePoints& points) noexcept;

}  // namespace palpate

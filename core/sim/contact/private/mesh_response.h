// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {

// What a mesh has done of a dent already, where several triangles or several instruments press it.

/// What a mesh does at one patch under another, or under the same.
struct MeshResponse {
  double compliance = 0.0;   ///< [m/N] vᵀ G w: weights of each corner are its part of the force
  double known = 0.0;        ///< [-] how much of it G has, 0 to 1
  Vec3 tilt = Vec3::Zero();  ///< [1/N] how the sinking of corners turns the normal
};

/// At what one instrument touches, under what another does, or the same one.
MeshResponse compute_response(const TouchedSurface& surface, const NearContacts& other,
                              NearContacts& contacts) noexcept;

/// Writes contacts.cross, for the others of the surface.
void find_crossings(const Tool& tool, const TouchedSurface& surface,
                    NearContacts& contacts) noexcept;

/// [m] What the mesh has left of the sinking under other instruments.
double sum_crossings(const TouchedSurface& surface, const NearContacts& contacts) noexcept;

/// The contact of a triangle that is tilted by `tilt` [-], for a ball at p, or axes about it.
Contact level(const TouchedSurface& surface, const Vec3& tilt, const Axes& axes, const Vec3& p,
              int triangle, const Contact& soft) noexcept;

}  // namespace palpate

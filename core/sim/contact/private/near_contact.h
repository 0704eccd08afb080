// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {

/// Part of the radius that a tool's own steps keep its centre off the surface: halving what is left
/// would end in rounding, on the wrong side.
inline constexpr double kClearance = 1e-3;

// Contacts under a NearField: closest points give the barrier, footprints the pressure, and the
// whole patch how much of the dent the mesh has taken already.

/// Along a unit vector, n . t n.
inline double compute_along(const Symmetric& t, const Vec3& n) noexcept {
  return t[0] * n.x() * n.x() + t[1] * n.y() * n.y() + t[2] * n.z() * n.z() +
         2.0 * (t[3] * n.x() * n.y() + t[4] * n.y() * n.z() + t[5] * n.z() * n.x());
}

/// The near field beside the mesh: what the pressures of one body are multiplied by.
struct NearGain {
  double force = 1.0;
  double slope = 1.0;
  double local_slope = 0.0;  ///< [N/m] of the half space at the depth that it is pressed
};

/// [m] The lift of a tool that has last been balanced where it is; of one that has been put
/// elsewhere since, none.
inline Vec3 find_lift(const NearContacts& contacts, const Vec3& position) noexcept {
  return contacts.centre == position + contacts.lift ? contacts.lift : Vec3(Vec3::Zero());
}

/// Takes up the closest contacts of a surface under a near field, which the caller has filled, and
/// writes its contacts for the lifted centre p, and the lift that the next substep is to have.
void find_near_contacts(const Shape& shape, const TouchedSurface& surface, const Vec3& p) noexcept;

/// The contact of one triangle with pressures as they are, from its front or, `side` -1, behind.
bool find_near_contact(const NearField& near, const Shape& shape, const Contact& closest,
                       const Vec3& p, double side, const Vec3& a, const Vec3& b, const Vec3& c,
                       NearGain gain, Contact& contact) noexcept;

/// [N/m] Up to what the slope of a contact may grow within a tick: in the barrier that of the hard
/// law, whose part rises with depth.
double bound_slope(const Tool& tool, const Contact& closest, const Contact& contact) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/contact_law.h"

namespace palpate {

// Contacts under a NearField: closest points give the barrier, footprints the pressure, and the
// whole patch how much of the dent the mesh has taken already.

/// The near field beside the mesh: what the pressures of one body are multiplied by.
struct NearGain {
  double force = 1.0;
  double slope = 1.0;
};

/// What is felt of a press `depth` [m] deep into triangles where they are now, of a ball of
/// `radius` [m]: F(s) where s - dC F(s) = depth. dC [m/N] is the compliance of the mesh under the
/// patch that tissue does not have; `curvature` [1/m] is the tissue's.
struct LocalPress {
  double modulus = 0.0;          ///< [Pa] E*
  double radius = 0.0;           ///< [m]
  double curvature = 0.0;        ///< [1/m]
  double mesh_compliance = 0.0;  ///< [m/N] dC

  /// [N] on the half space, and [N/m] its slope, at s [m].
  double compute_force(double s) const noexcept;
  double compute_slope(double s) const noexcept;
  /// [m] s, where the ball cuts triangles on `area` [m²] in all. dC is that of the patch as it is,
  /// and goes as one over its radius.
  double find_depth(double depth, double area) const noexcept;
};

/// Takes up contacts->closest, which the caller has filled, and writes contacts->contact for the
/// centre p.
void find_near_contacts(const NearField& near, const Tool& tool,
                        std::span<const Triangle> triangles, std::span<const Vec3> x, const Vec3& p,
                        NearContacts& contacts) noexcept;

/// The contact of one triangle with pressures as they are.
bool find_near_contact(const NearField& near, const Tool& tool, const Contact& closest,
                       const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, NearGain gain,
                       Contact& contact) noexcept;

/// [N/m] Up to what the slope of a contact may grow within a tick: in the barrier that of the hard
/// law, whose part rises with depth.
double bound_slope(const Tool& tool, const Contact& closest, const Contact& contact) noexcept;

}  // namespace palpate

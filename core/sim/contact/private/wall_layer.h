// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate {

// What a wall does under a ball, and what prisms and triangles do of that [contact: walls].

/// An elastic layer whose lower face is free, on what holds the wall as a whole.
struct WallLayer {
  double modulus = 0.0;    ///< [Pa] E* = E / (1 - nu²)
  double young = 0.0;      ///< [Pa] E
  double thickness = 0.0;  ///< [m]
  double unlocked = 1.0;   ///< [-] of its shear stiffness what the prisms have
};

/// [m/N] The mean displacement under a pressure of 1 N in all on a wall of prisms, over which two
/// points are `spread` [m²] apart, on the mean of squares. `foundation` [Pa/m] is what holds the
/// wall: E h/R² of a sphere, home springs, its ends.
double compute_prism_compliance(const WallLayer& wall, double spread, double foundation);

/// [m/N] What tissue gives way at a point beyond a half space: finite, as only the half space is
/// singular there.
double compute_point_excess(const WallLayer& wall, double foundation);

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "palpate/sim/contact/tool.h"

namespace palpate {

/// What a ball or a capsule does to the part of one triangle under it: sums over that part of the
/// pressure of the near field [contact: near field].
struct Footprint {
  double normal_force = 0.0;    ///< [N] along the triangle's normal
  double whole_force = 0.0;     ///< [N] that of a whole plane
  Vec3 normal = Vec3::Zero();   ///< unit, of the triangle
  Vec3 force = Vec3::Zero();    ///< [N] on the tool, each part along the tool's normal
  Vec3 weights = Vec3::Zero();  ///< barycentric, of the centre of pressure
  double stiffness = 0.0;       ///< [N/m] d normal_force / d depth
  double area = 0.0;            ///< [m²]
  double depth = 0.0;           ///< [m] of the tool's lowest point below the triangle's plane
  Vec3 axis = Vec3::Zero();  ///< [m] the point of a capsule's axis above the pressures, their mean
  double spread = 0.0;       ///< [m²] variance of those points along the axis
};

/// b1 and b2 of NearPressure, of the large-depth law, fitted to neo-Hookean solutions
/// [contact: near field].
inline constexpr double kFirstOfPressure = 0.548, kSecondOfPressure = 0.055;

/// The pressure p [Pa] of a ball of radius R [m] where it overlaps tissue by o [m]:
///
///     p = min(k_A o, E*/pi sqrt(x) (1 + b1 x + b2 x²)),   x = o / R
///
/// so that a flat half space that stands still feels Hertz's force at small depth, and at depths up
/// to 2 R that of a neo-Hookean one (Poisson's ratio 0.45) within 3 %. Never stiffer than the hard
/// law's k_A.
struct NearPressure {
  double modulus = 0.0;    ///< [Pa] E* = E / (1 - nu²)
  double radius = 0.0;     ///< [m]
  double stiffness = 0.0;  ///< [N/m³] k_A

  double pressure(double overlap) const noexcept;
  double slope(double overlap) const noexcept;  ///< [N/m³]
};

/// Integrates over the part of a triangle that lies inside the circle which the ball cuts out of
/// its plane; false where there is none, or the centre is not above the plane.
bool integrate_footprint(const NearPressure& law, const Vec3& centre, const Vec3& a, const Vec3& b,
                         const Vec3& c, Footprint& footprint) noexcept;

struct Strip;
struct Slices;
struct SliceSums;

/// A triangle in its plane, along a capsule's axis and beside it [m].
using Corners = std::array<std::array<double, 2>, 3>;

/// Sums over the slices of a footprint that lie inside the triangle (capsule_slices.h).
using SumSlices = void (*)(const Strip& strip, const Corners& corners, Slices& slices,
                           SliceSums& sums) noexcept;

/// The same under a capsule whose axis goes from `from` to `to` [m]: what of it lies above the
/// plane counts. `sum` is vector code, or null. Without `whole` the force on a whole plane, which
/// costs as much again, is left at that on the triangle.
bool integrate_capsule_footprint(const NearPressure& law, const Vec3& from, const Vec3& to,
                                 const Vec3& a, const Vec3& b, const Vec3& c, Footprint& footprint,
                                 bool whole = true, SumSlices sum = nullptr) noexcept;

/// [N] The whole_force alone: of pressures on the triangle's plane, were it as wide as they are.
double integrate_capsule_plane(const NearPressure& law, const Vec3& from, const Vec3& to,
                               const Vec3& a, const Vec3& b, const Vec3& c,
                               SumSlices sum = nullptr) noexcept;

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace palpate {

// The near field of one ball or capsule: a press of a half space, of which a mesh has taken a part.

/// The part of a dent that a mesh is taken to have left. One as soft as tissue leaves a fifth; one
/// that leaves less is too soft itself, and no contact makes up for that.
inline constexpr double kLeastLeft = 0.15, kMostLeft = 1.6;

/// [m²] What a ball cuts out of a plane, over pi.
inline double measure_cut(double radius, double depth) noexcept {
  const double in = std::clamp(depth, 0.0, radius);
  return in * (2.0 * radius - in);
}

/// [m²] What a capsule `length` [m] long cuts out of a plane along it, over pi.
double measure_cut(double radius, double length, double depth) noexcept;

/// What is felt of a press `depth` [m] deep into triangles where they are now, of a ball of
/// `radius` [m], or of a capsule that is pressed on a length: F(s) where s - dC F(s) = depth. dC
/// [m/N] is the compliance of the mesh under the patch that tissue does not have; `curvature` [1/m]
/// is the tissue's.
struct LocalPress {
  double modulus = 0.0;          ///< [Pa] E*
  double radius = 0.0;           ///< [m]
  double curvature = 0.0;        ///< [1/m]
  double mesh_compliance = 0.0;  ///< [m/N] dC
  double length = 0.0;           ///< [m] of the axis above the pressures, 0 of a ball

  /// [N] on the half space, and [N/m] its slope, at s [m].
  double compute_force(double s) const noexcept;
  double compute_slope(double s) const noexcept;
  /// [m] s, where the ball cuts triangles on `area` [m²] in all. dC is that of the patch as it is,
  /// and goes as one over its radius.
  double find_depth(double depth, double area) const noexcept;
  /// [m] s, where the mesh has left the tissue to give way by `more` [m/N]: s + more F(s) = depth.
  double find_depth_on(double depth, double more) const noexcept;

 private:
  double compute_line(double s) const noexcept;
  double compute_line_slope(double s) const noexcept;
};

}  // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/contact/tool.h"

namespace palpate {

/// The contact law is a barrier: 1 - depth/radius, down to this. 0.1 lets nothing
/// through, 0.2 already leaks, and less only asks for more substeps [contact: law].
inline constexpr double kBarrierFloor = 0.1;

/// Part of the radius below which the arm from the closest point to the centre is rounding, and
/// its direction noise.
inline constexpr double kNoArm = 1e-9;

/// Cosine between arm and normal from which a contact counts in full.
inline constexpr double kFullFacing = 0.25;

/// How the tip touches one triangle.
struct Contact {
  Vec3 weights = Vec3::Zero();    ///< barycentric, of the closest point
  Vec3 direction = Vec3::Zero();  ///< unit, from the closest point to the tool's centre
  double distance = 0.0;          ///< [m] between the two
  double force = 0.0;             ///< [N] along direction on the tool, against it on the tissue
  double stiffness = 0.0;         ///< [N/m] d force / d depth
};
static_assert(sizeof(Contact) == 72 && alignof(Contact) == 8);

/// The contact of a tip at `centre` with the triangle a, b, c of `rest_area` [m²]; false where
/// there is none, or where the centre lies behind the triangle.
bool find_contact(const Tool& tool, double rest_area, const Vec3& centre, const Vec3& a,
                  const Vec3& b, const Vec3& c, Contact& contact) noexcept;

/// [m] The point of a triangle with these barycentric weights.
inline Vec3 compute_point(const Triangle& t, const Vec3& weights,
                          std::span<const Vec3> x) noexcept {
  return weights[0] * x[static_cast<std::size_t>(t[0])] +
         weights[1] * x[static_cast<std::size_t>(t[1])] +
         weights[2] * x[static_cast<std::size_t>(t[2])];
}

}  // namespace palpate
